// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/World.h"

#include <algorithm>

namespace narrows
{
namespace
{
double longestWayOf(const PlanarArm &arm, ConfigurationRef delta)
{
    Eigen::VectorXd ways;
    Eigen::VectorXd bends;
    arm.motionBounds(delta, ways, bends);
    // The bounds are about the links' axes; their surface is off by the radius.
    return (ways + arm.radius() * delta.tail(arm.linkCount()).cwiseAbs()).maxCoeff();
}

double longestWayOf(const SpatialArm &arm, ConfigurationRef delta)
{
    Eigen::VectorXd ways;
    Eigen::VectorXd bends;
    Eigen::VectorXd turns;
    arm.motionBounds(delta, ways, bends, turns);
    double longest = 0.0;
    for (int link = 0; link < arm.linkCount(); ++link)
        longest = std::max(longest, ways[link] + turns[link] * arm.links()[link].radius);
    return longest;
}
}  // namespace

int dimensionOf(const World &world)
{
    return std::visit([](const auto &one) { return one.model->arm.dimension(); }, world);
}

Eigen::VectorXd fromFile(const World &world, ConfigurationRef row)
{
    const auto *planar = std::get_if<PlanarWorld>(&world);
    return planar != nullptr ? planar->model->arm.toAbsolute(row, planar->convention) : Eigen::VectorXd(row);
}

Eigen::VectorXd toFile(const World &world, ConfigurationRef q)
{
    const auto *planar = std::get_if<PlanarWorld>(&world);
    return planar != nullptr ? planar->model->arm.fromAbsolute(q, planar->convention) : Eigen::VectorXd(q);
}

double longestWay(const World &world, ConfigurationRef delta)
{
    return std::visit([&](const auto &one) { return longestWayOf(one.model->arm, delta); }, world);
}

std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const World &world)
{
    return std::visit([&](const auto &one) { return makeArmChecker(name, *one.model); }, world);
}

Verdict verify(const World &world, const std::vector<Eigen::VectorXd> &path, const VerifierOptions &options)
{
    return std::visit([&](const auto &one) { return verify(*one.model, one.task, path, options); }, world);
}
}  // namespace narrows
