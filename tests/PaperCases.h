// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/ArmHomotopy.h"
#include "kernel/Trace.h"
#include "planners/NumberList.h"
#include "scenario/Scenario.h"

namespace narrows
{
/// The paper's case study 1, 2 or 3, from its scenario file.
inline Scenario paperCase(int number)
{
    return readScenario(NARROWS_SOURCE_DIR "/experiments/scenarios/hppm_case" + std::to_string(number) + ".yaml");
}

struct PaperRecipe
{
    ArmHomotopy homotopy;
    TraceWindow window;
};

/// What a scenario prescribes for HPPM, as the kernel takes it.
/// \param repulsion instead of the prescribed one, if not empty
/// \param points instead of the prescribed number per link, if not 0
inline PaperRecipe paperRecipe(int number, std::vector<double> repulsion = {}, int points = 0)
{
    const Scenario scenario = paperCase(number);
    const std::map<std::string, std::string> &recipe = scenario.methods.at("hppm");
    if (repulsion.empty())
    {
        const Eigen::VectorXd prescribed = parseVector(recipe.at("repulsion"));
        repulsion.assign(prescribed.data(), prescribed.data() + prescribed.size());
    }
    ArmRepulsion poles(*scenario.model, repulsion, points > 0 ? points : std::stoi(recipe.at("points_per_link")));
    const Eigen::VectorXd &start = scenario.task.start;
    const Eigen::VectorXd &goal = std::get<Eigen::VectorXd>(scenario.task.goal);
    TraceWindow window;
    if (recipe.count("lambda_max") > 0)
        window.lambdaMax = std::stod(recipe.at("lambda_max"));
    if (recipe.count("orientation") > 0)
        window.decreasing = recipe.at("orientation") == "decreasing";
    if (recipe.count("direction") > 0)
        return {ArmHomotopy::fromDirection(poles, start, goal, parseVector(recipe.at("direction")),
                                           std::stod(recipe.at("strength"))),
                window};
    return {ArmHomotopy::fromRows(poles, start, goal, parseMatrix(recipe.at("rows"))), window};
}
}  // namespace narrows
