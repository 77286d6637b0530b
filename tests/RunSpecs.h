// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "benchmark/Record.h"

namespace narrows
{
/// A run on the small scenario that anything can plan.
inline RunSpec smallRun(const std::string &planner, std::uint32_t seed = 1)
{
    static const auto scenario =
        std::make_shared<const Scenario>(readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/gap_small.yaml"));
    RunSpec spec;
    spec.instance = scenario->name;
    spec.scenario = scenario;
    spec.planner = planner;
    spec.label = planner;
    spec.seed = seed;
    spec.timeLimit = 5.0;
    return spec;
}

/// The record as JSON without what may differ between two runs of one spec.
inline nlohmann::json repeatable(const RunSpec &spec, const Record &record)
{
    nlohmann::json json = nlohmann::json::parse(toJson(spec, record));
    for (const char *key : {"time_s", "cpu_s", "simplification_time_s", "peak_memory_kb", "cpus", "shares_core"})
        json.erase(key);
    return json;
}
}  // namespace narrows
