// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "scenario/Scenario.h"

namespace narrows
{
namespace
{
using testing::HasSubstr;
using testing::IsEmpty;

const std::string scenarios = NARROWS_SOURCE_DIR "/experiments/scenarios/";
const std::string small = scenarios + "gap_small.yaml";

struct Reply
{
    int code;
    std::string out;
    std::string err;
};

class CommandLine : public testing::Test
{
protected:
    CommandLine() { std::filesystem::create_directories(folder_); }
    ~CommandLine() override { std::filesystem::remove_all(folder_); }

    static std::string readFile(const std::string &path)
    {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }

    std::string file(const std::string &name, const std::string &content) const
    {
        std::ofstream(folder_ + "/" + name) << content;
        return folder_ + "/" + name;
    }

    /// Runs the program; `arguments` are words for the shell.
    Reply narrows(const std::string &arguments) const
    {
        const std::string out = folder_ + "/out";
        const std::string err = folder_ + "/err";
        const int status = std::system((NARROWS_PROGRAM " " + arguments + " > " + out + " 2> " + err).c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(out), readFile(err)};
    }

    std::string experiment() const
    {
        return file("test.cfg", "[problem]\nname = test\nscenario = " + small +
                                    "\n[benchmark]\nrun_count = 2\nwarm_up = 0\nsave_paths = all\n"
                                    "[planner]\nrrtconnect =\nbiest =\n");
    }

