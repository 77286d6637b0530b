// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "validity/PlanarMotion.h"
#include "validity/SpatialMotion.h"
#include "validity/TurningPlane.h"

namespace narrows::proof
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

std::mt19937 generator(41);

double random(double size)
{
    return std::uniform_real_distribution<double>(-size, size)(generator);
}

template <int Dim>
Point<Dim> randomPoint(double size)
{
    return Point<Dim>::NullaryExpr([&] { return random(size); });
}

Eigen::VectorXd randomRow(int dimension, double size)
{
    return Eigen::VectorXd::NullaryExpr(dimension, [&] { return random(size); });
}

PlanarArm randomPlanarArm()
{
    std::vector<PlanarLink> links;
    for (int i = 0; i < 7; ++i)
        links.push_back({0.2 + std::abs(random(1.0)), static_cast<int>(generator() % (i + 1)) - 1});
    const Vector2d axis = randomPoint<2>(1.0).normalized();
    return PlanarArm(randomPoint<2>(1.0), links, 0.0, Slide{axis, -9.0, 9.0});
}

/// A tree: one or two slides, then joints with any offsets and axes, and links that need not start at their joints.
SpatialArm randomSpatialArm()
{
    std::vector<SpatialJoint> joints;
    std::vector<SpatialLink> links;
    for (int i = 0; i < 8; ++i)
    {
        const Isometry3d offset = Eigen::Translation3d(randomPoint<3>(1.0)) *
                                  Eigen::AngleAxisd(random(3.0), randomPoint<3>(1.0).normalized());
        const int parent = i < 2 ? i - 1 : static_cast<int>(generator() % (i + 1)) - 1;
        const Vector3d axis = randomPoint<3>(1.0).normalized();
        if (i < 2)
            joints.push_back({SpatialJoint::Kind::Prismatic, parent, offset, axis, Interval{-9.0, 9.0}});
        else
            joints.push_back({SpatialJoint::Kind::Revolute, parent, offset, axis, std::nullopt});
        links.push_back({i, randomPoint<3>(0.5), randomPoint<3>(1.0), 0.1});
    }
    links.push_back({-1, randomPoint<3>(0.5), randomPoint<3>(1.0), 0.1});
    return SpatialArm(joints, links);
}

template <int Dim>
double separationAlong(const Segment<Dim> &to, const Segment<Dim> &from, const Point<Dim> &u)
{
    return std::min(to.from.dot(u), to.to.dot(u)) - std::max(from.from.dot(u), from.to.dot(u));
}

template <int Dim>
double leastDistance(const ConvexSet<Dim> &set, const Segment<Dim> &segment)
{
    return separate<Dim>(set, segment, Point<Dim>::UnitX(), {}).upper;
}

template <int Dim>
ConvexSet<Dim> resting(const MovingSegment<Dim> &segment)
{
    return {segment.now(), 0.0, Point<Dim>::Zero(), 0.0};
}

ConvexSet<2> randomSet(const PlanarMotion &)
{
    const Vector2d center = randomPoint<2>(2.0);
    return {Superellipse{center, {0.2 + std::abs(random(1.0)), 0.2}, 4.0}, 0.0, center, 2.0};
}

ConvexSet<3> randomSet(const SpatialMotion &)
{
    const Vector3d center = randomPoint<3>(3.0);
    if (generator() % 2 == 0)
        return {Cylinder{center, randomPoint<3>(1.0).normalized(), 0.3, 1.0}, 0.0, center, 2.0};
    return {Box{Isometry3d(Eigen::Translation3d(center)), {0.3, 0.7, 0.5}}, 0.0, center, 2.0};
}

/// Planes at rest, following one of two segments, and with any other turn.
template <int Dim>
std::vector<TurningPlane<Dim>> somePlanes(const MovingSegment<Dim> &one, const MovingSegment<Dim> &other)
{
    const TurningPlane<Dim> atRest{randomPoint<Dim>(1.0).normalized()};
    const Point<Dim> any = randomPoint<Dim>(1.0);
    std::vector<TurningPlane<Dim>> planes{atRest, {atRest.normal, any - any.dot(atRest.normal) * atRest.normal}};
    for (const auto &plane : {atRest.following(one), atRest.following(other)})
        if (plane)
            planes.push_back(*plane);
    return planes;
}

template <int Dim>
double wayBetween(const MovingPoint<Dim> &was, const MovingPoint<Dim> &is)
{
    return (was.position - is.position).norm();
}

