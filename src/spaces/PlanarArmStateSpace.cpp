// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/PlanarArmStateSpace.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <ompl/base/ProjectionEvaluator.h>
#include <boost/math/constants/constants.hpp>

namespace narrows
{
namespace
{
constexpr double pi = boost::math::constants::pi<double>();

double wrap(double angle)
{
    return std::abs(angle) <= pi ? angle : std::remainder(angle, 2.0 * pi);
}

/// Where the tip of the last link is: what the arm is for, and two numbers however many joints there are.
class TipProjection : public ob::ProjectionEvaluator
{
public:
    explicit TipProjection(const PlanarArmStateSpace *space) : ob::ProjectionEvaluator(space), arm_(space) {}

    unsigned int getDimension() const override { return 2; }

    void defaultCellSizes() override
    {
        // A twentieth of the reach: about a thousand cells over all that the tip can reach.
        cellSizes_.assign(2, arm_->arm().reach() / 20.0);
    }

    void project(const ob::State *state, Eigen::Ref<Eigen::VectorXd> projection) const override
    {
        thread_local Eigen::VectorXd q;
        thread_local std::vector<Eigen::Vector2d> points;
        arm_->toAbsolute(state, q);
        arm_->arm().place(q, points);
        projection = points.back();
    }

private:
    const PlanarArmStateSpace *arm_;
};

/// Uniform over the bounds; around a state, wrapping joints wrap instead of piling up at the seam.
class ArmSampler : public ob::RealVectorStateSampler
{
public:
    explicit ArmSampler(const PlanarArmStateSpace *space) : ob::RealVectorStateSampler(space), arm_(space) {}

    void sampleUniformNear(ob::State *state, const ob::State *near, double distance) override
    {
        // A box within the ball of that radius, as OMPL's compound spaces do it: EST, BiEST and STRIDE count and
        // connect neighbours by distance, and with the box around the ball hardly any sample of many joints would be
        // one.
        const double reach = distance / std::sqrt(static_cast<double>(arm_->getDimension()));
        sample(state, near, [&](double value) { return rng_.uniformReal(value - reach, value + reach); });
    }

    void sampleGaussian(ob::State *state, const ob::State *mean, double deviation) override
    {
        sample(state, mean, [&](double value) { return rng_.gaussian(value, deviation); });
    }

private:
    template <typename Draw>
    void sample(ob::State *state, const ob::State *around, const Draw &draw)
    {
        const double *center = around->as<ob::RealVectorStateSpace::StateType>()->values;
        double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
        for (unsigned int i = 0; i < arm_->getDimension(); ++i)
            values[i] = draw(center[i]);
        arm_->enforceBounds(state);
    }

