// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenario/Scenario.h"

namespace narrows
{
/// A scenario file with one fault. Lines with a fault end in the comment "here" where the file's text allows one.
struct BadFile
{
    std::string name;    ///< without ".yaml"
    std::string key;     ///< exactly
    std::string reason;  ///< a part of it
};

inline void PrintTo(const BadFile &file, std::ostream *stream)
{
    *stream << file.name << ".yaml";
}

inline std::string nameOf(const testing::TestParamInfo<BadFile> &file)
{
    return file.param.name;
}

inline std::vector<int> markedLines(const std::string &path)
{
    std::vector<int> lines;
    std::ifstream stream(path);
    std::string text;
    for (int line = 1; std::getline(stream, text); ++line)
        if (text.find("# here") != std::string::npos)
            lines.push_back(line);
    return lines;
}

inline std::vector<InputFault> faultsOf(const std::string &path)
{
    try
    {
        readScenario(path);
    }
    catch (const InputError &error)
    {
        return error.faults();
    }
    return {};
}

inline void expectRefused(const std::string &folder, const BadFile &file)
{
    const std::string path = folder + file.name + ".yaml";
    const std::vector<InputFault> faults = faultsOf(path);
    const auto fault =
        std::find_if(faults.begin(), faults.end(),
                     [&](const InputFault &candidate)
                     { return candidate.key == file.key && candidate.reason.find(file.reason) != std::string::npos; });
    if (fault == faults.end())
    {
        for (const InputFault &other : faults)
            ADD_FAILURE() << "says: " << other.text();
        FAIL() << "does not say: " << file.key << ": " << file.reason;
    }
    EXPECT_EQ(fault->file, path);
    for (const int line : markedLines(path))
        EXPECT_EQ(fault->line, line);
    EXPECT_TRUE(fault->line > 0 || fault->key.empty()) << "only a fault of the whole file may be without a line";
    EXPECT_THAT(fault->text(), testing::StartsWith(path + ":"));
}

/// Every file of the folder is in the table, but many_faults.yaml.
inline void expectListed(const std::string &folder, const std::vector<BadFile> &files)
{
    std::set<std::string> expected{"many_faults"};
    for (const BadFile &file : files)
        EXPECT_TRUE(expected.insert(file.name).second) << file.name << " is in the table twice";
    std::set<std::string> present;
    for (const auto &entry : std::filesystem::directory_iterator(folder))
        present.insert(entry.path().stem().string());
    EXPECT_EQ(present, expected);
}
}  // namespace narrows
