// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "benchmark/Campaign.h"
#include "benchmark/Metrics.h"
#include "benchmark/ResultStore.h"

namespace narrows
{
/// A small campaign of 40 runs and a folder for its databases.
class CampaignFolder : public testing::Test
{
protected:
    CampaignFolder()
    {
        std::filesystem::create_directories(folder_);
        const std::string file = folder_ + "/test.cfg";
        std::ofstream(file) << "[problem]\nname = test\nscenario = " << NARROWS_SOURCE_DIR
                            << "/experiments/scenarios/gap_small.yaml, " << NARROWS_SOURCE_DIR
                            << "/experiments/scenarios/hppm_case1.yaml\n"
                               "[benchmark]\nrun_count = 5\nwarm_up = 0\nsimplify = 1\nsave_paths = shortest\n"
                               "time_limit = 20\njobs = 2\n"
                               "[planner]\nrrtconnect =\nbiest =\nkpiece1 =\nrrtconnect =\nrrtconnect.range = 0.5\n";
        experiment_ = readExperiment(file);
    }
    ~CampaignFolder() override { std::filesystem::remove_all(folder_); }

    CampaignResult run(const std::string &database, bool resume = false, std::function<bool()> stop = {},
                       const Shard &shard = {}) const
    {
        CampaignOptions options;
        options.database = folder_ + "/" + database;
        options.resume = resume;
        options.stop = std::move(stop);
        options.shard = shard;
        return runCampaign(experiment_, options);
    }

    /// Every run's repeatable columns and stored path as one text each, in the order of the plan, not of the rows.
    std::vector<std::string> rows(const std::string &name) const
    {
        std::string columns;
        for (const Metric &metric : metrics())
            if (!isMeasured(metric))
                columns += ", runs." + metric.name;
        SQLite::Database database(folder_ + "/" + name);
        SQLite::Statement query(database, "SELECT experiments.name, plannerConfigs.name, settings" + columns +
                                              ", angles FROM runs JOIN experiments ON experiments.id = experimentid "
                                              "JOIN plannerConfigs ON plannerConfigs.id = plannerid "
                                              "LEFT JOIN paths ON runid = runs.id ORDER BY 1, 2, 3, run");
        std::vector<std::string> texts;
        while (query.executeStep())
        {
            std::ostringstream text;
            for (int i = 0; i < query.getColumnCount(); ++i)
                text << (query.getColumn(i).isNull() ? "NULL" : query.getColumn(i).getString()) << " | ";
            texts.push_back(text.str());
        }
        return texts;
    }

    std::string folder_ = testing::TempDir() + "campaign" + std::to_string(getpid());
    Experiment experiment_;
};
}  // namespace narrows
