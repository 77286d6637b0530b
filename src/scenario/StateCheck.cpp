// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/StateCheck.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "validity/MovingArm.h"
#include "validity/PlanarChecker.h"
#include "validity/SpatialChecker.h"

namespace narrows
{
namespace
{
constexpr std::size_t mostNamed = 10;  // one bad state among many obstacles should not fill the screen

template <class Model, class AnyLink>
std::vector<std::string> obstaclesAt(const Model &model, const AnyLink &link)
{
    std::vector<std::string> names;
    for (const auto &obstacle : model.obstacles)
        if (!makeAnalyticChecker(Model{model.arm, {obstacle}})->clears(link))
            names.push_back(obstacle.name);
    return names;
}
}  // namespace

template <class Model>
void checkStateIsFree(const Field &field, const Model &model, const std::vector<int> &numbers, const Eigen::VectorXd &q)
{
    const auto checker = makeAnalyticChecker(model);
    MovingArm<std::decay_t<decltype(model.arm)>> arm;
    arm.rest(model.arm, q);
    std::vector<std::string> touches;
    for (int i = 0; i < model.arm.linkCount() && touches.size() < mostNamed; ++i)
    {
        if (!checker->clears(arm.link(i)))
            touches.push_back(fmt::format("link {} touches {}", numbers[static_cast<std::size_t>(i)],
                                          fmt::join(obstaclesAt(model, arm.link(i)), ", ")));
        for (int j = 0; model.selfCollision && j < i; ++j)
            if (!model.arm.areNeighbours(i, j) && !checker->clears(arm.link(i), arm.link(j)))
                touches.push_back(fmt::format("link {} touches link {}", numbers[static_cast<std::size_t>(i)],
                                              numbers[static_cast<std::size_t>(j)]));
    }
    if (!touches.empty())
        field.fault(fmt::format("in collision: {}", fmt::join(touches, "; ")));
}

template void checkStateIsFree(const Field &, const PlanarModel &, const std::vector<int> &, const Eigen::VectorXd &);
template void checkStateIsFree(const Field &, const SpatialModel &, const std::vector<int> &, const Eigen::VectorXd &);
}  // namespace narrows
