// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/IniFile.h"

#include <sstream>

#include "benchmark/Text.h"

namespace narrows
{
namespace
{
std::string withoutComment(const std::string &line)
{
    for (std::size_t i = 0; i < line.size(); ++i)
        if ((line[i] == ';' || line[i] == '#') && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t'))
            return line.substr(0, i);
    return line;
}
}  // namespace

std::vector<IniEntry> parseIni(const std::string &text, const std::string &file, std::vector<InputFault> &faults)
{
    std::vector<IniEntry> entries;
    std::string section;
    std::istringstream stream(text);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number)
    {
        const std::string content = trimmed(withoutComment(line));
        const std::size_t equals = content.find('=');
        if (content.empty())
            continue;
        if (content.front() == '[')
        {
            section = content.back() == ']' ? trimmed(content.substr(1, content.size() - 2)) : "";
            if (section.empty())
                faults.push_back({file, number, content, "a section is written [name]"});
        }
        else if (equals == std::string::npos)
            faults.push_back({file, number, content, "expected `key = value`, a [section] or a comment"});
        else if (trimmed(content.substr(0, equals)).empty())
            faults.push_back({file, number, content, "there is no key before ="});
        else
            entries.push_back(
                {section, trimmed(content.substr(0, equals)), trimmed(content.substr(equals + 1)), number});
    }
    return entries;
}
}  // namespace narrows
