// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/YamlDocument.h"

#include <sstream>

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>

#include "scenario/Scenario.h"

namespace narrows
{
namespace
{
/// Remembers where the last document began.
class DocumentStarts : public YAML::EventHandler
{
public:
    int line() const { return line_; }

    void OnDocumentStart(const YAML::Mark &mark) override { line_ = mark.line + 1; }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark &, YAML::anchor_t) override {}
    void OnAlias(const YAML::Mark &, YAML::anchor_t) override {}
    void OnScalar(const YAML::Mark &, const std::string &, YAML::anchor_t, const std::string &) override {}
    void OnSequenceStart(const YAML::Mark &, const std::string &, YAML::anchor_t, YAML::EmitterStyle::value) override {}
    void OnSequenceEnd() override {}
    void OnMapStart(const YAML::Mark &, const std::string &, YAML::anchor_t, YAML::EmitterStyle::value) override {}
    void OnMapEnd() override {}

private:
    int line_ = 0;
};

/// 1-based line where a second document begins, or something that yaml-cpp takes for one; 0 if there is none. Not by
/// YAML::LoadAll, which never ends on a text that begins with a comma.
int lineOfSecondDocument(const std::string &text)
{
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    DocumentStarts starts;
    return parser.HandleNextDocument(starts) && parser.HandleNextDocument(starts) ? starts.line() : 0;
}
}  // namespace

YAML::Node parseYaml(const std::string &text, const std::string &file)
{
    try
    {
        YAML::Node document = YAML::Load(text);
        const int second = lineOfSecondDocument(text);
        if (second == 0)
            return document;
        throw InputError(
            {{file, second, "", "is not one YAML document: a second one, or something out of place, begins"}});
    }
    catch (const YAML::DeepRecursion &error)
    {
        throw InputError({{file, error.mark.line + 1, "", "is not valid YAML: nested too deeply"}});
    }
    catch (const YAML::Exception &error)
    {
        throw InputError({{file, error.mark.line + 1, "", "is not valid YAML: " + error.msg}});
    }
}
}  // namespace narrows
