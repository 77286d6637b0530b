// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <boost/math/constants/constants.hpp>

#include "spaces/PlanarArmStateSpace.h"
#include "spaces/SpatialArmStateSpace.h"

namespace narrows
{
namespace
{
constexpr double pi = boost::math::constants::pi<double>();
constexpr unsigned int seed = 31;
constexpr int tries = 300;
/// Angles are sums of at most five numbers of size pi, each rounded once: an error of some 1e-15.
constexpr double rounding = 1e-13;

/// A gripper with two fingers on a two-link arm.
PlanarArm makeArm(bool slides)
{
    std::optional<Slide> slide;
    if (slides)
        slide = Slide{{1.0, 0.0}, -0.5, 2.0};
    return PlanarArm({0.0, 0.0}, {{1.0, -1}, {0.8, 0}, {0.3, 1}, {0.3, 1}}, 0.0, slide);
}

/// A snake on a slide: universal joints, one of them with a limit of its own.
SpatialArm makeSnake(bool limited)
{
    SpatialArm free = universalChain({0.0, 0.0, 0.0}, {1.0, 0.8, 0.5}, 0.05,
                                     std::make_pair(Eigen::Vector3d::UnitX().eval(), Interval{-0.5, 2.0}), 0.9);
    std::vector<SpatialJoint> joints = free.joints();
    if (limited)
        joints[3].limits = Interval{0.1, 2.0};
    return SpatialArm(joints, free.links(), free.universalLimits());
}

/// An arm of revolute joints that turn about axes in different directions.
SpatialArm makeElbow(bool limited)
{
    std::vector<DenavitHartenberg> rows(4);
    rows[0] = {0.0, 0.5, 0.0, pi / 2, std::nullopt, 0.05};
    rows[1] = {0.0, 0.0, 0.8, 0.0, std::nullopt, 0.05};
    rows[2] = {0.0, 0.0, 0.3, pi / 2, std::nullopt, 0.05};
    rows[3] = {0.0, 0.4, 0.0, 0.0, std::nullopt, 0.05};
    if (limited)
    {
        rows[1].limits = Interval{-2.0, 1.5};
        rows[2].limits = Interval{0.1, 4.0};
    }
    return denavitHartenbergArm(Eigen::Isometry3d::Identity(), rows);
}

std::vector<double> coordinates(const PlanarArm &arm, const Eigen::VectorXd &q)
{
    std::vector<Eigen::Vector2d> points;
    arm.place(q, points);
    return {points.front().data(), points.front().data() + 2 * points.size()};
}

std::vector<double> coordinates(const SpatialArm &arm, const Eigen::VectorXd &q)
{
    SpatialArm::Placement placement;
    arm.place(q, placement);
    return {placement.points.front().data(), placement.points.front().data() + 3 * placement.points.size()};
}

/// A space and where its arm's points are in a configuration.
struct Variant
{
    std::string name;
    std::function<std::shared_ptr<ArmStateSpace>()> make;
    std::function<std::vector<double>(const Eigen::VectorXd &)> place;
    unsigned int tipDimension;
};

std::ostream &operator<<(std::ostream &out, const Variant &variant)
{
    return out << variant.name;
}

class SpaceContract : public testing::TestWithParam<Variant>
{
protected:
    SpaceContract()
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(seed);
        space_ = GetParam().make();
        space_->setup();
        sampler_ = space_->allocStateSampler();
    }

    ob::ScopedState<> sample()
    {
        ob::ScopedState<> state(space_);
        sampler_->sampleUniform(state.get());
        return state;
    }

    double distance(const ob::ScopedState<> &a, const ob::ScopedState<> &b) const
    {
        return space_->distance(a.get(), b.get());
    }

    ob::ScopedState<> between(const ob::ScopedState<> &a, const ob::ScopedState<> &b, double t) const
    {
        ob::ScopedState<> state(space_);
        space_->interpolate(a.get(), b.get(), t, state.get());
        return state;
    }

    Eigen::VectorXd configuration(const ob::ScopedState<> &state) const
    {
        Eigen::VectorXd q;
        space_->toConfiguration(state.get(), q);
        return q;
    }

