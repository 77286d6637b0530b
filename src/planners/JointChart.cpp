// SPDX-License-Identifier: BSD-3-Clause
#include "planners/JointChart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>

#include "spaces/PlanarArmStateSpace.h"

namespace narrows
{
namespace
{
using boost::math::double_constants::pi;
constexpr double leastMargin = 0.999;  ///< of pi: turns that surely go the way they are meant to

const double *valuesOf(const ob::State *state)
{
    return state->as<ob::RealVectorStateSpace::StateType>()->values;
}
}  // namespace

JointChart::JointChart(const ArmStateSpace &space)
{
    const Eigen::Index dimension = space.getDimension();
    std::vector<int> carriers(static_cast<std::size_t>(dimension), -1);
    bool relative = false, allWrap = true;
    if (const auto *planar = dynamic_cast<const PlanarArmStateSpace *>(&space))
    {
        const PlanarArm &arm = planar->arm();
        relative = planar->convention() == AngleConvention::Relative;
        for (int link = 0; link < arm.linkCount(); ++link)
        {
            const int joint = arm.firstAngle() + link, parent = arm.links()[static_cast<std::size_t>(link)].parent;
            carriers[static_cast<std::size_t>(joint)] = parent < 0 ? -1 : arm.firstAngle() + parent;
            allWrap = allWrap && space.wraps(static_cast<unsigned int>(joint));
        }
    }
    statesAreRelative_ = relative && allWrap;
    chartIsRelative_ = relative && !allWrap;
    carriers_ = chartIsRelative_ ? carriers : std::vector<int>(carriers.size(), -1);
    turning_ = chartIsRelative_ ? std::vector<int>(carriers.size(), -1) : carriers;
    parents_ = statesAreRelative_ ? carriers : std::vector<int>(carriers.size(), -1);
    periods_.resize(dimension);
    lower_.resize(dimension);
    upper_.resize(dimension);
    for (unsigned int j = 0; j < dimension; ++j)
    {
        wraps_.push_back(space.wraps(j));
        periods_[j] = space.wraps(j) ? 2.0 * pi : std::numeric_limits<double>::infinity();
        lower_[j] = space.getBounds().low[j];
        upper_[j] = space.getBounds().high[j];
    }
}

void JointChart::read(const ob::State *state, Eigen::VectorXd &x) const
{
    x = Eigen::Map<const Eigen::VectorXd>(valuesOf(state), dimension());
    for (Eigen::Index j = 0; statesAreRelative_ && j < dimension(); ++j)
        if (parents_[static_cast<std::size_t>(j)] >= 0)
            x[j] += x[parents_[static_cast<std::size_t>(j)]];
}

void JointChart::write(const Eigen::VectorXd &x, double *values) const
{
    for (Eigen::Index j = 0; j < dimension(); ++j)
    {
        const double value = turn(x, j);
        const bool wrap = wraps_[static_cast<std::size_t>(j)] != 0 && std::abs(value) > pi;
        values[j] = wrap ? std::remainder(value, 2.0 * pi) : value;
    }
}

void JointChart::enforceLimits(Eigen::VectorXd &x) const
{
    for (Eigen::Index j = 0; j < dimension(); ++j)
        if (!std::isfinite(periods_[j]))
            x[j] = std::clamp(x[j], lower_[j], upper_[j]);
}

void JointChart::toConfiguration(const Eigen::VectorXd &x, Eigen::VectorXd &q) const
{
    q = x;
    for (Eigen::Index j = 0; chartIsRelative_ && j < dimension(); ++j)
        if (carriers_[static_cast<std::size_t>(j)] >= 0)
            q[j] += q[carriers_[static_cast<std::size_t>(j)]];
}

Eigen::VectorXd JointChart::fromConfiguration(const Eigen::VectorXd &q) const
{
    Eigen::VectorXd x = q;
    for (Eigen::Index j = 0; chartIsRelative_ && j < dimension(); ++j)
        if (carriers_[static_cast<std::size_t>(j)] >= 0)
            x[j] -= q[carriers_[static_cast<std::size_t>(j)]];
    return x;
}

Eigen::VectorXd JointChart::gradient(const Eigen::VectorXd &byConfiguration) const
{
    Eigen::VectorXd result = byConfiguration;
    for (Eigen::Index j = dimension() - 1; chartIsRelative_ && j >= 0; --j)
        if (carriers_[static_cast<std::size_t>(j)] >= 0)
            result[carriers_[static_cast<std::size_t>(j)]] += result[j];
    return result;
}

void JointChart::wayOfTurns(const Eigen::VectorXd &turns, Eigen::VectorXd &way) const
{
    way = turns;
    for (Eigen::Index j = 0; j < dimension(); ++j)
        if (turning_[static_cast<std::size_t>(j)] >= 0)  // carriers come first
            way[j] += way[turning_[static_cast<std::size_t>(j)]];
}

void JointChart::shortWay(const Eigen::VectorXd &from, const Eigen::VectorXd &to, Eigen::VectorXd &way) const
{
    way = to - from;
    for (Eigen::Index j = 0; j < dimension(); ++j)
        if (2.0 * std::abs(way[j]) > periods_[j])
            way[j] = std::remainder(way[j], periods_[j]);
}

double JointChart::unambiguousPart(const Eigen::VectorXd &way) const
{
    double largest = 0.0;
    for (Eigen::Index j = 0; j < dimension(); ++j)
        if (wraps_[static_cast<std::size_t>(j)] != 0)
            largest = std::max(largest, std::abs(turn(way, j)));
    return largest > leastMargin * pi ? leastMargin * pi / largest : 1.0;
}
}  // namespace narrows
