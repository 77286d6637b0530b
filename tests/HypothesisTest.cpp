// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "benchmark/Hypothesis.h"
#include "benchmark/ResultStore.h"
#include "benchmark/Sha256.h"

namespace narrows
{
namespace
{
using testing::ElementsAre;

/// What an InputError says, without the file.
template <typename Call>
std::string complaintOf(const Call &call)
{
    try
    {
        call();
    }
    catch (const InputError &error)
    {
        std::string text;
        for (const InputFault &fault : error.faults())
            text += (text.empty() ? "" : "\n") + std::to_string(fault.line) + ": " + fault.key + ": " + fault.reason;
        return text;
    }
    return "";
}

class Declared : public testing::Test
{
protected:
    ~Declared() override
    {
        for (const std::string &file : {path_, database_, database_ + "-wal", database_ + "-shm"})
            std::filesystem::remove(file);
    }

    Experiment read(const std::string &hypotheses)
    {
        const std::string scenarios = NARROWS_SOURCE_DIR "/experiments/scenarios/";
        std::ofstream(path_) << "[problem]\nname = test\nscenario = " << scenarios << "slab.yaml, " << scenarios
                             << "gap_small.yaml\n[sweep]\ngenerate.half_width = 0.1, 1e-2\ngenerate.seed = 1, 2\n"
                             << "[planner]\nhppm =\nrrtconnect =\nbiest =\nbiest.only = slab\n[hypothesis]\n"
                             << hypotheses;
        return readExperiment(path_);
    }
    std::string complaint(const std::string &hypotheses)
    {
        return complaintOf([&] { read(hypotheses); });
    }