    Eigen::VectorXd displacement(const ob::ScopedState<> &a, const ob::ScopedState<> &b) const
    {
        Eigen::VectorXd delta;
        space_->displacement(a.get(), b.get(), delta);
        return delta;
    }

    /// The largest difference of any coordinate of the arm's points between two configurations.
    double apart(const Eigen::VectorXd &p, const Eigen::VectorXd &q) const
    {
        const std::vector<double> a = GetParam().place(p);
        const std::vector<double> b = GetParam().place(q);
        double most = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i)
            most = std::max(most, std::abs(a[i] - b[i]));
        return most;
    }

    std::shared_ptr<ArmStateSpace> space_;
    ob::StateSamplerPtr sampler_;
};

TEST_P(SpaceContract, PassesOmplsOwnChecks)
{
    EXPECT_NO_THROW(space_->sanityChecks());
}

TEST_P(SpaceContract, DistanceIsAMetric)
{
    for (int i = 0; i < tries; ++i)
    {
        const ob::ScopedState<> a = sample();
        const ob::ScopedState<> b = sample();
        const ob::ScopedState<> c = sample();
        EXPECT_EQ(distance(a, a), 0.0);
        EXPECT_EQ(distance(a, b), distance(b, a));
        EXPECT_GT(distance(a, b), 0.0);
        EXPECT_LE(distance(a, c), distance(a, b) + distance(b, c) + rounding);
        EXPECT_LE(distance(a, b), space_->getMaximumExtent() + rounding);
    }
}

TEST_P(SpaceContract, EqualStatesAreThoseWithoutDistance)
{
    for (int i = 0; i < tries; ++i)
    {
        const ob::ScopedState<> a = sample();
        const ob::ScopedState<> copy = a;
        ob::ScopedState<> moved = a;
        moved[i % space_->getDimension()] += 1e-9;
        EXPECT_TRUE(space_->equalStates(a.get(), copy.get()));
        EXPECT_FALSE(space_->equalStates(a.get(), moved.get()));
        EXPECT_NEAR(distance(a, moved), 1e-9, 1e-14);
    }
}

TEST_P(SpaceContract, OnlyWrappingJointsHaveASeam)
{
    for (unsigned int joint = 0; joint < space_->getDimension(); ++joint)
    {
        ob::ScopedState<> a = sample();
        ob::ScopedState<> b = a;
        a[joint] = pi;
        b[joint] = -pi;
        EXPECT_EQ(space_->equalStates(a.get(), b.get()), space_->wraps(joint)) << "joint " << joint;
        EXPECT_NEAR(distance(a, b), space_->wraps(joint) ? 0.0 : 2.0 * pi, rounding) << "joint " << joint;
    }
}

TEST_P(SpaceContract, InterpolationJoinsItsEndsAtConstantSpeed)
{
    for (int i = 0; i < tries; ++i)
    {
        const ob::ScopedState<> a = sample();
        const ob::ScopedState<> b = sample();
        EXPECT_TRUE(space_->equalStates(between(a, b, 0.0).get(), a.get()));
        EXPECT_TRUE(space_->equalStates(between(a, b, 1.0).get(), b.get()));
        const double length = distance(a, b);
        for (double t = 0.0; t < 1.0; t += 0.125)
        {
            const ob::ScopedState<> here = between(a, b, t);
            EXPECT_TRUE(space_->satisfiesBounds(here.get())) << "seed " << seed << " t " << t;
            EXPECT_NEAR(distance(a, here), t * length, rounding);
            EXPECT_NEAR(distance(here, between(a, b, t + 0.125)), 0.125 * length, rounding);
        }
    }
}

TEST_P(SpaceContract, InterpolationMayOverwriteItsEnds)
{
    for (int i = 0; i < tries; ++i)
    {
        const ob::ScopedState<> a = sample();
        const ob::ScopedState<> b = sample();
        const ob::ScopedState<> expected = between(a, b, 0.3);
        ob::ScopedState<> first = a;
        ob::ScopedState<> last = b;
        space_->interpolate(first.get(), b.get(), 0.3, first.get());
        space_->interpolate(a.get(), last.get(), 0.3, last.get());
        EXPECT_TRUE(space_->equalStates(first.get(), expected.get()));
        EXPECT_TRUE(space_->equalStates(last.get(), expected.get()));
    }
}

