// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
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

/// The faults of many_faults.yaml: their keys, in any order, on the lines that its comments mark, from top to bottom.
inline void expectFaultsTogether(const std::string &folder, const std::vector<std::string> &expectedKeys)
{
    const std::string path = folder + "many_faults.yaml";
    std::vector<int> lines;
    std::vector<std::string> keys;
    for (const InputFault &fault : faultsOf(path))
    {
        lines.push_back(fault.line);
        keys.push_back(fault.key);
    }
    EXPECT_THAT(keys, testing::UnorderedElementsAreArray(expectedKeys));
    EXPECT_TRUE(std::is_sorted(lines.begin(), lines.end()));
    const std::vector<int> marked = markedLines(path);
    EXPECT_EQ(std::set<int>(lines.begin(), lines.end()), std::set<int>(marked.begin(), marked.end()));
}

inline std::string contentsOf(const std::string &file)
{
    std::ifstream stream(file);
    return std::string((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
}

/// Replaces pieces of a text by single letters, again and again, and lets `read` have it, which reads it or throws an
/// InputError with faults. \return how often it was refused
template <class Read>
int damage(const std::string &original, const std::string &letters, int rounds, const Read &read)
{
    constexpr unsigned seed = 1;
    std::mt19937 generator(seed);
    const auto below = [&](std::size_t n)
    {
        return static_cast<std::size_t>(generator() % n);
    };
    int refused = 0;
    for (int round = 0; round < rounds; ++round)
    {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", round " << round);
        std::string text = original;
        for (std::size_t edits = 1 + below(4); edits > 0; --edits)
            text.replace(below(text.size()), below(20), 1, letters[below(letters.size())]);
        try
        {
            read(text);
        }
        catch (const InputError &error)
        {
            ++refused;
            EXPECT_FALSE(error.faults().empty());
        }
    }
    return refused;
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
