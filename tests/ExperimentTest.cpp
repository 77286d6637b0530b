// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "benchmark/Experiment.h"
#include "benchmark/IniFile.h"
#include "benchmark/Sha256.h"

namespace narrows
{
namespace
{
const std::string badFolder = NARROWS_SOURCE_DIR "/tests/data/bad_experiments/";
const std::string scenarioFolder = NARROWS_SOURCE_DIR "/experiments/scenarios/";

/// The faults as "line: key: reason", without the file.
std::vector<std::string> faultsOf(const std::string &path)
{
    std::vector<std::string> texts;
    try
    {
        readExperiment(path);
    }
    catch (const InputError &error)
    {
        for (const InputFault &fault : error.faults())
            texts.push_back(std::to_string(fault.line) + ": " + fault.key + ": " + fault.reason);
    }
    return texts;
}

class ExperimentFile : public testing::Test
{
protected:
    ~ExperimentFile() override { std::filesystem::remove(path_); }

    Experiment read(const std::string &text)
    {
        std::ofstream(path_) << text;
        return readExperiment(path_);
    }

    std::string path_ = testing::TempDir() + "experiment" + std::to_string(getpid()) + ".cfg";
    std::string head_ = "[problem]\nname = test\nscenario = " + scenarioFolder + "gap_small.yaml, " + scenarioFolder +
                        "hppm_case1.yaml\n";
};

TEST(IniFile, KeepsOrderLinesAndRepeatedKeys)
{
    std::vector<InputFault> faults;
    const auto entries =
        parseIni("; comment\n[a]\nx = 1 ; one\nx=2#no comment\n\n[ b ]\n y = 1, 3; 2, 4 # rows\nz =\n", "f", faults);
    EXPECT_TRUE(faults.empty());
    ASSERT_EQ(entries.size(), 4u);
    EXPECT_EQ(entries[0].value, "1");
    EXPECT_EQ(entries[0].line, 3);
    EXPECT_EQ(entries[1].value, "2#no comment");
    EXPECT_EQ(entries[1].section, "a");
    EXPECT_EQ(entries[2].section, "b");
    EXPECT_EQ(entries[2].value, "1, 3; 2, 4");
    EXPECT_EQ(entries[3].value, "");
}

TEST(Sha256, AgreesWithThePublishedVectors)  // FIPS 180-4, examples
{
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(ExperimentFile, IsReadWithAllItsSettings)
{
    const Experiment experiment = read(head_ + R"([benchmark]
time_limit = 2.5
mem_limit = 100
run_count = 3
seed = 7
output = results
save_paths = all
simplify = 1
limits = 1.5, 4, 20
checker = analytic, fcl
motion = continuous, 0.01
space = relative
warm_up = 0
canary = 50
jobs = 2
[planner]
rrtconnect =
rrtconnect.range = 0.5
rrtconnect =
rrtconnect.name = greedy
rrtconnect.space = absolute_line
rrtconnect.recipe = none
rrtconnect.only = hppm-case-1
biest =
)");
    EXPECT_EQ(experiment.name, "test");
    EXPECT_EQ(experiment.scenarios.size(), 2u);
    EXPECT_EQ(experiment.timeLimit, 2.5);
    EXPECT_EQ(experiment.memoryLimit, 100.0);
    EXPECT_EQ(experiment.runCount, 3);
    EXPECT_EQ(experiment.seed, 7u);
    EXPECT_EQ(experiment.savePaths, SavePaths::All);
    EXPECT_TRUE(experiment.simplify);
    EXPECT_EQ(experiment.limits.value().velocity, 1.5);
    EXPECT_EQ(experiment.limits->acceleration, 4.0);
    EXPECT_EQ(experiment.limits->jerk, 20.0);
    EXPECT_EQ(expand(experiment).front().limits->jerk, 20.0);
    EXPECT_EQ(experiment.warmUp, 0.0);
    EXPECT_EQ(experiment.canary, 50);
    EXPECT_EQ(experiment.jobs, 2);
    EXPECT_EQ(
        experiment.databasePath(),
        (std::filesystem::path(testing::TempDir()) / "results" / std::filesystem::path(path_).stem()).string() + ".db");
    ASSERT_EQ(experiment.planners.size(), 3u);
    EXPECT_EQ(experiment.planners[0].label, "rrtconnect range=0.5");
    EXPECT_EQ(experiment.planners[0].space, "relative");
    EXPECT_EQ(experiment.planners[0].parameters, (std::map<std::string, std::string>{{"range", "0.5"}}));
    EXPECT_EQ(experiment.planners[1].label, "greedy");
    EXPECT_EQ(experiment.planners[1].space, "absolute_line");
    EXPECT_FALSE(experiment.planners[1].recipe);
    EXPECT_EQ(experiment.planners[2].label, "biest");
}

TEST_F(ExperimentFile, LimitsAreThreePositiveNumbersOrNone)
{
    const std::string planner = "[planner]\nrrtconnect =\n";
    EXPECT_FALSE(read(head_ + planner).limits);
    for (const char *limits : {"", "1, 1", "1, 1, 0", "1, -1, 1", "1, 1, inf", "1, 1, 1, 1", "fast"})
    {
        std::ofstream(path_) << head_ + "[benchmark]\nlimits = " + limits + "\n" + planner;
        const std::vector<std::string> faults = faultsOf(path_);
        ASSERT_EQ(faults.size(), 1u) << limits;
        EXPECT_THAT(faults[0], testing::StartsWith("5: benchmark.limits: limits are three positive numbers")) << limits;
    }
}

TEST_F(ExperimentFile, MotionIsContinuousOrAResolutionThatOmplTakes)
{
    const std::string planner = "[planner]\nrrtconnect =\n";
    EXPECT_EQ(read(head_ + "[benchmark]\nmotion = 0.999\n" + planner).motions, std::vector<std::string>{"0.999"});
    for (const char *motion : {"0", "1", "1e-320", "-0.1", "nan", "0.1x", "sampled"})
    {
        std::ofstream(path_) << head_ + "[benchmark]\nmotion = " + motion + "\n" + planner;
        EXPECT_THAT(faultsOf(path_),
                    testing::ElementsAre(testing::StartsWith("5: benchmark.motion: motion \"" + std::string(motion) +
                                                             "\" is neither \"continuous\" nor a resolution")));
    }
}

TEST_F(ExperimentFile, ANameTooLongForAnyFileIsOneThatIsNotThere)
{
    std::ofstream(path_) << "[problem]\nname = test\nscenario = " << std::string(300, 'x')
                         << ".yaml\n[planner]\nsbl =\n";
    EXPECT_THAT(faultsOf(path_), testing::ElementsAre(testing::StartsWith("3: problem.scenario: there is no file ")));
}

TEST_F(ExperimentFile, ExpandsToEveryRunOnceInBlocks)
{
    const Experiment experiment = read(head_ +
                                       "[benchmark]\nrun_count = 4\nchecker = analytic, fcl\n"
                                       "[planner]\nrrtconnect =\nrrtconnect.only = gap-small\nbiest =\nsbl =\n");
    const std::vector<RunSpec> specs = expand(experiment);
    ASSERT_EQ(specs.size(), 4u * (2 * 3 + 2 * 2));
    std::set<std::uint32_t> seeds;
    std::set<std::tuple<std::string, std::string, int>> runs;
    std::set<std::string> firstOnes;
    for (std::size_t i = 0; i < specs.size(); ++i)
    {
        seeds.insert(specs[i].seed);
        runs.emplace(specs[i].instance, specs[i].label, specs[i].run);
        if (i > 0)
        {
            EXPECT_GE(specs[i].run, specs[i - 1].run);
        }
        if (i == 0 || specs[i].instance != specs[i - 1].instance)
            firstOnes.insert(specs[i].label);
    }
    EXPECT_EQ(runs.size(), specs.size());
    EXPECT_EQ(seeds.size(), specs.size());
    EXPECT_EQ(seeds.count(0), 0u);
    EXPECT_GT(firstOnes.size(), 1u) << "the planners of a block are not shuffled";
    EXPECT_EQ(runs.count({"gap-small_fcl", "rrtconnect", 3}), 1u);
    EXPECT_EQ(runs.count({"hppm-case-1_fcl", "rrtconnect", 3}), 0u);
}

TEST_F(ExperimentFile, SeedsDependOnTheRunAloneNotOnItsCompany)
{
    const std::string settings = "[benchmark]\nseed = 5\nrun_count = 2\n[planner]\n";
    const std::vector<RunSpec> few = expand(read(head_ + settings + "biest =\nbiest.range = 1\n"));
    const std::vector<RunSpec> many = expand(read(head_ + settings + "sbl =\nbiest =\nbiest.range = 1\n"));
    std::map<std::tuple<std::string, std::string, int>, std::uint32_t> seeds;
    for (const RunSpec &spec : many)
        seeds[{spec.instance, spec.label, spec.run}] = spec.seed;
    for (const RunSpec &spec : few)
        EXPECT_EQ(spec.seed, seeds.at({spec.instance, spec.label, spec.run})) << spec.instance << " " << spec.run;
    // The formula itself, so that databases of different versions stay comparable.
    const std::string digest = sha256("5|gap-small_analytic|biest|biest|scenario|range=1,|0");
    EXPECT_EQ(few.front().seed, std::stoul(digest.substr(0, 8), nullptr, 16));
}

TEST_F(ExperimentFile, SeveralMotionsAreNamedInTheInstance)
{
    const std::vector<RunSpec> specs =
        expand(read(head_ + "[benchmark]\nrun_count = 1\nmotion = continuous, 0.01\n[planner]\nbiest =\n"));
    std::set<std::string> names;
    for (const RunSpec &spec : specs)
        names.insert(spec.instance);
    EXPECT_THAT(names, testing::ElementsAre("gap-small_analytic_0.01", "gap-small_analytic_continuous",
                                            "hppm-case-1_analytic_0.01", "hppm-case-1_analytic_continuous"));
}

TEST_F(ExperimentFile, DigestChangesWithTheFile)
{
    const std::string first = read(head_ + "[planner]\nbiest =\n").digest();
    EXPECT_EQ(read(head_ + "[planner]\nbiest =\n").digest(), first);
    EXPECT_NE(read(head_ + "[planner]\nsbl =\n").digest(), first);
}

TEST(BadExperiments, AllFaultsAreNamedAtOnce)
{
    using testing::StartsWith;
    const std::string path = badFolder + "many_faults.cfg";
    EXPECT_THAT(faultsOf(path),
                testing::ElementsAre(
                    StartsWith("1: stray: stands outside of any section"),
                    StartsWith("3: problem.name: 'two words' is not one word"),
                    StartsWith("4: problem.scenario: there is no file " + badFolder + "missing.yaml"),
                    StartsWith("5: problem.colour: unknown key; this section has name, scenario"),
                    StartsWith("7: benchmark.time_limit: 'soon' is not a number >= 0.001"),
                    StartsWith("8: benchmark.mem_limit: '0' is not a number >= 1"),
                    StartsWith("9: benchmark.run_count: '2.5' is not a whole number from 1 to"),
                    StartsWith("10: benchmark.run_count: already given in line 9"),
                    StartsWith("11: benchmark.seed: '-1' is not a whole number from 0 to 4294967295"),
                    StartsWith("12: benchmark.save_paths: 'some' is none of none, shortest, all"),
                    StartsWith("13: benchmark.simplify: 'yes' is none of 0, 1"), StartsWith("14: benchmark.checker: "),
                    StartsWith("15: benchmark.motion: "), StartsWith("16: benchmark.space: "),
                    StartsWith("17: benchmark.warm_up: '-1' is not a number >= 0"),
                    StartsWith("18: benchmark.jobs: '0' is not a whole number"),
                    StartsWith("20: sweep.generate.width: '4..2' is an empty or too large range"),
                    StartsWith("21: sweep.width: unknown key"), StartsWith("23: weather.sun: unknown section"),
                    StartsWith("24: [planner: a section is written [name]"), StartsWith("25: no equals sign: expected"),
                    StartsWith("26: = 3: there is no key before ="), StartsWith("28: rrtconect: "),
                    StartsWith("30: sbl.range: there is no `sbl =` above it"),
                    StartsWith("31: rrtconnect: takes no value"), StartsWith("32: rrtconnect.rnage: "),
                    StartsWith("33: rrtconnect.range: "), StartsWith("34: rrtconnect.range: already given in line 33"),
                    StartsWith("35: rrtconnect.only: no scenario of this experiment is called 'nowhere'"),
                    StartsWith("36: rrtconnect.recipe: 'maybe' is neither"), StartsWith("37: rrtconnect.space: "),
                    StartsWith("39: biest: is called 'biest' like the entry in line 38")));
}

TEST_F(ExperimentFile, SweepsGoInSteps)
{
    const Experiment experiment = read("[problem]\nname = test\nscenario = " + scenarioFolder +
                                       "slab.yaml\n[sweep]\n"
                                       "generate.half_width = 0.01..0.019 by 0.003, 1e-4..1.2e-4 by 1e-5\n"
                                       "[planner]\nrrtconnect =\n");
    std::vector<std::string> names;
    for (const auto &scenario : experiment.scenarios)
        names.push_back(scenario->name);
    EXPECT_THAT(names, testing::ElementsAre("slab_half_width0.01", "slab_half_width0.013", "slab_half_width0.016",
                                            "slab_half_width0.019", "slab_half_width0.0001", "slab_half_width0.00011",
                                            "slab_half_width0.00012"));
}

TEST_F(ExperimentFile, SweepsMakeTheCrossProductOfEveryFamily)
{
    const Experiment experiment = read("[problem]\nname = test\nscenario = " + scenarioFolder + "slab.yaml, " +
                                       scenarioFolder + "gap_small.yaml, " + scenarioFolder +
                                       "tube.yaml\n"
                                       "[sweep]\ngenerate.half_width = 0.1, 1e-2\ngenerate.seed = 3..5, 9\n"
                                       "[benchmark]\nrun_count = 2\n"
                                       "[planner]\nrrtconnect =\nbiest =\nbiest.only = slab, tube_half_width1e-2\n");
    ASSERT_EQ(experiment.scenarios.size(), 8u + 1u + 8u);
    EXPECT_EQ(experiment.scenarios[0]->name, "slab_half_width0.1_seed3");
    EXPECT_EQ(experiment.scenarios[1]->name, "slab_half_width0.1_seed4");
    EXPECT_EQ(experiment.scenarios[7]->name, "slab_half_width1e-2_seed9");
    EXPECT_EQ(experiment.scenarios[7]->group, "slab_half_width1e-2");
    EXPECT_EQ(experiment.scenarios[7]->base, "slab");
    EXPECT_EQ(experiment.scenarios[8]->name, "gap-small");
    std::map<std::string, int> runs;
    std::set<std::string> instances;
    for (const RunSpec &spec : expand(experiment))
    {
        ++runs[spec.label + " " + spec.group];
        instances.insert(spec.instance);
        EXPECT_EQ(spec.instance, spec.scenario->name + "_analytic");
    }
    EXPECT_EQ(instances.size(), 17u);
    EXPECT_EQ(runs, (std::map<std::string, int>{{"rrtconnect slab_half_width0.1_analytic", 8},
                                                {"rrtconnect slab_half_width1e-2_analytic", 8},
                                                {"rrtconnect gap-small_analytic", 2},
                                                {"rrtconnect tube_half_width0.1_analytic", 8},
                                                {"rrtconnect tube_half_width1e-2_analytic", 8},
                                                {"biest slab_half_width0.1_analytic", 8},
                                                {"biest slab_half_width1e-2_analytic", 8},
                                                {"biest tube_half_width1e-2_analytic", 8}}));
}

TEST_F(ExperimentFile, AScenarioWithAxesOfItsOwnTakesNoOthers)
{
    const Experiment experiment = read("[problem]\nname = test\nscenario = " + scenarioFolder + "slab.yaml, " +
                                       scenarioFolder + "mixed.yaml, " + scenarioFolder +
                                       "gap_small.yaml\n[sweep]\ngenerate.half_width = 0.1, 1e-2\n"
                                       "mixed.generate.links = 3, 4\nmixed.generate.seed = 7\n[planner]\nbiest =\n");
    std::vector<std::string> names;
    for (const auto &scenario : experiment.scenarios)
        names.push_back(scenario->name);
    EXPECT_THAT(names, testing::ElementsAre("slab_half_width0.1", "slab_half_width1e-2", "mixed_links3_seed7",
                                            "mixed_links4_seed7", "gap-small"));
}

TEST_F(ExperimentFile, ASweepIsPartOfTheDigest)
{
    const std::string head = "[problem]\nname = test\nscenario = " + scenarioFolder + "slab.yaml\n[sweep]\n";
    const std::string tail = "\n[planner]\nbiest =\n";
    EXPECT_NE(read(head + "generate.seed = 1, 2" + tail).digest(), read(head + "generate.seed = 1, 3" + tail).digest());
}

TEST_F(ExperimentFile, BadSweepsAreRefusedWithTheirLines)
{
    using testing::ElementsAre;
    const auto faults = [&](const std::string &scenario, const std::string &sweep)
    {
        std::ofstream(path_) << "[problem]\nname = test\nscenario = " << scenarioFolder << scenario << "\n[sweep]\n"
                             << sweep << "\n[planner]\nbiest =\n";
        return faultsOf(path_);
    };
    const auto slabFaults = [&](const std::string &sweep)
    {
        return faults("slab.yaml", sweep);
    };
    EXPECT_THAT(slabFaults("generate.gaps = 2"),
                ElementsAre("5: sweep.generate.gaps: there is no parameter of the family slab 'gaps'; there are links, "
                            "half_width, depth, symmetric, shape, seed"));
    EXPECT_THAT(slabFaults("generate.links = 3, 4.5"),
                ElementsAre("5: sweep.generate.links: must be a whole number from 3 to 100, not '4.5'"));
    EXPECT_THAT(slabFaults("generate.seed = 1..3, 2"), ElementsAre("5: sweep.generate.seed: names '2' twice"));
    EXPECT_THAT(slabFaults("generate.seed = 1..b"),
                ElementsAre("5: sweep.generate.seed: '1..b' is not a range of whole numbers like 1..20"));
    EXPECT_THAT(slabFaults("generate.half_width = 0.1..0.2 by b"),
                ElementsAre("5: sweep.generate.half_width: '0.1..0.2 by b' is not a range of numbers like 0.1..0.2 by "
                            "0.05"));
    for (const char *step : {"0", "-0.1", "1e-9"})
        EXPECT_THAT(slabFaults("generate.half_width = 0.1..0.2 by " + std::string(step)),
                    ElementsAre(testing::HasSubstr("is an empty or too large range")));
    EXPECT_THAT(slabFaults("generate.seed ="),
                ElementsAre("5: sweep.generate.seed: expected a list separated by commas"));
    EXPECT_THAT(slabFaults("generate.seed = 1,,2"),
                ElementsAre("5: sweep.generate.seed: expected a list separated by commas"));
    EXPECT_THAT(slabFaults("generate.seed = 1\ngenerate.seed = 2"),
                ElementsAre("6: sweep.generate.seed: already given in line 5"));
    EXPECT_THAT(slabFaults("generate.seed = 1..400\ngenerate.links = 3..300"),
                testing::Contains("6: sweep.generate.links: makes more than 100000 instances"));
    EXPECT_THAT(faults("gap_small.yaml", "generate.seed = 1"),
                ElementsAre("5: sweep.generate.seed: no scenario of this experiment has `generate` and no axes of its "
                            "own"));
    EXPECT_THAT(slabFaults("slub.generate.seed = 1"),
                ElementsAre("5: sweep.slub.generate.seed: no scenario with `generate` is called 'slub'"));
    EXPECT_THAT(slabFaults("slab.generate.gaps = 2"),
                ElementsAre("5: sweep.slab.generate.gaps: there is no parameter of the family slab 'gaps'; there are "
                            "links, half_width, depth, symmetric, shape, seed"));
    EXPECT_THAT(slabFaults(".generate.seed = 1\nslab.generate. = 1"),
                ElementsAre(testing::StartsWith("5: sweep..generate.seed: unknown key; this section has generate.<"),
                            testing::StartsWith("6: sweep.slab.generate.: unknown key")));
}

TEST(BadExperiments, FilesWithOneFaultEach)
{
    using testing::ElementsAre;
    using testing::HasSubstr;
    EXPECT_THAT(faultsOf(badFolder + "no_planner.cfg"), ElementsAre(HasSubstr("planner: there is no planner")));
    EXPECT_THAT(faultsOf(badFolder + "bad_scenario.cfg"), ElementsAre(HasSubstr("obstacles[0].radius")));
    EXPECT_THAT(faultsOf(badFolder + "twin_scenarios.cfg"), ElementsAre(HasSubstr("two of the scenarios are called")));
    EXPECT_THAT(faultsOf(badFolder + "space_against_limits.cfg"), ElementsAre(HasSubstr("6: rrtconnect.space: ")));
    EXPECT_FALSE(faultsOf(badFolder + "empty.cfg").empty());
    EXPECT_FALSE(faultsOf(badFolder + "no such file.cfg").empty());
    EXPECT_FALSE(faultsOf(badFolder).empty());
}
}  // namespace
}  // namespace narrows
