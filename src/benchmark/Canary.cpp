// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Canary.h"

namespace narrows
{
RunSpec canaryRun()
{
    const std::string text =
        "format: narrows/scenario/1\nname: canary\n"
        "generate: {family: slab, links: 6, half_width: 1e-3, symmetric: true, seed: 1}\n";
    RunSpec spec;
    spec.instance = spec.group = spec.label = "canary";
    spec.scenario = std::make_shared<const Scenario>(parseScenario(text, "canary"));
    spec.problem.space = "absolute";
    spec.planner = "rrtconnect";
    spec.parameters = {{"range", "0.1"}};
    spec.warmUp = 0.01;
    return spec;
}

std::vector<std::optional<std::size_t>> withCanaries(std::size_t count, std::size_t interval)
{
    std::vector<std::optional<std::size_t>> turns;
    for (std::size_t i = 0; i < count; ++i)
    {
        if (interval > 0 && i % interval == 0)
            turns.push_back(std::nullopt);
        turns.push_back(i);
    }
    if (interval > 0 && count > 0)
        turns.push_back(std::nullopt);
    return turns;
}
}  // namespace narrows
