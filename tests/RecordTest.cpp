// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Record.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "RunSpecs.h"

namespace narrows
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

Record fullRecord()
{
    Record record;
    record.outcome = Outcome::Unverified;
    record.reason = "collision: segment 3 at 0.25, link 1, obstacle \"C1\"";
    record.status = 6;
    record.prescribed = true;
    record.usesModel = true;
    record.time = 0.1 + 0.2;
    record.cpuTime = 1e-300;
    record.simplificationTime = 0.0;
    record.peakMemoryKb = 12345.0;
    record.stateChecks = std::int64_t(1) << 60;
    record.motionChecks = 0;
    record.evaluations = 7;
    record.graphStates = 8;
    record.graphMotions = 9;
    record.waypoints = 2;
    record.length = 3.0;
    record.clearance = infinity;
    record.smoothness = -infinity;
    record.solutionDifference = std::nan("");
    record.maxJointStep = 1.0 / 3.0;
    record.simplifiedLength = 2.0;
    record.simplifiedVerified = false;
    record.duration = 1.0 / 7.0;
    record.stopDuration = 0.2;
    record.peakVelocity = 1.5;
    record.peakAcceleration = 4.0;
    record.peakJerk = infinity;
    record.verified = false;
    record.measures = {{"hyperspheres", 146.0}, {"pole", infinity}};
    record.parameters = {{"range", "0.5"}, {"text", "a \"b\"\n"}};
    record.path = {Eigen::Vector2d(0.1, -0.0), Eigen::Vector2d(std::nan(""), -infinity)};
    record.vias = {Eigen::Vector2d(0.1, 0.2)};
    record.output = "two\nlines";
    return record;
}

TEST(Record, SurvivesJsonToTheLastBit)
{
    const RunSpec spec = smallRun("rrtconnect", 4294967295u);
    const std::string text = toJson(spec, fullRecord());
    const Record copy = recordFromJson(text);
    EXPECT_EQ(toJson(spec, copy), text);  // all fields are in the text, NaN included

    EXPECT_EQ(copy.outcome, Outcome::Unverified);
    EXPECT_EQ(copy.time, 0.1 + 0.2);
    EXPECT_EQ(copy.cpuTime, 1e-300);
    EXPECT_EQ(copy.stateChecks, std::int64_t(1) << 60);
    EXPECT_EQ(copy.clearance, infinity);
    EXPECT_EQ(copy.smoothness, -infinity);
    EXPECT_TRUE(std::isnan(copy.solutionDifference.value()));
    EXPECT_EQ(copy.simplifiedVerified, false);
    EXPECT_EQ(copy.measures.at("pole"), infinity);
    EXPECT_EQ(copy.parameters, fullRecord().parameters);
    ASSERT_EQ(copy.path.size(), 2u);
    EXPECT_TRUE(std::signbit(copy.path[0][1]));
    EXPECT_TRUE(std::isnan(copy.path[1][0]));
    EXPECT_EQ(copy.path[1][1], -infinity);
    EXPECT_EQ(copy.output, "two\nlines");
}

TEST(Record, WhatWasNotMeasuredIsNull)
{
    const RunSpec spec = smallRun("rrtconnect");
    const nlohmann::json json = nlohmann::json::parse(toJson(spec, Record()));
    for (const char *key : {"verified", "time_s", "cpu_s", "length", "clearance", "smoothness", "waypoints",
                            "state_checks", "motion_checks", "evaluations", "peak_memory_kb", "path", "graph_states"})
        EXPECT_TRUE(json.at(key).is_null()) << key;
    const Record copy = recordFromJson(json.dump());
    EXPECT_FALSE(copy.verified);
    EXPECT_FALSE(copy.stateChecks);
    EXPECT_TRUE(copy.path.empty());
}

TEST(Record, JsonHasTheKeysThatOthersRelyOn)
{
    const nlohmann::json json = nlohmann::json::parse(toJson(smallRun("bkpiece1", 7), fullRecord()));
    EXPECT_EQ(json.at("scenario"), "gap-small");
    EXPECT_EQ(json.at("planner"), "bkpiece1");
    EXPECT_EQ(json.at("seed"), 7);
    EXPECT_EQ(json.at("outcome"), "unverified");
    EXPECT_EQ(json.at("path").at("angles").size(), 2u);
    EXPECT_EQ(json.at("clearance"), "inf");
}

TEST(Record, TextThatIsNotUtf8IsReplacedNotRefused)
{
    Record record;
    record.output = "caf\xe9";
    EXPECT_EQ(recordFromJson(toJson(smallRun("rrtconnect"), record)).output, "caf\xef\xbf\xbd");
}

TEST(Record, OutcomesHaveNames)
{
    for (int i = 0; i <= static_cast<int>(Outcome::InternalError); ++i)
        EXPECT_EQ(outcomeFromString(toString(static_cast<Outcome>(i))), static_cast<Outcome>(i)) << i;
    EXPECT_EQ(toString(Outcome::NoSolution), "no_solution");
    EXPECT_THROW(outcomeFromString("Solved"), std::invalid_argument);
    EXPECT_THROW(outcomeFromString(""), std::invalid_argument);
}

TEST(Record, RefusesWhatIsNotARecord)
{
    const std::string good = toJson(smallRun("rrtconnect"), fullRecord());
    for (const std::string &bad : {std::string(), std::string("null"), std::string("[1, 2]"), std::string("{}"),
                                   good.substr(0, good.size() / 2), good + "}"})
        EXPECT_THROW(recordFromJson(bad), std::invalid_argument) << bad;

    for (const auto &[key, value] : {std::pair<const char *, nlohmann::json>{"outcome", "won"},
                                     {"outcome", 3},
                                     {"time_s", "soon"},
                                     {"waypoints", 1.5},
                                     {"verified", 1},
                                     {"measures", {{"a", nullptr}}},
                                     {"path", {{"angles", {{"x"}}}}}})
    {
        nlohmann::json json = nlohmann::json::parse(good);
        json[key] = value;
        EXPECT_THROW(recordFromJson(json.dump()), std::invalid_argument) << key << " = " << value;
    }
}
}  // namespace
}  // namespace narrows