/// What is promised for an interval holds at every moment of it.
template <class Motion, class Arm>
void expectBounds(const Arm &arm, int dimension)
{
    constexpr int Dim = Motion::Dim;
    const Eigen::VectorXd from = randomRow(dimension, 3.0), to = from + randomRow(dimension, 1.0);
    Motion middle(arm), moment(arm);
    const double center = 0.5 + random(0.3), half = std::pow(10.0, -1.5 + random(0.8));
    middle.place(from, to, center);
    const ConvexSet<Dim> set = randomSet(middle);
    for (int k = -5; k <= 5; ++k)
    {
        moment.place(from, to, center + 0.2 * k * half);
        for (int link = 0; link < middle.linkCount(); ++link)
        {
            const MovingSegment<Dim> &was = middle.link(link), &is = moment.link(link);
            EXPECT_LE(wayBetween(was.from, is.from), was.from.travel * half + 1e-12);
            EXPECT_LE(wayBetween(was.to, is.to), was.to.travel * half + 1e-12);
            for (const TurningPlane<Dim> &plane : somePlanes(was, was))
                EXPECT_GE(leastDistance(set, is.now()), keptApart<Dim>(plane, was, set, half) - 1e-12);
            for (int other = 0; other < link; ++other)
            {
                const MovingPair<Dim> pair = middle.between(other, link);
                const double distance = leastDistance(resting(moment.link(other)), is.now());
                for (const TurningPlane<Dim> &plane : somePlanes(pair.first, pair.second))
                    EXPECT_GE(distance, keptApart<Dim>(plane, pair.second, pair.first, half) - 1e-12);
            }
        }
    }
}

/// The velocities are the derivatives of the positions.
template <class Motion, class Arm>
void expectVelocities(const Arm &arm, int dimension)
{
    constexpr int Dim = Motion::Dim;
    const Eigen::VectorXd from = randomRow(dimension, 3.0), to = from + randomRow(dimension, 1.0);
    Motion before(arm), now(arm), after(arm);
    const double step = 1e-6;
    before.place(from, to, 0.5 - step);
    now.place(from, to, 0.5);
    after.place(from, to, 0.5 + step);
    for (int link = 0; link < now.linkCount(); ++link)
        for (const auto end : {&MovingSegment<Dim>::from, &MovingSegment<Dim>::to})
        {
            const MovingPoint<Dim> &point = now.link(link).*end;
            const Point<Dim> way = (after.link(link).*end).position - (before.link(link).*end).position;
            EXPECT_LE((way / (2 * step) - point.velocity).norm(), 1e-8);
            EXPECT_LE(point.velocity.norm(), point.travel + 1e-12);
        }
}

/// How two links are seen from the frame in which `between` promises to look at them.
Eigen::Matrix2d frameOf(const PlanarArm &arm, const Eigen::VectorXd &row, int first, int /*second*/)
{
    return Eigen::Rotation2Dd(row[arm.firstAngle() + first]).toRotationMatrix();
}

Eigen::Matrix3d frameOf(const SpatialArm &arm, const Eigen::VectorXd &row, int first, int second)
{
    int one = arm.links()[first].joint, other = arm.links()[second].joint;
    while (one != other)
        (one > other ? one : other) = arm.joints()[std::max(one, other)].parent;
    SpatialArm::Placement placement;
    arm.place(row, placement);
    return one < 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : Eigen::Matrix3d(placement.frames[one].linear());
}

template <class Motion, class Arm>
void expectRelativeVelocities(const Arm &arm, int dimension)
{
    constexpr int Dim = Motion::Dim;
    const Eigen::VectorXd from = randomRow(dimension, 3.0), delta = randomRow(dimension, 1.0);
    const double step = 1e-6;
    Motion before(arm), now(arm), after(arm);
    before.place(from, from + delta, -step);
    now.place(from, from + delta, 0.0);
    after.place(from, from + delta, step);
    for (int second = 1; second < now.linkCount(); ++second)
        for (int first = 0; first < second; ++first)
        {
            const MovingPair<Dim> pair = now.between(first, second);
            const Point<Dim> seenBefore = frameOf(arm, from - step * delta, first, second).transpose() *
                                          (before.link(second).to.position - before.link(first).from.position);
            const Point<Dim> seenAfter = frameOf(arm, from + step * delta, first, second).transpose() *
                                         (after.link(second).to.position - after.link(first).from.position);
            const Point<Dim> velocity = frameOf(arm, from, first, second) * (seenAfter - seenBefore) / (2 * step);
            EXPECT_LE((pair.second.to.velocity - pair.first.from.velocity - velocity).norm(), 1e-8);
            EXPECT_LE(velocity.norm(), pair.second.to.travel + pair.first.from.travel + 1e-8);
        }
}