    const PlanarArmStateSpace *arm_;
};
}  // namespace

PlanarArmStateSpace::PlanarArmStateSpace(const PlanarArm &arm, AngleConvention convention, FreeJoints freeJoints,
                                         const JointLimits &limits)
  : ob::RealVectorStateSpace(static_cast<unsigned int>(arm.dimension())),
    arm_(arm),
    convention_(convention),
    wraps_(arm.dimension(), false)
{
    setName("PlanarArm" + getName());
    ob::RealVectorBounds box(getDimension());
    box.setLow(-pi);
    box.setHigh(pi);
    if (arm_.slide())
    {
        box.setLow(0, arm_.slide()->lower);
        box.setHigh(0, arm_.slide()->upper);
    }
    for (int link = 0; link < arm_.linkCount(); ++link)
    {
        const unsigned int joint = link + arm_.firstAngle();
        if (link < static_cast<int>(limits.angles.size()) && limits.angles[link])
        {
            if (limits.convention != convention)
                throw std::invalid_argument("the joint limits are meant in the other angle convention");
            box.setLow(joint, limits.angles[link]->lower);
            box.setHigh(joint, limits.angles[link]->upper);
            bounded_.push_back(joint);
        }
        else
            wraps_[joint] = freeJoints == FreeJoints::Wrapping;
    }
    if (arm_.slide())
        bounded_.push_back(0);
    setBounds(box);
}

void PlanarArmStateSpace::toAbsolute(const ob::State *state, Eigen::VectorXd &q) const
{
    const double *values = state->as<StateType>()->values;
    q.resize(getDimension());
    for (unsigned int i = 0; i < getDimension(); ++i)
        q[i] = values[i];
    accumulate(q);
}

void PlanarArmStateSpace::accumulate(Eigen::VectorXd &values) const
{
    if (convention_ == AngleConvention::Absolute)
        return;
    const int first = arm_.firstAngle();
    for (int i = 0; i < arm_.linkCount(); ++i)
        if (arm_.links()[i].parent >= 0)
            values[first + i] += values[first + arm_.links()[i].parent];
}

void PlanarArmStateSpace::fromAbsolute(ConfigurationRef q, ob::State *state) const
{
    const Eigen::VectorXd own = arm_.fromAbsolute(q, convention_);
    double *values = state->as<StateType>()->values;
    for (unsigned int i = 0; i < getDimension(); ++i)
        values[i] = wraps_[i] ? wrap(own[i]) : own[i];
}

double PlanarArmStateSpace::jointDifference(unsigned int joint, double from, double to) const
{
    // Values of states lie in [-pi, pi], so that one turn at most has to be taken off.
    const double difference = to - from;
    if (!wraps_[joint] || std::abs(difference) <= pi)
        return difference;
    return difference > 0.0 ? difference - 2.0 * pi : difference + 2.0 * pi;
}

void PlanarArmStateSpace::displacement(const ob::State *from, const ob::State *to, Eigen::VectorXd &delta) const
{
    const double *a = from->as<StateType>()->values;
    const double *b = to->as<StateType>()->values;
    delta.resize(getDimension());
    for (unsigned int i = 0; i < getDimension(); ++i)
        delta[i] = jointDifference(i, a[i], b[i]);
    accumulate(delta);
}

std::vector<Eigen::VectorXd> PlanarArmStateSpace::unwrap(const og::PathGeometric &path) const
{
    std::vector<Eigen::VectorXd> rows(path.getStateCount());
    Eigen::VectorXd delta;
    for (unsigned int i = 0; i < rows.size(); ++i)
    {
        if (i == 0)
            toAbsolute(path.getState(0), rows[0]);
        else
        {
            displacement(path.getState(i - 1), path.getState(i), delta);
            rows[i] = rows[i - 1] + delta;
        }
    }
    return rows;
}

double PlanarArmStateSpace::getMaximumExtent() const
{
    double sum = 0.0;
    for (unsigned int i = 0; i < getDimension(); ++i)
    {
        const double extent = wraps_[i] ? pi : bounds_.high[i] - bounds_.low[i];
        sum += extent * extent;
    }
    return std::sqrt(sum);
}

double PlanarArmStateSpace::distance(const ob::State *a, const ob::State *b) const
{
    const double *from = a->as<StateType>()->values;
    const double *to = b->as<StateType>()->values;
    double sum = 0.0;
    for (unsigned int i = 0; i < dimension_; ++i)
    {
        const double difference = jointDifference(i, from[i], to[i]);
        sum += difference * difference;
    }
    return std::sqrt(sum);
}

bool PlanarArmStateSpace::equalStates(const ob::State *a, const ob::State *b) const
{
    const double *from = a->as<StateType>()->values;
    const double *to = b->as<StateType>()->values;
    for (unsigned int i = 0; i < dimension_; ++i)
        if (std::abs(jointDifference(i, from[i], to[i])) > std::numeric_limits<double>::epsilon() * 2.0)
            return false;
    return true;
}

void PlanarArmStateSpace::enforceBounds(ob::State *state) const
{
    double *values = state->as<StateType>()->values;
    for (unsigned int i = 0; i < dimension_; ++i)
        if (wraps_[i])
            values[i] = wrap(values[i]);
    for (const unsigned int i : bounded_)
        values[i] = std::min(std::max(values[i], bounds_.low[i]), bounds_.high[i]);
}

bool PlanarArmStateSpace::satisfiesBounds(const ob::State *state) const
{
    const double *values = state->as<StateType>()->values;
    for (unsigned int i = 0; i < dimension_; ++i)
        if (wraps_[i] ? !(std::abs(values[i]) <= pi) : !std::isfinite(values[i]))
            return false;
    for (const unsigned int i : bounded_)
        if (!(values[i] >= bounds_.low[i] && values[i] <= bounds_.high[i]))
            return false;
    return true;
}

void PlanarArmStateSpace::interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state) const
{
    const double *a = from->as<StateType>()->values;
    const double *b = to->as<StateType>()->values;
    double *values = state->as<StateType>()->values;
    for (unsigned int i = 0; i < dimension_; ++i)
    {
        double value = t < 1.0 ? a[i] + t * jointDifference(i, a[i], b[i]) : b[i];
        if (wraps_[i] && std::abs(value) > pi)
            value += value > 0.0 ? -2.0 * pi : 2.0 * pi;
        values[i] = value;
    }
}

ob::StateSamplerPtr PlanarArmStateSpace::allocDefaultStateSampler() const
{
    return std::make_shared<ArmSampler>(this);
}

void PlanarArmStateSpace::registerProjections()
{
    registerDefaultProjection(std::make_shared<TipProjection>(this));
}
}  // namespace narrows
