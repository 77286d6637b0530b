// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ArmDecomposition.h"

#include <stdexcept>

#include "spaces/PullTip.h"

namespace narrows
{
namespace
{
constexpr int slices = 16;      ///< cells along each axis: an eighth of the reach wide
constexpr int attempts = 5;     ///< per request; XXL asks again anyway
constexpr double spread = 0.3;  ///< standard deviation of a seed's perturbation, per joint

const PlanarArmStateSpace &armSpace(const ob::SpaceInformationPtr &si)
{
    const auto *space = dynamic_cast<const PlanarArmStateSpace *>(si->getStateSpace().get());
    if (space == nullptr)
        throw std::invalid_argument("a decomposition by the tip's position needs a planar arm");
    return *space;
}

ob::RealVectorBounds workspace(const PlanarArm &arm)
{
    // A little wider than the reach: OMPL takes a point on the upper border for one of the next row.
    const double reach = 1.001 * arm.reach();
    Eigen::Vector2d lower = arm.base();
    Eigen::Vector2d upper = arm.base();
    if (arm.slide())
    {
        const Eigen::Vector2d first = arm.base() + arm.slide()->lower * arm.slide()->axis;
        const Eigen::Vector2d last = arm.base() + arm.slide()->upper * arm.slide()->axis;
        lower = first.cwiseMin(last);
        upper = first.cwiseMax(last);
    }
    ob::RealVectorBounds bounds(2);
    for (unsigned int i = 0; i < 2; ++i)
    {
        bounds.setLow(i, lower[i] - reach);
        bounds.setHigh(i, upper[i] + reach);
    }
    return bounds;
}
}  // namespace

ArmDecomposition::ArmDecomposition(const ob::SpaceInformationPtr &si)
  : og::XXLPositionDecomposition(workspace(armSpace(si).arm()), {slices, slices}),
    si_(si.get()),
    space_(&armSpace(si)),
    sampler_(space_->allocDefaultStateSampler())
{
}

bool ArmDecomposition::sampleFromRegion(int region, ob::State *state, const ob::State *seed) const
{
    const int tip = space_->lastLink();
    for (int attempt = 0; attempt < attempts; ++attempt)
    {
        if (seed != nullptr)
            sampler_->sampleGaussian(state, seed, spread);
        else
            sampler_->sampleUniform(state);
        const TipGoal goal{tip, randomPoint(region), cellSizes_[0]};
        if (pullTip(*space_, goal, state) && locateRegion(state) == region && si_->isValid(state))
            return true;
    }
    return false;
}

bool ArmDecomposition::sampleFromRegion(int region, ob::State *state, const ob::State *seed, int /*layer*/) const
{
    return sampleFromRegion(region, state, seed);
}

void ArmDecomposition::project(const ob::State *state, std::vector<double> &position, int /*layer*/) const
{
    const Eigen::Vector2d tip = space_->tip(state, space_->lastLink());
    position = {tip.x(), tip.y()};
}

void ArmDecomposition::project(const ob::State *state, std::vector<int> &regions) const
{
    regions = {locateRegion(state)};
}

Eigen::Vector2d ArmDecomposition::randomPoint(int region) const
{
    std::vector<int> cell;
    ridToGridCell(region, cell);
    Eigen::Vector2d point;
    for (int i = 0; i < 2; ++i)
        point[i] = bounds_.low[i] + (cell[i] + rng_.uniform01()) * cellSizes_[i];
    return point;
}
}  // namespace narrows
