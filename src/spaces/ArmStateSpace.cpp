// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/ArmStateSpace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spaces/ArmSampler.h"

namespace narrows
{
namespace
{
const double *valuesOf(const ob::State *state)
{
    return state->as<ob::RealVectorStateSpace::StateType>()->values;
}

double *valuesOf(ob::State *state)
{
    return state->as<ob::RealVectorStateSpace::StateType>()->values;
}
}  // namespace

ArmStateSpace::ArmStateSpace(std::vector<ArmJoint> joints)
  : ob::RealVectorStateSpace(static_cast<unsigned int>(joints.size())), joints_(std::move(joints))
{
    ob::RealVectorBounds box(getDimension());
    for (unsigned int i = 0; i < getDimension(); ++i)
    {
        const Interval range = joints_[i].limits.value_or(Interval{-pi, pi});
        box.setLow(i, range.lower);
        box.setHigh(i, range.upper);
        wraps_.push_back(joints_[i].wraps && !joints_[i].limits);
        if (joints_[i].limits)
            bounded_.push_back(i);
    }
    setBounds(box);
}

std::vector<Eigen::VectorXd> ArmStateSpace::unwrap(const og::PathGeometric &path) const
{
    std::vector<Eigen::VectorXd> rows(path.getStateCount());
    Eigen::VectorXd delta;
    for (unsigned int i = 0; i < rows.size(); ++i)
    {
        if (i == 0)
            toConfiguration(path.getState(0), rows[0]);
        else
        {
            displacement(path.getState(i - 1), path.getState(i), delta);
            rows[i] = rows[i - 1] + delta;
        }
    }
    return rows;
}

double ArmStateSpace::getMaximumExtent() const
{
    double sum = 0.0;
    for (unsigned int i = 0; i < dimension_; ++i)
    {
        const double extent = wraps_[i] ? pi : bounds_.high[i] - bounds_.low[i];
        sum += extent * extent;
    }
    return std::sqrt(sum);
}

double ArmStateSpace::distance(const ob::State *a, const ob::State *b) const
{
    const double *from = valuesOf(a);
    const double *to = valuesOf(b);
    double sum = 0.0;
    for (unsigned int i = 0; i < dimension_; ++i)
    {
        const double difference = jointDifference(i, from[i], to[i]);
        sum += difference * difference;
    }
    return std::sqrt(sum);
}

bool ArmStateSpace::equalStates(const ob::State *a, const ob::State *b) const
{
    const double *from = valuesOf(a);
    const double *to = valuesOf(b);
    for (unsigned int i = 0; i < dimension_; ++i)
        if (std::abs(jointDifference(i, from[i], to[i])) > std::numeric_limits<double>::epsilon() * 2.0)
            return false;
    return true;
}

void ArmStateSpace::enforceBounds(ob::State *state) const
{
    double *values = valuesOf(state);
    for (unsigned int i = 0; i < dimension_; ++i)
        values[i] = wrapped(i, values[i]);
    for (const unsigned int i : bounded_)
        values[i] = std::min(std::max(values[i], bounds_.low[i]), bounds_.high[i]);
}

bool ArmStateSpace::satisfiesBounds(const ob::State *state) const
{
    const double *values = valuesOf(state);
    for (unsigned int i = 0; i < dimension_; ++i)
        if (wraps_[i] ? !(std::abs(values[i]) <= pi) : !std::isfinite(values[i]))
            return false;
    for (const unsigned int i : bounded_)
        if (!(values[i] >= bounds_.low[i] && values[i] <= bounds_.high[i]))
            return false;
    return true;
}

void ArmStateSpace::interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state) const
{
    const double *a = valuesOf(from);
    const double *b = valuesOf(to);
    double *values = valuesOf(state);
    for (unsigned int i = 0; i < dimension_; ++i)
    {
        double value = t < 1.0 ? a[i] + t * jointDifference(i, a[i], b[i]) : b[i];
        if (wraps_[i] && std::abs(value) > pi)
            value += value > 0.0 ? -2.0 * pi : 2.0 * pi;
        values[i] = value;
    }
}

ob::StateSamplerPtr ArmStateSpace::allocDefaultStateSampler() const
{
    return std::make_shared<ArmSampler>(this);
}
}  // namespace narrows
