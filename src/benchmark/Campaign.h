// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>

#include "benchmark/Experiment.h"

namespace narrows
{
struct CampaignOptions
{
    std::string database;              ///< path of the file
    bool resume = false;               ///< do what an existing database lacks; begin one if there is none
    std::string engine = "isolated";   ///< isolated: a process per run | ompl: ompl::tools::Benchmark, in process
    int jobs = 0;                      ///< runs at a time; 0: as the experiment says
    Shard shard;                       ///< which of the campaign's runs belong into this database; by default all
    std::function<bool()> stop;        ///< true ends the campaign early; what is done stays. OMPL's engine does not ask
    std::ostream *progress = nullptr;  ///< where to say how far it is; nowhere if null
    bool terminal = false;             ///< is `progress` a terminal?
};

struct CampaignResult
{
    std::size_t planned = 0;   ///< runs of the whole campaign, or of the shard
    std::size_t existing = 0;  ///< that the database held already
    std::size_t done = 0;      ///< that were done now
    bool complete() const { return existing + done == planned; }
};

/// Does all runs of an experiment that its database does not hold yet.
/// \throws InputError if the database exists without `resume`, or does not fit the experiment.
CampaignResult runCampaign(const Experiment &experiment, const CampaignOptions &options);
}  // namespace narrows
