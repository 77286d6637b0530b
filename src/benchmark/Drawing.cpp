// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Drawing.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <unistd.h>

#include "benchmark/BuildInfo.h"
#include "benchmark/Subprocess.h"

namespace narrows
{
namespace
{
/// A file that is gone when this is.
class TemporaryFile
{
public:
    explicit TemporaryFile(const std::string &content)
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "narrows-record-XXXXXX").string();
        const int descriptor = mkstemp(pattern.data());
        if (descriptor < 0)
            throw std::runtime_error("cannot make a temporary file: " + std::string(std::strerror(errno)));
        close(descriptor);
        path_ = pattern;
        std::ofstream(path_) << content;
    }
    ~TemporaryFile()
    {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    const std::string &path() const { return path_; }

private:
    std::string path_;
};

std::string findScript(const std::string &name)
{
    for (const char *folder : {build::sourceFolder, build::shareFolder})
    {
        const auto script = std::filesystem::path(folder) / "analysis" / name;
        if (std::filesystem::exists(script))
            return script.string();
    }
    throw std::runtime_error("this needs analysis/" + name + ", which is neither in the sources nor installed");
}

/// The first on the path, or else the system's, whose packages another one on the path may lack.
/// \param modules that it must have, of Debian packages named after them
std::string findPython(const std::vector<std::string> &modules)
{
    std::string code = "import yaml";
    std::string packages = "python3-yaml";
    for (const std::string &module : modules)
    {
        code += ", " + module;
        packages += ", python3-" + module;
    }
    for (const char *python : {"python3", "/usr/bin/python3"})
        if (runProgram({python, "-c", code}, true) == 0)
            return python;
    throw std::runtime_error("this needs python3 with packages that are missing; on Debian: " + packages);
}

const std::vector<std::string> drawingModules{"matplotlib", "numpy"};
}  // namespace

void drawRecord(const Scenario &scenario, const std::string &scenarioFile, const std::string &recordJson,
                const std::string &outputFile)
{
    const TemporaryFile record(recordJson);
    const TemporaryFile generated(scenario.text);
    const std::string &scene = scenario.family.empty() ? scenarioFile : generated.path();
    if (runProgram({findPython(drawingModules), findScript("draw.py"), "run", scene, record.path(), outputFile}) != 0)
        throw std::runtime_error("drawing failed: see above");
}

void drawData(const std::string &script, const std::string &json, const std::string &outputFile)
{
    const TemporaryFile data(json);
    if (runProgram({findPython(drawingModules), findScript(script), data.path(), outputFile}) != 0)
        throw std::runtime_error("drawing failed: see above");
}

void runReport(const std::vector<std::string> &words)
{
    std::vector<std::string> command{findPython({"numpy", "pandas", "scipy", "statsmodels"}), findScript("report.py")};
    command.insert(command.end(), words.begin(), words.end());
    if (runProgram(command) != 0)
        throw std::runtime_error("no report: see above");
}
}  // namespace narrows
