// SPDX-License-Identifier: BSD-3-Clause
// Campaigns with planners that do what no planner should, beside good ones. NARROWS_FAULT_RUNS sets how many runs each
// planner has, NARROWS_FAULT_LIMIT their time limit in seconds (what a busy machine does not give them in four times
// that ends as a timeout).
#include <cstdlib>

#include <gmock/gmock.h>

#include "CampaignFolder.h"
#include "FaultPlanners.h"

namespace narrows
{
namespace
{
class FaultInjection : public CampaignFolder
{
protected:
    static std::string setting(const char *name, const char *otherwise)
    {
        const char *const text = std::getenv(name);
        return text != nullptr ? text : otherwise;
    }
    static std::string runCount() { return setting("NARROWS_FAULT_RUNS", "3"); }

    /// \param faults names of faulty planners
    void plan(const std::vector<std::string> &faults)
    {
        const std::string file = folder_ + "/faults.cfg";
        std::ofstream stream(file);
        stream << "[problem]\nname = faults\nscenario = " << NARROWS_SOURCE_DIR
               << "/experiments/scenarios/gap_small.yaml\n[benchmark]\nwarm_up = 0\nsave_paths = all\ntime_limit = "
               << setting("NARROWS_FAULT_LIMIT", "2") << "\nmem_limit = 32\njobs = 2\nrun_count = " << runCount()
               << "\n[planner]\nrrtconnect =\nbkpiece1 =\n";
        for (const std::string &fault : faults)
            stream << fault << " =\n";
        stream.close();
        experiment_ = readExperiment(file);
    }

    /// Of the planners that do nothing wrong.
    std::vector<std::string> goodRows(const std::string &name) const
    {
        std::vector<std::string> good;
        for (const std::string &row : rows(name))
            if (row.find("planner=fault_") == std::string::npos)
                good.push_back(row);
        return good;
    }
};

TEST_F(FaultInjection, CostsOnlyTheFaultyRuns)
{
    std::vector<std::string> names;
    std::map<std::string, Fault> faults;
    for (const Fault &fault : faultPlanners())
        faults.emplace(fault.planner, fault);
    for (const char *name :
         {"segfault", "abort", "int", "memory", "spin", "children", "flood", "stack", "nan", "no_path", "heap", "exit"})
        if (faults.count("fault_" + std::string(name)) > 0)  // not all under AddressSanitizer
            names.push_back("fault_" + std::string(name));
    plan({});
    run("good.db");
    plan(names);
    const CampaignResult result = run("mixed.db");
    EXPECT_EQ(result.planned, (names.size() + 2) * std::stoul(runCount()));
    EXPECT_TRUE(result.complete());

    const ResultStore store = ResultStore::open(folder_ + "/mixed.db");
    EXPECT_TRUE(store.missing(expand(experiment_)).empty());
    const std::vector<RunRow> runs = store.runs();
    EXPECT_EQ(runs.size(), result.planned);
    for (const RunRow &row : runs)
    {
        const auto fault = faults.find(row.label);
        const Outcome expected = fault == faults.end() ? Outcome::Solved : fault->second.outcome;
        EXPECT_EQ(toString(row.outcome), toString(expected)) << row.label << " " << row.run << ": " << row.reason;
        const std::string reason = fault == faults.end() ? "" : fault->second.reason;
        EXPECT_THAT(row.reason, testing::HasSubstr(reason)) << row.label;
    }
    EXPECT_EQ(goodRows("mixed.db"), rows("good.db"));
    EXPECT_THAT(store.examine().faults, testing::IsEmpty());
}
}  // namespace
}  // namespace narrows
