// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PlanarChecker.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace narrows
{
bool armClears(const PlanarChecker &checker, const PlanarArm &arm, const std::vector<Eigen::Vector2d> &points)
{
    const std::vector<PlanarLink> &links = arm.links();
    for (std::size_t i = 0; i < links.size(); ++i)
        if (!checker.linkClears(points[links[i].parent + 1], points[i + 1], 0.0))
            return false;
    return true;
}

double armClearance(const PlanarChecker &checker, const PlanarArm &arm, const std::vector<Eigen::Vector2d> &points)
{
    double least = std::numeric_limits<double>::infinity();
    const std::vector<PlanarLink> &links = arm.links();
    for (std::size_t i = 0; i < links.size(); ++i)
        least = std::min(least, checker.linkClearance(points[links[i].parent + 1], points[i + 1]));
    return least;
}

std::unique_ptr<PlanarChecker> makeChecker(const std::string &name, const PlanarModel &model)
{
    if (name == "analytic")
        return makeAnalyticChecker(model);
    if (name == "fcl")
        return makeFclChecker(model);
    throw std::invalid_argument("checker \"" + name + "\" is unknown; there are analytic and fcl");
}
}  // namespace narrows
