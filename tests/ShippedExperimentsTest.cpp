// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/Experiment.h"

namespace narrows
{
namespace
{
const std::filesystem::path folder = NARROWS_SOURCE_DIR "/experiments";

std::vector<std::string> shippedExperiments()
{
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".cfg")
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class ShippedExperiment : public testing::TestWithParam<std::string>
{
};

/// Reading makes every scene of the sweeps, so that one which cannot be made is named before the first run.
TEST_P(ShippedExperiment, IsReadWithAllItsScenes)
{
    std::vector<std::string> faults;
    try
    {
        const Experiment experiment = readExperiment((folder / (GetParam() + ".cfg")).string());
        EXPECT_FALSE(experiment.scenarios.empty());
        EXPECT_FALSE(experiment.planners.empty());
    }
    catch (const InputError &error)
    {
        for (const InputFault &fault : error.faults())
            faults.push_back(std::to_string(fault.line) + ": " + fault.key + ": " + fault.reason);
    }
    EXPECT_THAT(faults, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, ShippedExperiment, testing::ValuesIn(shippedExperiments()),
                         [](const auto &test) { return test.param; });
}  // namespace
}  // namespace narrows
