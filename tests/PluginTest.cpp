// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Plugins.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "RunSpecs.h"
#include "benchmark/IsolatedRunner.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
using testing::HasSubstr;

std::string plugin(const std::string &name)
{
    return std::string(NARROWS_PLUGINS) + "/" + name + ".so";
}

/// Why a library is refused; empty if it is not.
std::string complaint(const std::string &path)
{
    const std::size_t before = planners().size();
    try
    {
        loadPlugin(path);
        return "";
    }
    catch (const std::invalid_argument &error)
    {
        EXPECT_THAT(error.what(), HasSubstr(path));
        EXPECT_EQ(planners().size(), before);
        return error.what();
    }
}

TEST(Plugin, IsRefusedForWhatDoesNotFit)
{
    EXPECT_THAT(complaint(plugin("WrongINTERFACE")), HasSubstr("was built for interface 2 of plugins"));
    EXPECT_THAT(complaint(plugin("WrongOMPL")), HasSubstr("was built with OMPL 1.4.2, this program with OMPL "));
    EXPECT_THAT(complaint(plugin("WrongABI")), HasSubstr("another C++ ABI"));
    EXPECT_THAT(complaint(plugin("WrongFUNCTION")), HasSubstr("has no function narrowsPlugin()"));
    EXPECT_THAT(complaint(plugin("WrongNAME")), HasSubstr("lower-case"));
    EXPECT_THAT(complaint(plugin("WrongTWIN")), HasSubstr("a planner rrtconnect, which there is already"));
    EXPECT_THAT(complaint(plugin("none")), HasSubstr("there is no such plugin"));
    const std::string text = testing::TempDir() + "text.so";
    std::ofstream(text) << "no library\n";
    EXPECT_THAT(complaint(text), HasSubstr("cannot be loaded"));
}

TEST(Plugin, AddsItsPlannersOnce)
{
    EXPECT_EQ(complaint(plugin("WrongMAKE")), "");
    ASSERT_EQ(loadedPlugins().size(), 1u);
    EXPECT_EQ(loadedPlugins()[0].path, plugin("WrongMAKE"));
    EXPECT_EQ(loadedPlugins()[0].sha256.size(), 64u);
    EXPECT_THAT(findPlanner("nothing").summary, HasSubstr("WrongMAKE.so"));
    EXPECT_THAT(complaint(plugin("WrongMAKE")), HasSubstr("a planner nothing, which there is already"));

    // Its runs are as isolated as any.
    Record result;
    runAll({smallRun("nothing")}, 1, [&result](std::size_t, const Record &record) { result = record; });
    EXPECT_EQ(toString(result.outcome), "crash");
    EXPECT_EQ(result.reason, "the plugin makes no nothing");
}
}  // namespace
}  // namespace narrows