    std::string folder_ = testing::TempDir() + "commandline" + std::to_string(getpid());
};

TEST_F(CommandLine, BadUsageIsCode2)
{
    for (const char *arguments : {"", "dance", "plan", "plan --planner", "bench", "list", "list wishes", "show planner",
                                  "bench a.cfg --engine steam", "verify a.yaml"})
    {
        const Reply reply = narrows(arguments);
        EXPECT_EQ(reply.code, 2) << arguments;
        EXPECT_THAT(reply.out, IsEmpty()) << arguments;
        EXPECT_FALSE(reply.err.empty()) << arguments;
    }
    EXPECT_EQ(narrows("--help").code, 0);
    EXPECT_EQ(narrows("plan --help").code, 0);
    EXPECT_EQ(narrows("--version").code, 0);
}

TEST_F(CommandLine, PlanSolvesAndSaysSo)
{
    const Reply reply = narrows("plan " + small + " --planner rrtconnect --seed 3 --simplify");
    EXPECT_EQ(reply.code, 0) << reply.err;
    EXPECT_THAT(reply.out, HasSubstr("rrtconnect on gap-small: solved"));
    EXPECT_THAT(reply.out, HasSubstr("CPU time"));
    EXPECT_THAT(reply.err, IsEmpty());
}

TEST_F(CommandLine, PlanWithJsonPrintsOneObjectAndNothingElse)
{
    const Reply reply = narrows("plan " + small + " --planner rrtconnect --param range=9 --param range=0.5 --json -");
    EXPECT_EQ(reply.code, 0) << reply.err;
    const nlohmann::json json = nlohmann::json::parse(reply.out);
    EXPECT_EQ(json.at("outcome"), "solved");
    EXPECT_EQ(json.at("parameters").at("range"), "0.5");  // the later one wins
    EXPECT_TRUE(json.at("solution_difference").is_null());
}

TEST_F(CommandLine, PlanDrawsTheMotion)
{
    const std::string drawing = folder_ + "/drawing.svg";
    const Reply reply = narrows("plan " + small + " --planner rrtconnect --svg " + drawing);
    EXPECT_EQ(reply.code, 0) << reply.err;
    EXPECT_THAT(readFile(drawing), HasSubstr("<svg"));
}

TEST_F(CommandLine, PlanDrawsTheSliceOfACurve)
{
    const std::string drawing = folder_ + "/slice.svg";
    const Reply reply =
        narrows("plan " + scenarios + "corridor.yaml --planner hppm --no-recipe --seed 1 --json - --slice " + drawing);
    EXPECT_EQ(reply.code, 0) << reply.err;
    const nlohmann::json slice = nlohmann::json::parse(reply.out).at("slice");
    EXPECT_TRUE(slice.at("failure").is_null());
    EXPECT_EQ(slice.at("joins"), true);
    EXPECT_GT(slice.at("bottleneck").get<double>(), 0.0);
    EXPECT_THAT(readFile(drawing), HasSubstr("<svg"));
}

TEST_F(CommandLine, SliceDataPoseTheArmAlongTheCurve)
{
    const std::string data = folder_ + "/slice.json";
    const Reply reply = narrows("plan " + scenarios + "hppm_case1.yaml --planner hppm --json - --slice " + data);
    ASSERT_EQ(reply.code, 0) << reply.err;
    using Rows = std::vector<std::vector<double>>;
    const Rows path = nlohmann::json::parse(reply.out).at("path").at("angles").get<Rows>();
    const nlohmann::json slice = nlohmann::json::parse(readFile(data));
    const Rows curve = slice.at("curve").get<Rows>();
    const Rows middle = slice.at("middle").get<Rows>();
    const auto direction = slice.at("direction").get<std::vector<double>>();
    const auto lambda = slice.at("lambda").get<std::vector<double>>();
    ASSERT_EQ(curve.size(), path.size());
    for (std::size_t i = 0; i < path.size(); ++i)
    {
        // Between the configurations at s = 0, lambda goes evenly.
        const double place =
            (curve[i][0] - lambda[0]) / (lambda[1] - lambda[0]) * static_cast<double>(middle.size() - 1);
        const auto before = static_cast<std::size_t>(place);
        const double share = place - static_cast<double>(before);
        for (std::size_t joint = 0; joint < direction.size(); ++joint)
            EXPECT_NEAR((1.0 - share) * middle[before][joint] + share * middle[before + 1][joint] +
                            curve[i][1] * direction[joint],
                        path[i][joint], 1e-12);
    }
}

TEST_F(CommandLine, PlanSaysIfThereIsNoSliceToDraw)
{
    const std::string drawing = folder_ + "/slice.svg";
    const Reply reply = narrows("plan " + small + " --planner rrtconnect --json - --slice " + drawing);
    EXPECT_EQ(reply.code, 2);
    EXPECT_THAT(reply.err, HasSubstr("--slice: no curve was followed"));
    EXPECT_EQ(nlohmann::json::parse(reply.out).at("outcome"), "solved");  // not lost with the picture
    EXPECT_FALSE(std::filesystem::exists(drawing));
}

TEST_F(CommandLine, PlanThatDoesNotSolveIsCode1)
{
    const Reply reply = narrows("plan " + scenarios + "hppm_case3.yaml --planner rrt --time 0.05 --json -");
    EXPECT_EQ(reply.code, 1);
    EXPECT_NE(nlohmann::json::parse(reply.out).at("outcome"), "solved");
}

TEST_F(CommandLine, PlanWritesTheMotionThatFollowsThePath)
{
    const std::string csv = folder_ + "/motion.csv";
    const Reply reply = narrows("plan " + small + " --planner rrtconnect --limits 1.5,4,20 --rate 500 --json - " +
                                "--trajectory " + csv);
    ASSERT_EQ(reply.code, 0) << reply.err;
    const nlohmann::json json = nlohmann::json::parse(reply.out);
    const nlohmann::json waypoints = json.at("path").at("angles");
    EXPECT_LE(json.at("duration"), json.at("stop_duration"));
    std::istringstream lines(readFile(csv));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line.rfind("time,position_1,velocity_1,acceleration_1,jerk_1,position_2,", 0), 0u);
    std::vector<std::vector<double>> rows;
    while (std::getline(lines, line))
    {
        rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');)
            rows.back().push_back(std::stod(cell));
    }
    ASSERT_EQ(rows.size(), 1 + std::ceil(500.0 * json.at("duration").get<double>()));
    EXPECT_EQ(rows.back()[0], json.at("duration"));
    double fastest = 0.0;
    for (const std::vector<double> &row : rows)
    {
        ASSERT_EQ(row.size(), 1 + 4 * waypoints[0].size());
        for (std::size_t joint = 0; joint < waypoints[0].size(); ++joint)
        {
            fastest = std::max(fastest, std::abs(row[2 + 4 * joint]));
            EXPECT_LE(std::abs(row[2 + 4 * joint]), 1.5 + 1e-8);
            EXPECT_LE(std::abs(row[3 + 4 * joint]), 4.0 + 1e-8);
            EXPECT_LE(std::abs(row[4 + 4 * joint]), 20.0 + 1e-7);
        }
    }
    EXPECT_GT(fastest, 0.9 * json.at("peak_velocity").get<double>());
    for (std::size_t joint = 0; joint < waypoints[0].size(); ++joint)
    {
        EXPECT_NEAR(rows.front()[1 + 4 * joint], waypoints.front()[joint], 1e-12);
        EXPECT_NEAR(rows.back()[1 + 4 * joint], waypoints.back()[joint], 1e-12);
    }
    const Reply words = narrows("plan " + small + " --planner rrtconnect --limits 1.5,4,20");
    EXPECT_EQ(words.code, 0);
    EXPECT_THAT(words.out, HasSubstr("duration"));
    EXPECT_THAT(words.out, HasSubstr("peak velocity"));
}

TEST_F(CommandLine, PlanWithoutAPathWritesNoMotion)
{
    const std::string csv = folder_ + "/motion.csv";
    const Reply reply = narrows("plan " + scenarios + "hppm_case3.yaml --planner rrt --time 0.05 --limits 1,1,1 " +
                                "--trajectory " + csv);
    EXPECT_EQ(reply.code, 1);
    EXPECT_THAT(reply.err, HasSubstr("was not written: there is no path"));
    EXPECT_FALSE(std::filesystem::exists(csv));
}

TEST_F(CommandLine, PlanRefusesWhatAreNoLimits)
{
    const std::string plan = "plan " + small + " --planner rrtconnect --trajectory " + folder_ + "/motion.csv";
    for (const char *limits : {"0,1,1", "1,-1,1", "1,1,inf", "1,nan,1", "1,1", "1,1,1,1", "fast", "1,,1"})
    {
        const Reply reply = narrows(plan + " --limits " + limits);
        EXPECT_EQ(reply.code, 2) << limits;
        EXPECT_THAT(reply.err, HasSubstr("limits are three positive numbers")) << limits;
    }
    EXPECT_THAT(narrows(plan).err, HasSubstr("--trajectory needs --limits"));
    EXPECT_EQ(narrows(plan).code, 2);
    for (const char *rate : {"0", "-5", "often", "1e300"})
        EXPECT_EQ(narrows(plan + " --limits 1,1,1 --rate " + rate).code, 2) << rate;
    EXPECT_FALSE(std::filesystem::exists(folder_ + "/motion.csv"));
}

TEST_F(CommandLine, PlanRefusesWrongNamesAndValues)
{
    const std::string plan = "plan " + small + " --planner ";
    for (const auto &[arguments, word] : std::vector<std::pair<std::string, std::string>>{
             {plan + "rrtconect", "rrtconnect"},
             {plan + "rrtconnect --param rnage=1", "rnage"},
             {plan + "rrtconnect --param range=far", "far"},
             {plan + "rrtconnect --param range", "range"},
             {plan + "rrtconnect --checker magic", "magic"},
             {plan + "rrtconnect --motion sometimes", "sometimes"},
             {plan + "rrtconnect --space sideways", "sideways"},
             {plan + "rrtconnect --seed 0", "seed"},
             {plan + "rrtconnect --time -1", "time"},
             {plan + "rrtconnect --json " + folder_ + "/none/a.json", "a.json"},
             {"plan nowhere.yaml --planner rrtconnect", "nowhere.yaml"}})
    {
        const Reply reply = narrows(arguments);
        EXPECT_EQ(reply.code, 2) << arguments;
        EXPECT_THAT(reply.err, HasSubstr(word)) << arguments;
    }
}

TEST_F(CommandLine, VerifyJudgesWhatPlanWrote)
{
    const std::string record = folder_ + "/record.json";
    ASSERT_EQ(narrows("plan " + small + " --planner biest --json " + record).code, 0);
    const Reply reply = narrows("verify " + small + " " + record);
    EXPECT_EQ(reply.code, 0);
    EXPECT_THAT(reply.out, HasSubstr("accepted: "));

    nlohmann::json rows = nlohmann::json::parse(readFile(record)).at("path").at("angles");
    EXPECT_EQ(narrows("verify " + small + " " + file("bare.json", rows.dump())).code, 0);
    EXPECT_EQ(narrows("verify " + small + " " + file("angles.json", nlohmann::json{{"angles", rows}}.dump())).code, 0);
    rows.back()[0] = 0.0;
    const Reply refused = narrows("verify " + small + " " + file("bad.json", rows.dump()));
    EXPECT_EQ(refused.code, 1);
    EXPECT_THAT(refused.out, HasSubstr("refused: "));
}

TEST_F(CommandLine, VerifyTakesAnglesInTheScenariosConvention)
{
    // A straight arm that swings by a quarter: in relative angles only the first joint moves.
    const std::string scenario = file("relative.yaml", R"(format: narrows/scenario/1
name: relative
robot: {kind: planar_arm, base: [0, 0], links: [{length: 1}, {length: 1}], radius: 0, angles: relative, limits: none}
obstacles: [{name: C, kind: circle, center: [0, 5], radius: 1}]
start: {angles: [0, 0]}
goal: {angles: [90 deg, 0]}
)");
    EXPECT_EQ(narrows("verify " + scenario + " " + file("p.json", "[[0, 0], [1.5707963267948966, 0]]")).code, 0);
    EXPECT_EQ(
        narrows("verify " + scenario + " " + file("q.json", "[[0, 0], [1.5707963267948966, 1.5707963267948966]]")).code,
        1);
}

TEST_F(CommandLine, VerifySaysWhichTipWasNotReached)
{
    const auto scenario = [&](const std::string &tips)
    {
        return file("tips.yaml",
                    "format: narrows/scenario/1\nname: tips\nrobot: {kind: spatial_arm, links: [{length: 1}, "
                    "{length: 1}]}\nobstacles: []\nstart: {joints: [[0, 0], [0, 0]]}\n"
                    "goal: {tip_path: [" +
                        tips + "], tolerance: 1e-6}\n");
    };
    const std::string path = file("up.json", "[[0, 0, 0, 0], [-1.5707963267948966, 0, 0, 0]]");
    EXPECT_EQ(narrows("verify " + scenario("[2, 0, 0], [0, 0, 2]") + " " + path).code, 0);
    const Reply refused = narrows("verify " + scenario("[2, 0, 0], [0, 0, 2], [2, 0, 0]") + " " + path);
    EXPECT_EQ(refused.code, 1);
    EXPECT_THAT(refused.out, testing::StartsWith("refused: tip_path"));
    EXPECT_THAT(refused.out, HasSubstr(", tip 2\n"));
}

TEST_F(CommandLine, GenerateWritesAScenarioInSpace)
{
    const std::string written = folder_ + "/pipes.yaml";
    EXPECT_EQ(narrows("generate pipes --param obstacles=3 --param seed=2 -o " + written).code, 0);
    EXPECT_EQ(readScenario(written).spatial().model->obstacles.size(), 3u);
    EXPECT_EQ(readScenario(written).name, "pipes_obstacles3_seed2");
}

TEST_F(CommandLine, GenerateWritesAScenarioAndAPathThatTheVerifierAccepts)
{
    const std::string scenario = folder_ + "/slab.yaml";
    const std::string witness = folder_ + "/witness.json";
    const std::string slab = "generate slab --param half_width=1e-3 --param seed=7";
    const Reply reply = narrows(slab + " -o " + scenario + " --witness " + witness);
    EXPECT_EQ(reply.code, 0) << reply.err;
    EXPECT_THAT(reply.out, IsEmpty());
    EXPECT_EQ(readScenario(scenario).name, "slab_half_width1e-3_seed7");
    EXPECT_THAT(narrows("verify " + scenario + " " + witness).out, HasSubstr("accepted"));
    EXPECT_EQ(narrows(slab).out, readFile(scenario));
    EXPECT_THAT(narrows(slab + " --name mine").out, HasSubstr("name: mine\n"));
    EXPECT_THAT(narrows("show family slab").out, HasSubstr("half_width = 0.01   in 1e-08 to 0.2"));
}

TEST_F(CommandLine, GenerateRefusesWhatItCannotDo)
{
    for (const auto &[arguments, word] : std::vector<std::pair<std::string, std::string>>{
             {"generate slap", "did you mean 'slab'?"},
             {"generate slab --param seed", "expected name=value"},
             {"generate slab --param sed=1", "did you mean 'seed'?"},
             {"generate slab --param seed=x", "seed: must be a whole number"},
             {"generate slab --name 'two words'", "must be one word"},
             {"generate slab -o " + folder_ + "/none/a.yaml", "a.yaml: cannot be written"},
             {"generate pipes --param obstacles=10 --param margin=500", "no such scene was found in 20000 draws"},
             {"generate pipes --witness " + folder_ + "/witness.json", "no witness is known"},
             {"generate corridor --witness " + folder_ + "/witness.json", "no witness is known"},
             {"show family slap", "did you mean 'slab'?"}})
    {
        const Reply reply = narrows(arguments);
        EXPECT_EQ(reply.code, 2) << arguments;
        EXPECT_THAT(reply.err, HasSubstr(word)) << arguments;
        EXPECT_THAT(reply.out, IsEmpty()) << arguments;
    }
}

TEST_F(CommandLine, SweepsOfAFamilyCanBeRecheckedFromTheDatabaseAlone)
{
    const std::string database = folder_ + "/sweep.db";
    const std::string sweep = file("sweep.cfg", "[problem]\nname = test\nscenario = " + scenarios +
                                                    "slab.yaml\n[sweep]\ngenerate.half_width = 0.1\n"
                                                    "generate.seed = 1..3\n"
                                                    "[benchmark]\nrun_count = 1\nwarm_up = 0\nsave_paths = all\n"
                                                    "[planner]\nrrtconnect =\n");
    const Reply bench = narrows("bench " + sweep + " --db " + database);
    EXPECT_EQ(bench.code, 0) << bench.err;
    EXPECT_THAT(bench.out, HasSubstr("slab_half_width0.1_analytic (3 instances, 3 of them solved by some planner)"));
    EXPECT_THAT(narrows("recheck " + database).out, HasSubstr("3 accepted and 0 refused paths"));
    EXPECT_EQ(narrows("bench " + sweep + " --resume --db " + database).code, 0);
}

TEST_F(CommandLine, VerifyRefusesMalformedPaths)
{
    for (const char *text :
         {"", "{", "3", "{\"path\": null}", "{\"angles\": 1}", "[[0, 0]]", "[[0, 0, \"x\"]]", "[1, 2]"})
    {
        const Reply reply = narrows("verify " + small + " " + file("path.json", text));
        EXPECT_EQ(reply.code, 2) << text;
        EXPECT_THAT(reply.err, HasSubstr("path.json")) << text;
    }
    EXPECT_EQ(narrows("verify " + small + " " + folder_ + "/nothing.json").code, 2);
    EXPECT_EQ(narrows("verify " + small + " " + file("empty.json", "[]")).code, 1);  // well-formed, but no path
}

TEST_F(CommandLine, BenchSummaryAndRecheckWorkTogether)
{
    const std::string database = folder_ + "/results.db";
    const std::string bench = "bench " + experiment() + " --db " + database;
    const Reply first = narrows(bench + " --jobs 1");
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_THAT(first.out, HasSubstr("rrtconnect"));
    EXPECT_THAT(first.err, HasSubstr("4 of 4 runs"));

    const std::string before = narrows("summary " + database).out;
    EXPECT_EQ(before, first.out);
    EXPECT_EQ(narrows(bench).code, 2);
    EXPECT_EQ(narrows(bench + " --resume").code, 0);
    const std::string fresh = folder_ + "/fresh.db";
    EXPECT_EQ(narrows("bench " + experiment() + " --resume --db " + fresh).code, 0);  // nothing to go on with: begin
    EXPECT_EQ(narrows("summary " + fresh).code, 0);
    EXPECT_EQ(narrows("summary " + database).out, before);
    EXPECT_THAT(narrows("summary --markdown " + database).out, HasSubstr("| rrtconnect | 2/2 |"));

    const Reply recheck = narrows("recheck --step 1e-2 " + database);
    EXPECT_EQ(recheck.code, 0) << recheck.out;
    EXPECT_THAT(recheck.out, HasSubstr("4 accepted and 0 refused paths"));
    EXPECT_EQ(narrows("recheck --step 0 " + database).code, 2);
}

TEST_F(CommandLine, BenchWithOmplsEngineStoresRowsAndLogs)
{
    const std::string database = folder_ + "/ompl.db";
    const Reply reply = narrows("bench " + experiment() + " --engine ompl --db " + database);
    EXPECT_EQ(reply.code, 0) << reply.err;
    EXPECT_THAT(narrows("summary " + database).out, HasSubstr("biest"));
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/ompl_gap-small_analytic.log"));
}

TEST_F(CommandLine, RecheckFindsAPathThatCollides)
{
    const std::string database = folder_ + "/results.db";
    ASSERT_EQ(narrows("bench " + experiment() + " --db " + database).code, 0);
    // Straight through the obstacle "right", claimed to be verified.
    SQLite::Database(database, SQLite::OPEN_READWRITE).exec("UPDATE paths SET angles = '[[0,0,0],[1.22,1.05,0.87]]'");
    const Reply reply = narrows("recheck --step 1e-2 " + database);
    EXPECT_EQ(reply.code, 1);
    EXPECT_THAT(reply.out, HasSubstr("was accepted, is refused now"));
}

TEST_F(CommandLine, ForeignDatabasesAreCode2)
{
    const std::string text = file("text.db", "not a database");
    for (const std::string command : {"summary ", "recheck ", "report -o /proc/none "})
    {
        EXPECT_EQ(narrows(command + text).code, 2);
        EXPECT_EQ(narrows(command + folder_ + "/none.db").code, 2);
        EXPECT_EQ(narrows(command + folder_ + "/" + std::string(300, 'x')).code, 2);
    }
    EXPECT_EQ(narrows("bench " + experiment() + " --resume --db " + text).code, 2);
    EXPECT_EQ(narrows("bench " + experiment() + " --db /proc/none/a.db").code, 2);
}

TEST_F(CommandLine, ListsAndShows)
{
    EXPECT_THAT(narrows("list planners").out, HasSubstr("rrtconnect"));
    EXPECT_THAT(narrows("list scenarios").out, HasSubstr("gap_small.yaml"));
    EXPECT_THAT(narrows("list metrics").out, HasSubstr("state_checks"));
    EXPECT_THAT(narrows("list families").out, HasSubstr("tube"));
    for (const char *kind : {"planners", "scenarios", "families", "metrics"})
        EXPECT_FALSE(nlohmann::json::parse(narrows(std::string("list --json ") + kind).out).at(kind).empty());
    const Reply shown = narrows("show planner rrtconnect");
    EXPECT_EQ(shown.code, 0);
    EXPECT_THAT(shown.out, HasSubstr("range = "));
    EXPECT_EQ(narrows("show planner nobody").code, 2);
}

TEST_F(CommandLine, ShowsWhatEveryParameterOfEveryPlannerMeans)
{
    const nlohmann::json planners = nlohmann::json::parse(narrows("list planners --json").out);
    for (const auto &planner : planners.at("planners"))
    {
        const Reply reply = narrows("show planner --json " + planner.at("name").get<std::string>());
        ASSERT_EQ(reply.code, 0) << planner;
        for (const auto &parameter : nlohmann::json::parse(reply.out).at("parameters"))
            EXPECT_NE(parameter.at("meaning"), "") << planner.at("name") << " " << parameter.at("name");
    }
}

TEST_F(CommandLine, EveryBadScenarioIsCode2NamingFileLineAndKey)
{
    int count = 0;
    for (const auto &entry : std::filesystem::directory_iterator(NARROWS_SOURCE_DIR "/tests/data/bad"))
    {
        if (entry.path().extension() != ".yaml")
            continue;
        ++count;
        const Reply reply = narrows("plan " + entry.path().string() + " --planner rrtconnect");
        EXPECT_EQ(reply.code, 2) << entry.path();
        EXPECT_THAT(reply.out, IsEmpty()) << entry.path();
        try
        {
            readScenario(entry.path().string());
            ADD_FAILURE() << entry.path() << " is read";
        }
        catch (const InputError &error)
        {
            for (const InputFault &fault : error.faults())
                EXPECT_THAT(reply.err, HasSubstr(fault.text()));
        }
    }
    EXPECT_GE(count, 25);
}

TEST_F(CommandLine, EveryBadExperimentIsCode2)
{
    for (const auto &entry : std::filesystem::directory_iterator(NARROWS_SOURCE_DIR "/tests/data/bad_experiments"))
    {
        const Reply reply = narrows("bench " + entry.path().string());
        EXPECT_EQ(reply.code, 2) << entry.path();
        EXPECT_FALSE(reply.err.empty()) << entry.path();
    }
}
}  // namespace
}  // namespace narrows