TEST_P(SpaceContract, DisplacementIsWhatInterpolationTravels)
{
    for (int i = 0; i < tries; ++i)
    {
        const ob::ScopedState<> a = sample();
        const ob::ScopedState<> b = sample();
        const Eigen::VectorXd delta = displacement(a, b);
        for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0})
            EXPECT_LT(apart(configuration(a) + t * delta, configuration(between(a, b, t))), rounding) << "t " << t;
    }
}

TEST_P(SpaceContract, EnforcingBoundsKeepsThePostureOfFreeJointsAndIsIdempotent)
{
    ompl::RNG random;
    for (int i = 0; i < tries; ++i)
    {
        ob::ScopedState<> state(space_);
        for (unsigned int joint = 0; joint < space_->getDimension(); ++joint)
            state[joint] = random.uniformReal(-20.0, 20.0);
        ob::ScopedState<> inside = state;
        space_->enforceBounds(inside.get());
        ASSERT_TRUE(space_->satisfiesBounds(inside.get()));
        ob::ScopedState<> again = inside;
        space_->enforceBounds(again.get());
        for (unsigned int joint = 0; joint < space_->getDimension(); ++joint)
        {
            EXPECT_EQ(again[joint], inside[joint]);
            if (space_->wraps(joint))
            {
                EXPECT_NEAR(std::remainder(inside[joint] - state[joint], 2.0 * pi), 0.0, rounding);
            }
        }
    }
}

TEST_P(SpaceContract, SamplesStayWithinBounds)
{
    for (int i = 0; i < tries; ++i)
    {
        const ob::ScopedState<> center = sample();
        EXPECT_TRUE(space_->satisfiesBounds(center.get()));
        ob::ScopedState<> state(space_);
        sampler_->sampleUniformNear(state.get(), center.get(), 2.0);
        EXPECT_TRUE(space_->satisfiesBounds(state.get()));
        EXPECT_LE(distance(center, state), 2.0 * std::sqrt(space_->getDimension()) + rounding);
        sampler_->sampleGaussian(state.get(), center.get(), 2.0);
        EXPECT_TRUE(space_->satisfiesBounds(state.get()));
    }
}

TEST_P(SpaceContract, SamplesFillTheBounds)
{
    std::vector<double> least(space_->getDimension(), 1e9);
    std::vector<double> most(space_->getDimension(), -1e9);
    for (int i = 0; i < 2000; ++i)
    {
        const ob::ScopedState<> state = sample();
        for (unsigned int joint = 0; joint < space_->getDimension(); ++joint)
        {
            least[joint] = std::min(least[joint], state[joint]);
            most[joint] = std::max(most[joint], state[joint]);
        }
    }
    const ob::RealVectorBounds &bounds = space_->getBounds();
    for (unsigned int joint = 0; joint < space_->getDimension(); ++joint)
    {
        const double margin = 0.02 * (bounds.high[joint] - bounds.low[joint]);  // missed with probability 1e-17
        EXPECT_LT(least[joint], bounds.low[joint] + margin);
        EXPECT_GT(most[joint], bounds.high[joint] - margin);
    }
}

TEST_P(SpaceContract, ConfigurationsRoundTrip)
{
    for (int i = 0; i < tries; ++i)
    {
        const ob::ScopedState<> state = sample();
        ob::ScopedState<> back(space_);
        space_->fromConfiguration(configuration(state), back.get());
        EXPECT_NEAR(distance(state, back), 0.0, rounding);
    }
}

TEST_P(SpaceContract, UnwrappedPathsAreContinuous)
{
    const auto si = std::make_shared<ob::SpaceInformation>(space_);
    og::PathGeometric path(si);
    for (int i = 0; i < 20; ++i)
        path.append(sample().get());
    const std::vector<Eigen::VectorXd> rows = space_->unwrap(path);
    ASSERT_EQ(rows.size(), path.getStateCount());
    Eigen::VectorXd q;
    Eigen::VectorXd delta;
    for (unsigned int i = 0; i < rows.size(); ++i)
    {
        space_->toConfiguration(path.getState(i), q);
        EXPECT_LT(apart(rows[i], q), 20 * rounding);
        if (i == 0)
            continue;
        space_->displacement(path.getState(i - 1), path.getState(i), delta);
        EXPECT_LT((rows[i] - rows[i - 1] - delta).norm(), 20 * rounding);
    }
}

