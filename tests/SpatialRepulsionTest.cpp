// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialRepulsionModel.h"

#include <gtest/gtest.h>

#include "SpatialScenes.h"
#include "kernel/EdgedPole.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

std::shared_ptr<const RepulsionModel> modelOf(const SpatialArm &arm, std::vector<SpatialObstacle> obstacles, bool self)
{
    return spatialRepulsionModel(std::make_shared<const SpatialModel>(SpatialModel{arm, std::move(obstacles), self}));
}

/// One obstacle of every kind, around the robots of SpatialRobots.h but not at their feet.
std::vector<SpatialObstacle> surroundings(unsigned seed)
{
    std::mt19937 generator(seed);
    std::vector<SpatialObstacle> obstacles;
    for (int kind = 0; kind < obstacleKinds; ++kind)
    {
        obstacles.push_back(randomObstacle(kind, generator));
        const Vector3d away = 1.5 * randomPoint(1.0, generator).normalized();
        std::visit(ShiftBy{away}, obstacles.back().shape);
    }
    return obstacles;
}

SpatialArm robot(int which)
{
    return which == 0 ? snake() : which == 1 ? sixAxisArm() : gantryHand();
}

class EveryRobot : public testing::TestWithParam<int>
{
};

TEST_P(EveryRobot, GradientIsTheDerivativeOfEveryGroup)
{
    std::mt19937 generator(17);
    const SpatialArm arm = robot(GetParam());
    int examined = 0;
    for (unsigned scene = 0; scene < 20; ++scene)
    {
        const auto model = modelOf(arm, surroundings(scene), true);
        for (std::size_t group = 0; group < model->groups().size(); ++group)
        {
            std::vector<double> strengths(model->groups().size(), 0.0);
            strengths[group] = 0.3;
            const auto repulsion = model->continuous(strengths);
            const VectorXd q = randomVector(arm.dimension(), 0.9, generator);
            Repulsion::Sample sample;
            repulsion->evaluate(q, sample);
            // Too close to a pole, differences say nothing.
            if (*std::min_element(sample.poles.begin(), sample.poles.end()) < 0.02)
                continue;
            ++examined;
            EXPECT_EQ(repulsion->value(q), sample.value);
            for (int i = 0; i < arm.dimension(); ++i)
            {
                const VectorXd step = 1e-6 * VectorXd::Unit(arm.dimension(), i);
                const double slope = (repulsion->value(q + step) - repulsion->value(q - step)) / 2e-6;
                EXPECT_NEAR(sample.gradient[i], slope, 1e-5 * (1.0 + std::abs(slope)))
                    << "scene " << scene << ", " << model->groups()[group] << ", joint " << i;
            }
        }
    }
    EXPECT_GT(examined, 80);
}

TEST_P(EveryRobot, ClearanceIsTheLeastDistanceAndHasItsGradient)
{
    std::mt19937 generator(18);
    const SpatialArm arm = robot(GetParam());
    int clear = 0;
    for (unsigned scene = 0; scene < 200; ++scene)
    {
        const std::vector<SpatialObstacle> obstacles = surroundings(scene);
        const auto model = modelOf(arm, obstacles, true);
        const VectorXd q = randomVector(arm.dimension(), 0.9, generator);
        SpatialArm::Placement placement;
        arm.place(q, placement);
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < arm.linkCount(); ++i)
        {
            const Vector3d &a = placement.points[2 * i], &b = placement.points[2 * i + 1];
            const double radius = arm.links()[i].radius;
            for (const SpatialObstacle &obstacle : obstacles)
                least = std::min(least, nearnessOf(obstacle, a, b).distance - radius);
            for (int j = 0; j < i; ++j)
                if (!arm.areNeighbours(i, j))
                    least = std::min(least, nearness(a, b,
                                                     Capsule{placement.points[2 * j], placement.points[2 * j + 1],
                                                             arm.links()[j].radius})
                                                    .distance -
                                                radius);
        }
        VectorXd gradient, ignored;
        ASSERT_NEAR(model->clearance(q, gradient), least, 1e-12);
        if (least < 1e-3)
            continue;
        ++clear;
        int matches = 0;
        for (int i = 0; i < arm.dimension(); ++i)
        {
            const VectorXd step = 1e-6 * VectorXd::Unit(arm.dimension(), i);
            const double slope = (model->clearance(q + step, ignored) - model->clearance(q - step, ignored)) / 2e-6;
            matches += std::abs(gradient[i] - slope) < 1e-4;
        }
        EXPECT_EQ(matches, arm.dimension()) << "scene " << scene;
    }
    EXPECT_GT(clear, 20);
}