TEST(ProofMotion, NeverPromisesTooMuch)
{
    for (int trial = 0; trial < 200; ++trial)
    {
        SCOPED_TRACE("seed 41, trial " + std::to_string(trial));
        expectBounds<PlanarMotion>(randomPlanarArm(), 8);
        expectBounds<SpatialMotion>(randomSpatialArm(), 8);
    }
}

TEST(ProofMotion, HasRightVelocities)
{
    for (int trial = 0; trial < 50; ++trial)
    {
        SCOPED_TRACE("seed 41, trial " + std::to_string(trial));
        expectVelocities<PlanarMotion>(randomPlanarArm(), 8);
        expectVelocities<SpatialMotion>(randomSpatialArm(), 8);
        expectRelativeVelocities<PlanarMotion>(randomPlanarArm(), 8);
        expectRelativeVelocities<SpatialMotion>(randomSpatialArm(), 8);
    }
}

/// Links that turn as one keep what they have, however long.
TEST(ProofMotion, LosesNothingBetweenLinksThatTurnTogether)
{
    const PlanarArm planar({0, 0}, {{1.0, -1}, {0.5, 0}, {1.0, 1}});
    PlanarMotion flat(planar);
    flat.place(Eigen::Vector3d(0.0, 1.5, 3.0), Eigen::Vector3d(9.0, 10.5, 12.0), 0.3);
    const MovingPair<2> flatPair = flat.between(0, 2);
    const Vector2d across = randomPoint<2>(1.0).normalized();
    EXPECT_NEAR(keptApart<2>({across}, flatPair.first, flatPair.second, 0.5),
                separationAlong<2>(flat.link(0).now(), flat.link(2).now(), across), 1e-14);

    const SpatialArm chain = universalChain({0, 0, 0}, {1.0, 0.5, 1.0}, 0.0);
    Eigen::VectorXd from = randomRow(6, 1.0), to = from;
    to.head<2>() += Vector2d(4.0, -3.0);
    SpatialMotion solid(chain);
    solid.place(from, to, 0.3);
    const MovingPair<3> solidPair = solid.between(0, 2);
    const Vector3d u = randomPoint<3>(1.0).normalized();
    EXPECT_NEAR(keptApart<3>({u}, solidPair.first, solidPair.second, 0.5),
                separationAlong<3>(solid.link(0).now(), solid.link(2).now(), u), 1e-14);
}

/// Stretched out and turning in all joints, the tip has the speed and the acceleration that bound it.
TEST(ProofMotion, BoundsAreReachedByAStretchedArm)
{
    const double a = 1.5, b = 0.5, rate = 0.7, speed = rate * (a + 2 * b), acceleration = rate * rate * (a + 4 * b);
    const PlanarArm planar({0, 0}, {{a, -1}, {b, 0}});
    PlanarMotion flat(planar);
    flat.place(Vector2d(1, 1), Vector2d(1 + rate, 1 + 2 * rate), 0.0);
    EXPECT_NEAR(flat.link(1).to.travel, speed, 1e-14);
    EXPECT_NEAR(flat.link(1).to.bend, acceleration, 1e-14);

    const SpatialArm chain = universalChain({0, 0, 0}, {a, b}, 0.0);
    SpatialMotion solid(chain);
    solid.place(Eigen::Vector4d::Zero(), Eigen::Vector4d(0, rate, 0, rate), 0.0);
    EXPECT_NEAR(solid.link(1).to.travel, speed, 1e-14);
    EXPECT_NEAR(solid.link(1).to.bend, acceleration, 1e-14);
}

/// The checkers' kinematics was written from the same definition by someone else.
TEST(ProofMotion, PlacesLinksWhereTheArmDoes)
{
    for (int trial = 0; trial < 100; ++trial)
    {
        const SpatialArm arm = randomSpatialArm();
        const Eigen::VectorXd from = randomRow(8, 3.0), to = randomRow(8, 3.0);
        SpatialMotion motion(arm);
        motion.place(from, to, 0.25);
        SpatialArm::Placement placement;
        arm.place(0.75 * from + 0.25 * to, placement);
        for (int link = 0; link < arm.linkCount(); ++link)
        {
            EXPECT_LE((motion.link(link).from.position - placement.points[2 * link]).norm(), 1e-13);
            EXPECT_LE((motion.link(link).to.position - placement.points[2 * link + 1]).norm(), 1e-13);
            EXPECT_LE(placement.points[2 * link].norm(), motion.extent({from, to}));
        }
    }
}
}  // namespace
}  // namespace narrows::proof
