// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/JointStateSpace.h"

#include <stdexcept>

namespace narrows
{
namespace
{
std::vector<ArmJoint> checked(const std::vector<ArmJoint> &joints)
{
    if (joints.empty())
        throw std::invalid_argument("a robot needs at least one joint");
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        if (!joints[i].turns && !joints[i].limits)
            throw std::invalid_argument("joint " + std::to_string(i) + " does not turn and so needs limits");
        if (joints[i].limits && !(joints[i].limits->lower < joints[i].limits->upper))
            throw std::invalid_argument("joint " + std::to_string(i) + ": limits must be ordered");
    }
    return joints;
}
}  // namespace

JointStateSpace::JointStateSpace(const std::vector<ArmJoint> &joints) : ArmStateSpace(checked(joints))
{
    setName("Joint" + getName());
}

void JointStateSpace::toConfiguration(const ob::State *state, Eigen::VectorXd &q) const
{
    q = Eigen::Map<const Eigen::VectorXd>(state->as<StateType>()->values, dimension_);
}

void JointStateSpace::fromConfiguration(ConfigurationRef q, ob::State *state) const
{
    double *values = state->as<StateType>()->values;
    for (unsigned int i = 0; i < dimension_; ++i)
        values[i] = wrapped(i, q[i]);
}

void JointStateSpace::displacement(const ob::State *from, const ob::State *to, Eigen::VectorXd &delta) const
{
    delta.resize(dimension_);
    for (unsigned int i = 0; i < dimension_; ++i)
        delta[i] = jointDifference(i, from->as<StateType>()->values[i], to->as<StateType>()->values[i]);
}

std::shared_ptr<const ArmStateSpace> jointsOf(const ob::StateSpacePtr &space)
{
    if (auto arm = std::dynamic_pointer_cast<const ArmStateSpace>(space))
        return arm;
    const auto *plain = dynamic_cast<const ob::RealVectorStateSpace *>(space.get());
    if (plain == nullptr || plain->getDimension() == 0)
        return nullptr;
    std::vector<ArmJoint> joints;
    for (unsigned int i = 0; i < plain->getDimension(); ++i)
    {
        const Interval bounds{plain->getBounds().low[i], plain->getBounds().high[i]};
        const bool bounded = bounds.lower < bounds.upper;
        joints.push_back({!bounded, bounded ? std::optional<Interval>(bounds) : std::nullopt});
    }
    return std::make_shared<const JointStateSpace>(joints);
}
}  // namespace narrows
