// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/LinkObstacle.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "kernel/ConvexParts.h"
#include "kernel/LinkPair.h"
#include "kernel/SegmentDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

const Polygon box{{{-0.6, -0.4}, {0.7, -0.4}, {0.7, 0.3}, {-0.6, 0.3}}};
const Polygon notch{
    {{-0.9, -0.6}, {0.9, -0.6}, {0.9, 0.9}, {0.3, 0.9}, {0.3, -0.1}, {-0.3, -0.1}, {-0.3, 0.9}, {-0.9, 0.9}}};

PlanarObstacle named(const std::string &name)
{
    if (name == "circle")
        return {name, Circle{{0.1, -0.2}, 0.5}};
    if (name == "quartic")
        return {name, Superellipse{{0.1, -0.2}, {0.9, 0.3}, 4.0}};
    if (name == "ellipse")
        return {name, Superellipse{{0.1, -0.2}, {0.2, 0.8}, 2.0}};
    if (name == "odd")
        return {name, Superellipse{{0.1, -0.2}, {0.6, 0.5}, 3.3}};
    return {name, name == "box" ? box : notch};
}

bool covers(const PlanarObstacle &obstacle, const Vector2d &point)
{
    if (const auto *circle = std::get_if<Circle>(&obstacle.shape))
        return (point - circle->center).norm() < circle->radius;
    if (const auto *polygon = std::get_if<Polygon>(&obstacle.shape))
        return contains(*polygon, point);
    const auto &shape = std::get<Superellipse>(obstacle.shape);
    const Vector2d scaled = (point - shape.center).cwiseQuotient(shape.halfExtents).cwiseAbs();
    return std::pow(scaled.x(), shape.exponent) + std::pow(scaled.y(), shape.exponent) < 1.0;
}

/// Points all along the boundary, at most about 0.004 apart.
std::vector<Vector2d> boundary(const PlanarObstacle &obstacle)
{
    std::vector<Vector2d> points;
    if (const auto *polygon = std::get_if<Polygon>(&obstacle.shape))
    {
        const std::vector<Vector2d> &corners = polygon->vertices;
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (int k = 0; k < 500; ++k)
                points.push_back(corners[i] + k / 500.0 * (corners[(i + 1) % corners.size()] - corners[i]));
        return points;
    }
    const auto *circle = std::get_if<Circle>(&obstacle.shape);
    const Superellipse shape = circle ? Superellipse{circle->center, Vector2d::Constant(circle->radius), 2.0}
                                      : std::get<Superellipse>(obstacle.shape);
    for (int k = 0; k < 2000; ++k)
    {
        const Vector2d ray(std::cos(k * std::acos(-1.0) / 1000), std::sin(k * std::acos(-1.0) / 1000));
        const double gauge =
            std::pow(std::pow(std::abs(ray.x()), shape.exponent) + std::pow(std::abs(ray.y()), shape.exponent),
                     1.0 / shape.exponent);
        points.push_back(shape.center + shape.halfExtents.cwiseProduct(ray) / gauge);
    }
    return points;
}

bool meets(const PlanarObstacle &obstacle, const Segment &link)
{
    for (int k = 0; k <= 2000; ++k)
        if (covers(obstacle, link.at(k / 2000.0)))
            return true;
    return false;
}

class Links
{
public:
    Segment next() { return Segment::between(point(), point()); }

private:
    Vector2d point()
    {
        const double x = uniform_(generator_);
        return {x, uniform_(generator_)};
    }

    std::mt19937 generator_{5};
    std::uniform_real_distribution<double> uniform_{-1.7, 1.7};
};

/// Derivative of `term` by the link's four coordinates against differences of its value.
template <class Term>
void expectSlope(const Term &term, const Segment &link, double tolerance, const std::string &where)
{
    const LinkForce slope = term(link).slope;
    const double h = 1e-6;
    for (int i = 0; i < 4; ++i)
    {
        const Vector2d base = i < 2 ? Vector2d(h * Vector2d::Unit(i)) : Vector2d::Zero();
        const Vector2d along = i < 2 ? Vector2d::Zero() : Vector2d(h * Vector2d::Unit(i - 2));
        const auto moved = [&](double way)
        {
            const Vector2d from = link.base + way * base;
            return term(Segment::between(from, from + link.along + way * along)).value;
        };
        const double difference = (moved(1.0) - moved(-1.0)) / (2.0 * h);
        const double stated = i < 2 ? slope.force[i] : slope.lever[i - 2];
        EXPECT_NEAR(stated, difference, tolerance * (1.0 + std::abs(difference))) << where << ", coordinate " << i;
    }
}

