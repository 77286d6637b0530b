// SPDX-License-Identifier: BSD-3-Clause
// The bounds of LinkMotion against motions that are sampled finely: never above what happens, and, halved with the
// stretch, no further below it than a second-order bound may be.
#include "kernel/LinkMotion.h"

#include <functional>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace narrows
{
namespace
{
template <int Dim>
using Vector = Eigen::Matrix<double, Dim, 1>;

std::mt19937 generator(31);

double uniform(double low, double high)
{
    return low + (high - low) * std::uniform_real_distribution<double>()(generator);
}

template <int Dim>
Vector<Dim> randomVector(double extent)
{
    Vector<Dim> vector;
    for (double &entry : vector)
        entry = uniform(-extent, extent);
    return vector;
}

/// A point that is thrown: its acceleration stays the same.
template <int Dim>
struct Thrown
{
    Vector<Dim> position = randomVector<Dim>(1.0), velocity = randomVector<Dim>(1.0),
                acceleration = randomVector<Dim>(1.0);

    Vector<Dim> at(double t) const { return position + t * velocity + 0.5 * t * t * acceleration; }

    MovingPoint<Dim> bounded(double half) const
    {
        return {position, velocity, velocity.norm() + half * acceleration.norm(), acceleration.norm()};
    }
};

/// Turns evenly in the plane; in space, about an axis that itself turns about another.
template <int Dim>
struct Turning
{
    double first = uniform(-2.0, 2.0), second = Dim == 3 ? uniform(-2.0, 2.0) : 0.0;
    Vector<Dim> along = uniform(0.3, 1.0) * randomVector<Dim>(1.0).normalized();
    Eigen::Vector3d firstAxis = randomVector<3>(1.0).normalized(), secondAxis = randomVector<3>(1.0).normalized();

    Vector<Dim> at(double t) const
    {
        if constexpr (Dim == 2)
            return Eigen::Rotation2Dd(first * t) * along;
        else
            return Eigen::AngleAxisd(first * t, firstAxis) * Eigen::AngleAxisd(second * t, secondAxis) * along;
    }

    Vector<Dim> velocity() const
    {
        if constexpr (Dim == 2)
            return first * Eigen::Vector2d(-along.y(), along.x());
        else
            return (first * firstAxis + second * secondAxis).cross(along);
    }

    double speed() const { return std::abs(first) + std::abs(second); }
};

/// A link whose one end is thrown while it turns.
template <int Dim>
struct Tumbling
{
    Thrown<Dim> base;
    Turning<Dim> turning;

    LinkMotion<Dim> bounded(double half) const
    {
        const MovingPoint<Dim> a = base.bounded(half);
        const double length = turning.along.norm(), speed = turning.speed();
        const MovingPoint<Dim> b{a.position + turning.along, a.velocity + turning.velocity(), a.way + length * speed,
                                 a.bend + length * speed * speed};
        return {a, b, 0.0, speed, half};
    }

    Vector<Dim> from(double t) const { return base.at(t); }
    Vector<Dim> to(double t) const { return base.at(t) + turning.at(t); }
};

double leastOver(double half, const std::function<double(double)> &value)
{
    constexpr int samples = 100;
    double least = std::numeric_limits<double>::infinity();
    for (int i = -samples; i <= samples; ++i)
        least = std::min(least, value(half * i / samples));
    return least;
}

/// A unit vector perpendicular to a segment.
template <int Dim>
Vector<Dim> perpendicular(const Vector<Dim> &along)
{
    const Vector<Dim> any = randomVector<Dim>(1.0);
    return (any - any.dot(along) / along.squaredNorm() * along).normalized();
}

template <int Dim>
double distanceToLine(const Vector<Dim> &from, const Vector<Dim> &to, const Vector<Dim> &point)
{
    const Vector<Dim> along = (to - from).normalized(), apart = point - from;
    return (apart - apart.dot(along) * along).norm();
}

struct Plane
{
    static constexpr int dim = 2;
};
struct Space
{
    static constexpr int dim = 3;
};
using Kinds = testing::Types<Plane, Space>;

template <class Kind>
class LinkMotionTest : public testing::Test
{
};
TYPED_TEST_SUITE(LinkMotionTest, Kinds);

TYPED_TEST(LinkMotionTest, NothingPassesALineThatRests)
{
    constexpr int Dim = TypeParam::dim;
    for (int trial = 0; trial < 500; ++trial)
    {
        const Tumbling<Dim> link, other;
        const double half = std::pow(10.0, uniform(-3.0, 0.0));
        const Vector<Dim> u = randomVector<Dim>(1.0).normalized();
        const auto along = [&](double t)
        {
            return std::min(u.dot(link.from(t)), u.dot(link.to(t)));
        };
        const auto apart = [&](double t)
        {
            return along(t) - std::max(u.dot(other.from(t)), u.dot(other.to(t)));
        };
        const LinkMotion<Dim> motion = link.bounded(half);
        EXPECT_LE(motion.leastAlong(u), leastOver(half, along) + 1e-12);
        EXPECT_GE(motion.leastAlong(u), leastOver(half, along) - 20.0 * half * half);
        EXPECT_LE(motion.leastApart(other.bounded(half), u), leastOver(half, apart) + 1e-12);
        EXPECT_GE(motion.leastApart(other.bounded(half), u), leastOver(half, apart) - 40.0 * half * half);
        EXPECT_GE(motion.reach() + 1e-12,
                  -leastOver(half, [&](double t) { return -(link.to(t) - link.to(0)).norm(); }));
    }
}

TYPED_TEST(LinkMotionTest, NothingPassesALineThatTurnsWithTheLink)
{
    constexpr int Dim = TypeParam::dim;
    int useful = 0;
    for (int trial = 0; trial < 2000; ++trial)
    {
        const Tumbling<Dim> link;
        const double half = std::pow(10.0, uniform(-3.0, 0.0));
        // A point to the side of the link; in the plane also beyond its ends, as a polygon's corners are.
        const Vector<Dim> normal = perpendicular<Dim>(link.turning.along);
        const double place = Dim == 2 ? uniform(-0.5, 1.5) : uniform(0.0, 1.0);
        Thrown<Dim> point;
        point.position = link.from(0.0) + place * link.turning.along + uniform(0.0, 0.5) * normal;
        const auto distance = [&](double t)
        {
            return distanceToLine<Dim>(link.from(t), link.to(t), point.at(t));
        };
        const double bound = link.bounded(half).leastBeside(normal, point.bounded(half));
        if (bound > 0.0)
        {
            ++useful;
            EXPECT_LE(bound, leastOver(half, distance) + 1e-12) << trial;
        }
        EXPECT_GE(bound, distance(0.0) - half * 6.0 - 120.0 * half * half) << trial;
    }
    EXPECT_GT(useful, 500);
}

/// The slope is exact: where a point keeps its distance to first order, the bound loses only to second order.
TYPED_TEST(LinkMotionTest, ALinkThatGlidesPastAPointLosesNothing)
{
    constexpr int Dim = TypeParam::dim;
    for (int trial = 0; trial < 200; ++trial)
    {
        Tumbling<Dim> link;
        const Vector<Dim> normal = perpendicular<Dim>(link.turning.along);
        Thrown<Dim> point;
        point.position = link.from(0.0) + 0.4 * link.turning.along + 0.3 * normal;
        // The link's own speed there, and anything along the link.
        point.velocity = link.base.velocity + 0.4 * link.turning.velocity() + uniform(-1.0, 1.0) * link.turning.along;
        const double half = 1e-4;
        EXPECT_GE(link.bounded(half).leastBeside(normal, point.bounded(half)), 0.3 - 50.0 * half * half) << trial;
    }
}
}  // namespace
}  // namespace narrows
