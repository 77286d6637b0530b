// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ArmDecomposition.h"

#include <stdexcept>
#include <type_traits>

#include <Eigen/Geometry>

#include "spaces/PullTip.h"

namespace narrows
{
namespace
{
constexpr int slices = 16;      ///< cells along each axis: an eighth of the reach wide
constexpr int attempts = 5;     ///< per request; XXL asks again anyway
constexpr double spread = 0.3;  ///< standard deviation of a seed's perturbation, per joint

template <class Space>
const Space &armSpace(const ob::SpaceInformationPtr &si)
{
    const auto *space = dynamic_cast<const Space *>(si->getStateSpace().get());
    if (space == nullptr)
        throw std::invalid_argument("a decomposition by the tip's position needs an arm of its dimension");
    return *space;
}

/// Where the base can be, as a box, and how far from there the arm reaches.
Eigen::AlignedBox2d bases(const PlanarArm &arm, double &reach)
{
    reach = arm.reach();
    Eigen::AlignedBox2d box(arm.base());
    if (arm.slide())
    {
        box = Eigen::AlignedBox2d(Eigen::Vector2d(arm.base() + arm.slide()->lower * arm.slide()->axis));
        box.extend(Eigen::Vector2d(arm.base() + arm.slide()->upper * arm.slide()->axis));
    }
    return box;
}

/// A slide counts if all else hangs on it.
Eigen::AlignedBox3d bases(const SpatialArm &arm, double &reach)
{
    reach = arm.reach();
    Eigen::AlignedBox3d box;
    int roots = 0;
    for (const SpatialJoint &joint : arm.joints())
        if (joint.parent < 0)
        {
            box.extend(Eigen::Vector3d(joint.offset.translation()));
            ++roots;
        }
    const SpatialJoint &first = arm.joints().front();
    if (roots != 1 || first.kind != SpatialJoint::Kind::Prismatic)
        return box;
    reach -= std::max(std::abs(first.limits->lower), std::abs(first.limits->upper));
    box = Eigen::AlignedBox3d(Eigen::Vector3d(first.offset * (first.limits->lower * first.axis)));
    return box.extend(Eigen::Vector3d(first.offset * (first.limits->upper * first.axis)));
}

template <class Arm>
ob::RealVectorBounds workspace(const Arm &arm)
{
    double reach = 0.0;
    const auto box = bases(arm, reach);
    // A little wider than the reach: OMPL takes a point on the upper border for one of the next row.
    reach *= 1.001;
    ob::RealVectorBounds bounds(Arm::Dim);
    for (unsigned int i = 0; i < Arm::Dim; ++i)
    {
        bounds.setLow(i, box.min()[i] - reach);
        bounds.setHigh(i, box.max()[i] + reach);
    }
    return bounds;
}
}  // namespace

template <class Space>
ArmDecomposition<Space>::ArmDecomposition(const ob::SpaceInformationPtr &si)
  : og::XXLPositionDecomposition(workspace(armSpace<Space>(si).arm()), std::vector<int>(Space::tipDimension, slices)),
    si_(si.get()),
    space_(&armSpace<Space>(si)),
    sampler_(space_->allocDefaultStateSampler())
{
}

template <class Space>
bool ArmDecomposition<Space>::sampleFromRegion(int region, ob::State *state, const ob::State *near) const
{
    using Goal = std::conditional_t<Space::tipDimension == 2, TipGoal, SpatialTipGoal>;
    const int tip = space_->lastLink();
    for (int attempt = 0; attempt < attempts; ++attempt)
    {
        if (near != nullptr)
            sampler_->sampleGaussian(state, near, spread);
        else
            sampler_->sampleUniform(state);
        const Goal goal{tip, randomPoint(region), cellSizes_[0]};
        if (pullTip(*space_, goal, state) && locateRegion(state) == region && si_->isValid(state))
            return true;
    }
    return false;
}

template <class Space>
bool ArmDecomposition<Space>::sampleFromRegion(int region, ob::State *state, const ob::State *near, int /*layer*/) const
{
    return sampleFromRegion(region, state, near);
}

template <class Space>
void ArmDecomposition<Space>::project(const ob::State *state, std::vector<double> &position, int /*layer*/) const
{
    const Point tip = space_->tip(state, space_->lastLink());
    position.assign(tip.data(), tip.data() + tip.size());
}

template <class Space>
void ArmDecomposition<Space>::project(const ob::State *state, std::vector<int> &regions) const
{
    regions = {locateRegion(state)};
}

template <class Space>
typename ArmDecomposition<Space>::Point ArmDecomposition<Space>::randomPoint(int region) const
{
    std::vector<int> cell;
    ridToGridCell(region, cell);
    Point point;
    for (Eigen::Index i = 0; i < point.size(); ++i)
        point[i] = bounds_.low[i] + (cell[i] + rng_.uniform01()) * cellSizes_[i];
    return point;
}

template class ArmDecomposition<PlanarArmStateSpace>;
template class ArmDecomposition<SpatialArmStateSpace>;
}  // namespace narrows