class LinkObstacles : public testing::TestWithParam<const char *>
{
};

TEST_P(LinkObstacles, ClearanceIsTheLeastDistanceOfManyPoints)
{
    const PlanarObstacle obstacle = named(GetParam());
    const double radius = 0.07;
    const auto shape = makeLinkObstacle(obstacle, radius, 1.0);
    const std::vector<Vector2d> points = boundary(obstacle);
    Links links;
    int outside = 0, inside = 0;
    for (int trial = 0; trial < 300; ++trial)
    {
        const Segment link = links.next();
        const double clearance = shape->clearance(link).value;
        if (meets(obstacle, link))
        {
            EXPECT_LE(clearance, -radius) << trial;
            EXPECT_GT(clearance, -radius - 1.0) << trial;
            ++inside;
            continue;
        }
        double least = 10.0;
        for (const Vector2d &point : points)
            least = std::min(least, squaredDistance(link.base, link.tip(), point));
        EXPECT_LE(clearance, std::sqrt(least) - radius + 1e-12) << trial;
        EXPECT_NEAR(clearance, std::sqrt(least) - radius, 4e-3) << trial;
        ++outside;
    }
    EXPECT_GT(outside, 40);
    EXPECT_GT(inside, 40);
}

TEST_P(LinkObstacles, PoleHasTheSignOfTheClearance)
{
    const PlanarObstacle obstacle = named(GetParam());
    for (const double radius : {0.0, 0.2})
    {
        const auto shape = makeLinkObstacle(obstacle, radius, 1.0);
        Links links;
        int changes = 0;
        for (int trial = 0; trial < 300; ++trial)
        {
            const Segment link = links.next();
            const double clearance = shape->clearance(link).value;
            const double pole = shape->pole(link).value;
            ASSERT_TRUE(std::isfinite(pole));
            EXPECT_EQ(pole > 0.0, clearance > 0.0) << trial << ": " << pole << ", " << clearance;
            EXPECT_EQ(shape->isMet(link), pole < 0.0) << trial << ": " << pole;
            changes += clearance > 0.0 ? 0 : 1;
        }
        EXPECT_GT(changes, 40);
        EXPECT_LT(changes, 260);
    }
}

TEST_P(LinkObstacles, PoleDerivativesAgreeWithDifferences)
{
    for (const double radius : {0.0, 0.2})
    {
        const auto shape = makeLinkObstacle(named(GetParam()), radius, 1.0);
        Links links;
        int checked = 0;
        for (int trial = 0; trial < 300; ++trial)
        {
            const Segment link = links.next();
            if (!(shape->clearance(link).value > 1e-3))
                continue;
            expectSlope([&](const Segment &moved) { return shape->pole(moved); }, link, 2e-6,
                        "trial " + std::to_string(trial));
            ++checked;
        }
        EXPECT_GT(checked, 30);
    }
}