TEST_P(SpaceContract, ProjectsToTheTipOfTheLastLink)
{
    const ob::ScopedState<> state = sample();
    const std::vector<double> points = GetParam().place(configuration(state));
    Eigen::VectorXd projection(GetParam().tipDimension);
    space_->getDefaultProjection()->project(state.get(), projection);
    ASSERT_EQ(space_->getDefaultProjection()->getDimension(), GetParam().tipDimension);
    for (unsigned int i = 0; i < GetParam().tipDimension; ++i)
        EXPECT_NEAR(projection[i], points[points.size() - GetParam().tipDimension + i], rounding);
}

TEST_P(SpaceContract, TellsItsLimits)
{
    const ob::RealVectorBounds &bounds = space_->getBounds();
    ASSERT_EQ(space_->joints().size(), space_->getDimension());
    for (unsigned int joint = 0; joint < space_->getDimension(); ++joint)
    {
        const std::optional<Interval> &limits = space_->joints()[joint].limits;
        EXPECT_EQ(bounds.low[joint], limits ? limits->lower : -pi);
        EXPECT_EQ(bounds.high[joint], limits ? limits->upper : pi);
        EXPECT_FALSE(limits && space_->wraps(joint));
    }
}

Variant planarVariant(AngleConvention convention, FreeJoints freeJoints, bool limited, bool slides)
{
    JointLimits limits{convention, std::vector<std::optional<Interval>>(4)};
    if (limited)
    {
        limits.angles[1] = Interval{-2.0, 1.5};
        limits.angles[2] = Interval{0.1, 4.0};  // beyond pi: a bounded joint never wraps
    }
    const PlanarArm arm = makeArm(slides);
    return {std::string(convention == AngleConvention::Absolute ? "Absolute" : "Relative") +
                (freeJoints == FreeJoints::Wrapping ? "Wrapping" : "Line") + (limited ? "Limited" : "") +
                (slides ? "Slide" : ""),
            [=] { return std::make_shared<PlanarArmStateSpace>(arm, convention, freeJoints, limits); },
            [=](const Eigen::VectorXd &q) { return coordinates(arm, q); }, 2};
}

Variant spatialVariant(const std::string &name, const SpatialArm &arm, FreeJoints freeJoints)
{
    return {name + (freeJoints == FreeJoints::Wrapping ? "Wrapping" : "Line"),
            [=] { return std::make_shared<SpatialArmStateSpace>(arm, freeJoints); },
            [=](const Eigen::VectorXd &q) { return coordinates(arm, q); }, 3};
}

std::vector<Variant> variants()
{
    std::vector<Variant> all;
    for (const FreeJoints freeJoints : {FreeJoints::Wrapping, FreeJoints::Unbounded})
        for (const bool limited : {false, true})
        {
            for (const AngleConvention convention : {AngleConvention::Absolute, AngleConvention::Relative})
                for (const bool slides : {false, true})
                    all.push_back(planarVariant(convention, freeJoints, limited, slides));
            const std::string suffix = limited ? "Limited" : "";
            all.push_back(spatialVariant("Snake" + suffix, makeSnake(limited), freeJoints));
            all.push_back(spatialVariant("Elbow" + suffix, makeElbow(limited), freeJoints));
        }
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, SpaceContract, testing::ValuesIn(variants()),
                         [](const auto &variant) { return variant.param.name; });

TEST(PlanarArmStateSpace, RefusesLimitsOfTheOtherConvention)
{
    JointLimits limits{AngleConvention::Relative, std::vector<std::optional<Interval>>(4)};
    EXPECT_NO_THROW(PlanarArmStateSpace(makeArm(false), AngleConvention::Absolute, FreeJoints::Wrapping, limits));
    limits.angles[0] = Interval{-1.0, 1.0};
    EXPECT_THROW(PlanarArmStateSpace(makeArm(false), AngleConvention::Absolute, FreeJoints::Wrapping, limits),
                 std::invalid_argument);
}
}  // namespace
}  // namespace narrows
