// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/SpatialArmStateSpace.h"

#include <stdexcept>

#include "spaces/ArmSampler.h"
#include "spaces/TipProjection.h"

namespace narrows
{
namespace
{
std::vector<UniversalRange> universalRanges(const SpatialArm &arm)
{
    std::vector<UniversalRange> ranges;
    std::vector<bool> taken(arm.joints().size(), false);
    for (const UniversalLimit &limit : arm.universalLimits())
    {
        if (taken[limit.first] || taken[limit.second])
            throw std::invalid_argument("a joint belongs to two universal joints");
        taken[limit.first] = taken[limit.second] = true;
        ranges.emplace_back(limit, arm.joints()[limit.first].limits, arm.joints()[limit.second].limits);
    }
    return ranges;
}

std::vector<ArmJoint> jointsOf(const SpatialArm &arm, const std::vector<UniversalRange> &universal,
                               FreeJoints freeJoints)
{
    std::vector<ArmJoint> joints;
    for (const SpatialJoint &joint : arm.joints())
        joints.push_back({joint.kind == SpatialJoint::Kind::Revolute, joint.limits, false});
    for (const UniversalRange &range : universal)
    {
        joints[range.limit().first].limits = range.first();
        joints[range.limit().second].limits = range.second();
    }
    for (ArmJoint &joint : joints)
        joint.wraps = !joint.limits && freeJoints == FreeJoints::Wrapping;
    return joints;
}

/// Uniform over the bounds; what a universal joint may not do is drawn again.
class SpatialSampler : public ArmSampler
{
public:
    explicit SpatialSampler(const SpatialArmStateSpace *space) : ArmSampler(space), arm_(space) {}

    void sampleUniform(ob::State *state) override
    {
        ArmSampler::sampleUniform(state);
        double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
        for (const UniversalRange &range : arm_->universalRanges())
            draw(range, values);
    }

private:
    void draw(const UniversalRange &range, double *values)
    {
        // The cone fills more than three quarters of its square; limits of the joints can leave next to nothing of it.
        for (int attempt = 0; attempt < 1000 && !range.contains(values); ++attempt)
        {
            values[range.limit().first] = rng_.uniformReal(range.first().lower, range.first().upper);
            values[range.limit().second] = rng_.uniformReal(range.second().lower, range.second().upper);
        }
        range.enforce(values);
    }

    const SpatialArmStateSpace *arm_;
};
}  // namespace

SpatialArmStateSpace::SpatialArmStateSpace(const SpatialArm &arm, FreeJoints freeJoints)
  : SpatialArmStateSpace(arm, narrows::universalRanges(arm), freeJoints)
{
}

SpatialArmStateSpace::SpatialArmStateSpace(const SpatialArm &arm, std::vector<UniversalRange> universal,
                                           FreeJoints freeJoints)
  : JointStateSpace(jointsOf(arm, universal, freeJoints)), arm_(arm), universal_(std::move(universal))
{
    setName("SpatialArm" + getName());
}

int SpatialArmStateSpace::lastLink() const
{
    int link = arm_.linkCount() - 1;
    while (link > 0 && arm_.links()[link].joint < 0)
        --link;
    return link;
}

Eigen::Vector3d SpatialArmStateSpace::tip(const ob::State *state, int link) const
{
    thread_local Eigen::VectorXd q;
    thread_local SpatialArm::Placement placement;
    toConfiguration(state, q);
    arm_.place(q, placement);
    return placement.points[2 * link + 1];
}

void SpatialArmStateSpace::enforceBounds(ob::State *state) const
{
    ArmStateSpace::enforceBounds(state);
    for (const UniversalRange &range : universal_)
        range.enforce(state->as<StateType>()->values);
}

bool SpatialArmStateSpace::satisfiesBounds(const ob::State *state) const
{
    if (!ArmStateSpace::satisfiesBounds(state))
        return false;
    for (const UniversalRange &range : universal_)
        if (!range.contains(state->as<StateType>()->values))
            return false;
    return true;
}

ob::StateSamplerPtr SpatialArmStateSpace::allocDefaultStateSampler() const
{
    return std::make_shared<SpatialSampler>(this);
}

void SpatialArmStateSpace::registerProjections()
{
    // A fifth of the reach: about a thousand cells over all that the tip can reach.
    registerDefaultProjection(std::make_shared<TipProjection<SpatialArmStateSpace>>(this, 5));
}
}  // namespace narrows