TEST_P(LinkObstacles, PoleVanishesLinearlyWhereTheLinkBeginsToTouch)
{
    // Links that sink from above: between touching and 1e-7 apart, C is (d - 0) times a slope that hardly changes.
    const PlanarObstacle obstacle = named(GetParam());
    const double radius = 0.05;
    const auto shape = makeLinkObstacle(obstacle, radius, 1.0);
    const auto at = [](double height)
    {
        return Segment::between({-1.4, height}, {1.5, height + 0.3});
    };
    double free = 3.0, touching = 0.0;
    for (int halving = 0; halving < 200; ++halving)
    {
        const double middle = 0.5 * (free + touching);
        (shape->clearance(at(middle)).value > 0.0 ? free : touching) = middle;
    }
    const double near = shape->pole(at(free + 1e-7)).value;
    EXPECT_GT(near, 0.0);
    EXPECT_NEAR(shape->pole(at(free + 2e-7)).value / near, 2.0, 1e-2);
    EXPECT_LE(shape->pole(at(free - 1e-7)).value, 0.0);
    EXPECT_NEAR(shape->pole(at(free)).value, 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Shapes, LinkObstacles, testing::Values("circle", "quartic", "ellipse", "odd", "box", "notch"),
                         [](const auto &test) { return std::string(test.param); });

TEST(LinkObstacle, RoundSuperellipseIsTheCircle)
{
    const auto circle = makeLinkObstacle({"C", Circle{{0.2, 0.1}, 0.4}}, 0.1, 1.0);
    const auto round = makeLinkObstacle({"E", Superellipse{{0.2, 0.1}, {0.4, 0.4}, 2.0}}, 0.1, 1.0);
    Links links;
    int compared = 0;
    for (int trial = 0; trial < 100; ++trial)
    {
        const Segment link = links.next();
        const double pole = circle->pole(link).value;
        if (!(pole > 0.0))
            continue;
        EXPECT_NEAR(round->pole(link).value, pole, 1e-12 * (1.0 + pole));
        ++compared;
    }
    EXPECT_GT(compared, 30);
}

/// e (e + 2 (R + radius)), with e from e (e + 2 radius) = (sum of (d^2 - radius^2)^-2)^(-1/2) over `squares`, the d^2.
double statedPole(const std::vector<double> &squares, double radius, double size)
{
    double sum = 0.0;
    for (const double square : squares)
        sum += std::pow(square - radius * radius, -2.0);
    const double e = std::sqrt(1.0 / std::sqrt(sum) + radius * radius) - radius;
    return e * (e + 2.0 * (size + radius));
}

TEST(LinkObstacle, PoleOfPolygonsIsTheStatedFormula)
{
    // A link above the box, parallel to it: its ends are over the top edge, two corners of which lie beside it.
    const Segment link = Segment::between({-0.3, 0.8}, {0.4, 0.8});
    std::vector<double> squares;
    for (const double side : {-0.6, 0.7})
        for (const double height : {0.5, 1.2})
            squares.push_back(squaredDistance(link.base, link.tip(), {side, 0.8 - height}));
    for (const double x : {-0.3, 0.4})
        for (const double square : {0.25, 1.44, 0.25 + (0.6 + x) * (0.6 + x), 0.25 + (0.7 - x) * (0.7 - x)})
            squares.push_back(square);
    for (const double radius : {0.0, 0.2})
        for (const double reach : {0.1, 100.0})
        {
            const double round = std::sqrt(1.3 * 0.7 / std::acos(-1.0));  // as large as the box
            EXPECT_NEAR(makeLinkObstacle({"B", box}, radius, reach)->pole(link).value,
                        statedPole(squares, radius, std::min(round, reach)), 1e-14);
        }
}

TEST(LinkPair, PoleIsTheStatedFormula)
{
    const Segment first = Segment::between({0, 0}, {1, 0}), second = Segment::between({0.5, 0.4}, {0.5, 1.4});
    const std::vector<double> squares{0.16, 1.96, 0.41, 0.41};
    for (const double radius : {0.0, 0.3})
        EXPECT_NEAR(pairPole(first, second, radius, 2.0 * (0.7 + radius)).value, statedPole(squares, radius, 0.7),
                    1e-14);
}

TEST(LinkObstacle, PoleOfPolygonsHasNoKinkWhereALinkLiesParallelToAnEdge)
{
    // The distance has one: it falls whichever way the link turns. Slopes left and right of parallel would differ by
    // the link's length times dC/dd.
    const auto shape = makeLinkObstacle({"B", box}, 0.0, 1.0);
    const auto turned = [&shape](double angle)
    {
        const Vector2d half = 0.3 * Vector2d(std::cos(angle), std::sin(angle));
        const LinkTerm term = shape->pole(Segment::between(Vector2d(0.0, 0.4) - half, Vector2d(0.0, 0.4) + half));
        const Vector2d turning(-2.0 * half.y(), 2.0 * half.x());
        return term.slope.lever.dot(turning) - 0.5 * term.slope.force.dot(turning);
    };
    EXPECT_NEAR(turned(1e-9), turned(-1e-9), 1e-6);
    EXPECT_NEAR(turned(0.0), 0.0, 1e-3);  // the box is not quite symmetric to the link
    EXPECT_GT(std::abs(turned(0.3) - turned(-0.3)), 0.1);
}

TEST(LinkObstacle, DepthOfAConvexPolygonIsTheLeastShiftThatFreesTheLink)
{
    const auto shape = makeLinkObstacle({"B", box}, 0.0, 1.0);
    Links links;
    int checked = 0;
    for (int trial = 0; trial < 200; ++trial)
    {
        const Segment link = links.next();
        const LinkTerm term = shape->clearance(link);
        if (!(term.value < -1e-3))
            continue;
        ++checked;
        const auto shifted = [&](double way, double angle)
        {
            const Vector2d shift = way * Vector2d(std::cos(angle), std::sin(angle));
            return shape->clearance(Segment::between(link.base + shift, link.tip() + shift)).value;
        };
        for (int k = 0; k < 90; ++k)
            EXPECT_LE(shifted(-0.99 * term.value, k * std::acos(-1.0) / 45), 0.0) << trial;
        const double angle = std::atan2(term.slope.force.y(), term.slope.force.x());
        EXPECT_GT(shifted(-1.001 * term.value, angle), 0.0) << trial;
    }
    EXPECT_GT(checked, 40);
}

TEST(ConvexParts, CoverThePolygonOnce)
{
    for (const Polygon &polygon : {box, notch, Polygon{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}})
    {
        std::mt19937 generator(3);
        std::uniform_real_distribution<double> uniform(-1.0, 4.0);
        const std::vector<Polygon> parts = convexParts(polygon);
        int inside = 0;
        for (int k = 0; k < 4000; ++k)
        {
            const double x = uniform(generator);
            const Vector2d point(x, uniform(generator));
            int covering = 0;
            for (const Polygon &part : parts)
                covering += contains(part, point) ? 1 : 0;
            EXPECT_EQ(covering, contains(polygon, point) ? 1 : 0) << point.transpose();
            inside += covering;
        }
        EXPECT_GT(inside, 50);
    }
    EXPECT_EQ(convexParts(box).size(), 1u);
    EXPECT_GE(convexParts(notch).size(), 3u);
}

TEST(LinkPair, PoleAndClearanceOfTwoLinks)
{
    Links links;
    int crossing = 0, apart = 0;
    for (int trial = 0; trial < 300; ++trial)
    {
        const Segment first = links.next(), second = links.next();
        const double radius = trial % 2 == 0 ? 0.0 : 0.1;
        const PairTerm clearance = pairClearance(first, second, radius);
        const double distance = narrows::distance(first.base, first.tip(), second.base, second.tip());
        if (distance > 0.0)
            EXPECT_NEAR(clearance.value, distance - radius, 1e-12) << trial;
        else
            EXPECT_LT(clearance.value, -radius) << trial;
        const PairTerm pole = pairPole(first, second, radius, 1.0);
        EXPECT_EQ(pole.value > 0.0, clearance.value > 0.0) << trial;
        (distance > 0.0 ? apart : crossing) += 1;
        if (!(clearance.value > 1e-3))
            continue;
        const auto asFirst = [&](const Segment &moved)
        {
            const PairTerm term = pairPole(moved, second, radius, 1.0);
            return LinkTerm{term.value, term.first};
        };
        const auto asSecond = [&](const Segment &moved)
        {
            const PairTerm term = pairPole(first, moved, radius, 1.0);
            return LinkTerm{term.value, term.second};
        };
        expectSlope(asFirst, first, 2e-6, "first, trial " + std::to_string(trial));
        expectSlope(asSecond, second, 2e-6, "second, trial " + std::to_string(trial));
    }
    EXPECT_GT(crossing, 30);
    EXPECT_GT(apart, 30);
}
}  // namespace
}  // namespace narrows