INSTANTIATE_TEST_SUITE_P(SpatialRepulsion, EveryRobot, testing::Range(0, 3));

/// Poles are positive where the pair is clear, 0 at contact, negative inside, and finite there.
TEST(SpatialRepulsion, PolesChangeSignAtContact)
{
    std::mt19937 generator(19);
    const SpatialArm arm = universalChain(Vector3d::Zero(), {1.0}, 0.05);
    int crossings[obstacleKinds] = {};
    for (int trial = 0; trial < 3000; ++trial)
    {
        const int kind = trial % obstacleKinds;
        const SpatialObstacle obstacle = randomObstacle(kind, generator);
        const auto repulsion = modelOf(arm, {obstacle}, false)->continuous({0.1});
        Repulsion::Sample sample;
        SpatialArm::Placement placement;
        const VectorXd from = randomVector(2, 1.5, generator), to = randomVector(2, 1.5, generator);
        double before = 0.0;
        for (int k = 0; k <= 20; ++k)
        {
            const VectorXd q = from + k / 20.0 * (to - from);
            repulsion->evaluate(q, sample);
            arm.place(q, placement);
            const double distance = nearnessOf(obstacle, placement.points[0], placement.points[1]).distance - 0.05;
            ASSERT_EQ(sample.poles.size(), 1u);
            if (std::abs(distance) < 1e-9)
                continue;
            ASSERT_TRUE(std::isfinite(sample.value) && sample.gradient.allFinite());
            ASSERT_EQ(sample.poles[0] > 0.0, distance > 0.0) << obstacle.name << " " << distance;
            crossings[kind] += before * distance < 0.0;
            before = distance;
        }
    }
    for (int kind = 0; kind < obstacleKinds; ++kind)
        EXPECT_GT(crossings[kind], 20) << kind;
}

TEST(SpatialRepulsion, SpheresAndPipesHaveThePapersFunction)
{
    const SpatialArm arm = universalChain(Vector3d::Zero(), {1.0}, 0.1);
    const Sphere sphere{{0.4, 0.0, 0.9}, 0.3};
    const Cylinder pipe{{0.0, 0.0, -1.0}, Vector3d::UnitY(), 0.25, std::numeric_limits<double>::infinity()};
    const auto repulsion = modelOf(arm, {{"ball", sphere}, {"pipe", pipe}}, false)->continuous({0.5, -0.2});
    Repulsion::Sample sample;
    repulsion->evaluate(VectorXd::Zero(2), sample);
    EXPECT_NEAR(sample.value, 0.5 / (0.81 - 0.16) - 0.2 / (1.0 - 0.35 * 0.35), 1e-14);
}

/// The distance's slope jumps where a link swings through the position parallel to a face; the stand-in's must not.
TEST(EdgedPole, IsSmoothWhereALinkIsParallelToAFace)
{
    const Box box{Eigen::Isometry3d::Identity(), {2.0, 1.0, 0.5}};
    const EdgedPole pole(box);
    const auto tilted = [&](double tilt)
    {
        return pole.clearance({-0.5, 0.2, 0.8 + tilt}, {0.5, 0.3, 0.8 - tilt}, 0.05);
    };
    const SpatialTerm before = tilted(-1e-6), after = tilted(1e-6);
    EXPECT_LT((before.slope.a - after.slope.a).norm(), 1e-4);
    EXPECT_LT((before.slope.b - after.slope.b).norm(), 1e-4);
    // The distance itself goes from one end to the other.
    const Nearness left = nearness(Vector3d(-0.5, 0.2, 0.8 - 1e-6), Vector3d(0.5, 0.3, 0.8 + 1e-6), box);
    const Nearness right = nearness(Vector3d(-0.5, 0.2, 0.8 + 1e-6), Vector3d(0.5, 0.3, 0.8 - 1e-6), box);
    EXPECT_EQ(left.fraction, 0.0);
    EXPECT_EQ(right.fraction, 1.0);
}