    const std::string sound_ =
        "slow = HPPM is slower\nslow.planner = hppm\nslow.against = sampling\nslow.scenes = slab_half_width1*\n"
        "slow.quantity = time\nslow.direction = more\n";
    const std::string path_ = testing::TempDir() + "hypotheses" + std::to_string(getpid()) + ".cfg";
    const std::string database_ = testing::TempDir() + "hypotheses" + std::to_string(getpid()) + ".db";
};

TEST_F(Declared, NamesOfPlannersAndGroupsAreResolved)
{
    const Hypotheses hypotheses =
        read(sound_ +
             "alpha = 0.01\nmost = RRT-Connect solves most\nmost.planner = rrtconnect\nmost.quantity = success\n"
             "most.direction = more\nmost.bound = 0.9\n")
            .hypotheses;
    EXPECT_EQ(hypotheses.alpha, 0.01);
    ASSERT_EQ(hypotheses.all.size(), 2u);
    const Hypothesis &slow = hypotheses.all[0];
    EXPECT_EQ(slow.name + ": " + slow.statement, "slow: HPPM is slower");
    EXPECT_THAT(slow.planners, ElementsAre("hppm"));
    EXPECT_THAT(slow.against, ElementsAre("biest", "rrtconnect"));
    EXPECT_THAT(slow.groups, ElementsAre("slab_half_width1e-2_analytic"));
    EXPECT_EQ(slow.quantity + " " + slow.direction, "time more");
    EXPECT_FALSE(slow.bound);
    EXPECT_THAT(hypotheses.all[1].groups,
                ElementsAre("gap-small_analytic", "slab_half_width0.1_analytic", "slab_half_width1e-2_analytic"));
    EXPECT_EQ(hypotheses.all[1].bound, 0.9);
}

TEST_F(Declared, OnlyGroupsWhereAllPlannersRunCount)
{
    const Hypotheses hypotheses = read(
                                      "a = b\na.planner = biest\na.against = hppm\na.quantity = length\n"
                                      "a.direction = less\n")
                                      .hypotheses;
    EXPECT_THAT(hypotheses.all[0].groups, ElementsAre("slab_half_width0.1_analytic", "slab_half_width1e-2_analytic"));
    EXPECT_THAT(complaint("a = b\na.planner = biest\na.against = hppm\na.scenes = gap*\na.quantity = time\n"
                          "a.direction = less\n"),
                testing::HasSubstr("16: hypothesis.a.scenes: no (further) group that all its planners run on fits"));
}

TEST_F(Declared, FaultsAreNamedWithTheirLines)
{
    EXPECT_EQ(
        complaint("alpha = 1\nx.planner = hppm\na =\na = twice\na.planner = nobody\na.quantity = beauty\n"
                  "a.direction = up\na.bound = high\na.colour = red\na.bound = 1\n"),
        "13: hypothesis.alpha: '1' is not a number above 0 and at most 0.5\n"
        "14: hypothesis.x.planner: there is no `x = <statement>` above it\n"
        "15: hypothesis.a: states nothing\n"
        "16: hypothesis.a: there is a hypothesis of this name already\n"
        "17: hypothesis.a.planner: no planner entry is called 'nobody'\n"
        "18: hypothesis.a.quantity: 'beauty' is none of success, time, evaluations, memory, length\n"
        "19: hypothesis.a.direction: 'up' is none of more, less\n"
        "20: hypothesis.a.bound: 'high' is not a number\n"
        "21: hypothesis.a.colour: unknown key; a hypothesis has planner, against, scenes, quantity, direction and "
        "bound\n"
        "22: hypothesis.a.bound: already given in line 20");
    EXPECT_EQ(complaint("a = b\na.planner = hppm\na.quantity = time\n"),
              "13: hypothesis.a.direction: is missing\n"
              "13: hypothesis.a: takes either `against` or `bound`: what its planner is compared with");
    EXPECT_EQ(complaint("a = b\na.planner = rrtconnect\na.against = sampling\na.quantity = time\na.direction = less\n"),
              "15: hypothesis.a.against: compares 'rrtconnect' with itself");
}

TEST_F(Declared, TheyAreStoredBeforeTheFirstRun)
{
    const Experiment experiment = read(sound_);
    ResultStore::create(database_, experiment, "isolated");
    SQLite::Database database(database_);
    SQLite::Statement query(database, "SELECT name, definition, sha256, declared FROM hypotheses");
    ASSERT_TRUE(query.executeStep());
    const std::string definition = query.getColumn(1).getString();
    EXPECT_EQ(query.getColumn(0).getString(), "slow");
    EXPECT_EQ(definition,
              R"({"against":["biest","rrtconnect"],"alpha":0.05,"direction":"more",)"
              R"("groups":["slab_half_width1e-2_analytic"],"name":"slow","planners":["hppm"],"quantity":"time",)"
              R"("statement":"HPPM is slower"})");
    EXPECT_EQ(query.getColumn(2).getString(), sha256(definition));
    EXPECT_FALSE(query.getColumn(3).isNull());
    EXPECT_FALSE(query.executeStep());
}

TEST_F(Declared, TheDoctorFindsOneThatWasChanged)
{
    ResultStore::create(database_, read(sound_), "isolated");
    EXPECT_TRUE(ResultStore::open(database_).examine().faults.empty());
    SQLite::Database(database_, SQLite::OPEN_READWRITE)
        .exec("UPDATE hypotheses SET definition = replace(definition, 'more', 'less')");
    EXPECT_THAT(ResultStore::open(database_).examine().faults,
                ElementsAre("the hypothesis slow is not the one that its SHA-256 was taken of"));
}

TEST_F(Declared, NothingDeclaredCanBeChangedLater)
{
    const auto resume = [&](const std::string &hypotheses)
    {
        const Experiment experiment = read(hypotheses);
        return complaintOf([&] { ResultStore::resume(database_, experiment, "isolated"); });
    };
    ResultStore::create(database_, read(sound_), "isolated");
    const std::string advice = "; what was declared before the runs cannot be changed after them";
    EXPECT_EQ(resume(sound_), "");
    EXPECT_EQ(resume("alpha = 0.1\n" + sound_), "0: : has another hypothesis 'slow'" + advice);
    EXPECT_EQ(resume(""), "0: : has the hypothesis 'slow', which the file lacks" + advice);
    EXPECT_EQ(resume(sound_ + "a = b\na.planner = hppm\na.bound = 1\na.quantity = time\na.direction = less\n"),
              "0: : does not have the hypothesis 'a'" + advice);
}
}  // namespace
}  // namespace narrows
