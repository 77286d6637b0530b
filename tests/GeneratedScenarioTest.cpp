// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenario/GeneratedReader.h"
#include "scenario/Scenario.h"

namespace narrows
{
namespace
{
const std::string head = "format: narrows/scenario/1\nname: mine\n";

std::string whyNot(const std::string &text, const GenerateSettings &settings)
{
    try
    {
        parseScenario(text, "file", settings);
        return "";
    }
    catch (const InputError &error)
    {
        return error.what();
    }
}

TEST(GeneratedScenario, StandsForAFileWithoutGenerate)
{
    const Scenario scenario = parseScenario(head +
                                                "source: a page\n"
                                                "generate: {family: corridor, clearance: 1e-3}\n"
                                                "methods:\n"
                                                "  hppm: {points_per_link: 7, repulsion: {C1: -0.1, C2: 0.25}}\n"
                                                "  rrtconnect: {range: 0.5}\n",
                                            "file");
    EXPECT_EQ(scenario.name, "mine");
    EXPECT_EQ(scenario.base, "mine");
    EXPECT_EQ(scenario.group, "mine");
    EXPECT_EQ(scenario.family, "corridor");
    EXPECT_EQ(scenario.source, "a page; corridor: clearance 0.001");

    const Scenario again = parseScenario(scenario.text, "text");
    EXPECT_EQ(again.text, scenario.text);
    EXPECT_EQ(again.name, scenario.name);
    EXPECT_EQ(again.source, scenario.source);
    EXPECT_EQ(again.family, "");
    EXPECT_EQ(again.methods, scenario.methods);
    EXPECT_EQ(again.methods.at("hppm").at("repulsion"), "-0.1, 0.25");
    EXPECT_EQ(again.methods.at("rrtconnect").at("range"), "0.5");
    EXPECT_EQ(again.planar().task.start, scenario.planar().task.start);
}

TEST(GeneratedScenario, SettingsReplaceWhatTheFileSays)
{
    const std::string text = head + "generate: {family: slab, links: 6, half_width: 0.1, seed: 2}\n";
    const Scenario plain = parseScenario(text, "file");
    const Scenario same = parseScenario(text, "file", {{"seed", "2"}});
    const Scenario other = parseScenario(text, "file", {{"half_width", "1e-3"}, {"seed", "3"}});
    EXPECT_EQ(plain.planar().model->arm.linkCount(), 6);
    EXPECT_EQ(same.planar().task.start, plain.planar().task.start);
    EXPECT_EQ(other.planar().model->arm.linkCount(), 6);
    EXPECT_NE(other.planar().task.start, plain.planar().task.start);
    EXPECT_EQ(other.source, "slab: links 6, half_width 0.001, depth 0.5, symmetric false, seed 3");
    EXPECT_EQ(other.name, "mine_half_width1e-3_seed3");
    EXPECT_EQ(other.group, "mine_half_width1e-3");
    EXPECT_EQ(other.base, "mine");
    for (const char *word : {"mine", "mine_half_width1e-3", "mine_half_width1e-3_seed3"})
        EXPECT_TRUE(other.isCalled(word)) << word;
    EXPECT_FALSE(other.isCalled("mine_half_width1e-3_seed4"));
}

TEST(GeneratedScenario, MayLiveInSpace)
{
    const Scenario scenario = parseScenario(head +
                                                "generate: {family: pipes, obstacles: 3}\n"
                                                "methods: {hppm: {repulsion: {S1: 1, S2: 0.5, S3: 1}}}\n",
                                            "file", {{"seed", "4"}});
    EXPECT_EQ(scenario.name, "mine_seed4");
    EXPECT_EQ(scenario.group, "mine");
    EXPECT_EQ(scenario.family, "pipes");
    EXPECT_EQ(scenario.spatial().model->obstacles.size(), 3u);
    EXPECT_EQ(std::get<SpatialTipPath>(scenario.spatial().task.goal).points.size(), 3u);
    EXPECT_EQ(parseScenario(scenario.text, "text").text, scenario.text);
}

TEST(GeneratedScenario, NamesAreWords)
{
    EXPECT_EQ(nameWith("a", {}), "a");
    EXPECT_EQ(nameWith("a", {{"width", "+1e+3"}, {"blocked", "true"}}), "a_width1e3_blockedtrue");
}

TEST(GeneratedScenario, SettingsThatDoNotFitAreRefused)
{
    const std::string slab = head + "generate: {family: slab}\n";
    EXPECT_EQ(whyNot(slab, {{"gaps", "2"}}),
              "file:3: generate: gaps = 2: there is no parameter of the family slab 'gaps'; there are links, "
              "half_width, depth, symmetric, shape, seed");
    EXPECT_EQ(whyNot(slab, {{"seed", "x"}}),
              "file:3: generate: seed = x: must be a whole number from 0 to 1000000000, not 'x'");
    const std::string plain = head +
                              "robot: {kind: planar_arm, links: [{length: 1}]}\nobstacles: []\nstart: {angles: [0]}\n"
                              "goal: {angles: [1]}\n";
    EXPECT_EQ(whyNot(plain, {}), "");
    EXPECT_THAT(whyNot(plain, {{"seed", "1"}}), testing::HasSubstr("generate: is missing"));
}
}  // namespace
}  // namespace narrows