/// The edges of a box are those of the prism over its face, and endless ones do not end where a link can be.
TEST(EdgedPole, IsTheSameForABoxAndForItAsAPrism)
{
    std::mt19937 generator(24);
    for (int trial = 0; trial < 300; ++trial)
    {
        const Box box = randomBox(generator);
        const double x = box.halfExtents.x(), y = box.halfExtents.y();
        Prism prism{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, box.pose, box.halfExtents.z()};
        const Vector3d a = randomPoint(2.0, generator), b = randomPoint(2.0, generator);
        const SpatialTerm one = EdgedPole(box).clearance(a, b, 0.05),
                          other = EdgedPole(prism, 4.0).clearance(a, b, 0.05);
        ASSERT_NEAR(one.value, other.value, 1e-12);
        if (one.value > 0.0)  // inside, two faces may be as near as each other
        {
            ASSERT_LT((one.slope.a - other.slope.a).norm() + (one.slope.b - other.slope.b).norm(), 1e-9);
        }
        prism.halfLength = std::numeric_limits<double>::infinity();
        ASSERT_NEAR(EdgedPole(prism, 4.0).clearance(a, b, 0.05).value,
                    EdgedPole(prism, 400.0).clearance(a, b, 0.05).value, 1e-12);
    }
}

TEST(EdgedPole, IsNeverMoreThanTheClearanceAndMeetsItAtContact)
{
    std::mt19937 generator(20);
    int clear = 0;
    for (int trial = 0; trial < 3000; ++trial)
    {
        const EdgedPole pole =
            trial % 2 == 0 ? EdgedPole(randomBox(generator)) : EdgedPole(randomPrism(trial % 4 == 1, generator), 4.0);
        const Vector3d a = randomPoint(2.0, generator), b = randomPoint(2.0, generator);
        const double distance = pole.nearest(a, b).distance;
        for (const double radius : {0.0, 0.02, distance - 1e-9})
        {
            const double value = pole.clearance(a, b, std::max(radius, 0.0)).value;
            const double exact = distance - std::max(radius, 0.0);
            ASSERT_LE(value, exact + 1e-12);
            ASSERT_EQ(value > 0.0, exact > 0.0);
            ASSERT_GE(value, std::min(exact, 0.1 * exact) - 1e-12);
            clear += exact > 0.0;
        }
    }
    EXPECT_GT(clear, 1000);
}

TEST(SpatialRepulsion, LimitsHavePolesAtBothEndsAndUniversalOnesOfTheirOwn)
{
    const SpatialArm arm = universalChain(Vector3d::Zero(), {1.0, 1.0}, 0.05,
                                          std::make_pair(Vector3d(Vector3d::UnitX()), Interval{-1.0, 2.0}), 0.6);
    const auto model = modelOf(arm, {}, false);
    ASSERT_EQ(model->groups(), std::vector<std::string>{"limits"});
    VectorXd q(5);
    q << 0.5, 0.1, -0.2, 0.3, 0.4;
    Repulsion::Sample sample;
    model->continuous({1.0})->evaluate(q, sample);
    ASSERT_EQ(sample.poles.size(), 4u);  // the angles' own intervals say nothing more
    EXPECT_NEAR(sample.poles[0], 1.5, 1e-15);
    EXPECT_NEAR(sample.poles[1], 1.5, 1e-15);
    EXPECT_NEAR(sample.poles[2], std::cos(0.1) * std::cos(0.2) - std::cos(0.6), 1e-15);
    EXPECT_NEAR(sample.poles[3], std::cos(0.3) * std::cos(0.4) - std::cos(0.6), 1e-15);
    q << 2.1, 0.0, 0.6001, 0.0, 0.0;
    model->continuous({1.0})->evaluate(q, sample);
    EXPECT_LT(sample.poles[1], 0.0);
    EXPECT_LT(sample.poles[2], 0.0);
    model->continuous({0.0})->evaluate(q, sample);
    EXPECT_TRUE(sample.poles.empty());
    EXPECT_EQ(sample.gradient, VectorXd::Zero(5));
}

TEST(SpatialRepulsion, RefusesWrongStrengthsAndPoints)
{
    const auto model = modelOf(sixAxisArm(), surroundings(1), true);
    EXPECT_EQ(model->groups().size(), obstacleKinds + 2u);
    EXPECT_EQ(model->groups().back(), "self");
    EXPECT_EQ(model->obstacleCount(), static_cast<std::size_t>(obstacleKinds));
    EXPECT_THROW(model->continuous({1.0}), std::invalid_argument);
    std::vector<double> strengths(model->groups().size(), 1.0);
    strengths[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(model->continuous(strengths), std::invalid_argument);
    EXPECT_FALSE(model->supportsPoints());
    EXPECT_THROW(model->points(std::vector<double>(model->groups().size(), 1.0), 5), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
