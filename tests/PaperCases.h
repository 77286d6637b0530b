// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/FullHomotopy.h"
#include "kernel/PointRepulsion.h"
#include "kernel/SliceHomotopy.h"
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
    FullHomotopy full;
    SliceHomotopy slice;  ///< the same curve in its plane
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
    const auto poles = std::make_shared<PointRepulsion>(*scenario.planar().model, repulsion,
                                                        points > 0 ? points : std::stoi(recipe.at("points_per_link")));
    const Eigen::VectorXd &start = scenario.planar().task.start;
    const Eigen::VectorXd &goal = std::get<Eigen::VectorXd>(scenario.planar().task.goal);
    TraceWindow window;
    if (recipe.count("lambda_max") > 0)
        window.lambdaMax = std::stod(recipe.at("lambda_max"));
    if (recipe.count("orientation") > 0)
        window.decreasing = recipe.at("orientation") == "decreasing";
    const Eigen::MatrixXd rows = recipe.count("direction") > 0 ? rowsOfSlice(parseVector(recipe.at("direction")),
                                                                             std::stod(recipe.at("strength")))
                                                               : parseMatrix(recipe.at("rows"));
    return {FullHomotopy(poles, start, goal, rows), SliceHomotopy::fromRows(poles, start, goal, rows), window};
}
}  // namespace narrows
