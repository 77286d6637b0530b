// SPDX-License-Identifier: BSD-3-Clause
#include "validity/SpatialChecker.h"

#include <gtest/gtest.h>

#include "SpatialScenes.h"
#include "validity/LinkwiseChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

SpatialModel modelWith(const SpatialObstacle &obstacle)
{
    return {snake(), {obstacle}, false};
}

TEST(SpatialChecker, ClearsAndClearanceSayWhatTheDistancesSay)
{
    std::mt19937 generator(4);
    int clear = 0, touching = 0;
    for (int trial = 0; trial < 3000; ++trial)
    {
        const SpatialObstacle obstacle = randomObstacle(trial % obstacleKinds, generator);
        const auto checker = makeAnalyticChecker(modelWith(obstacle));
        const Link<3> link{randomPoint(1.5, generator), randomPoint(1.5, generator), 0.1};
        const double distance = nearnessOf(obstacle, link.a, link.b).distance;
        ASSERT_EQ(checker->clears(link), distance > link.radius) << obstacle.name;
        ASSERT_NEAR(checker->clearance(link), distance - link.radius, 1e-12) << obstacle.name;
        ++(distance > link.radius ? clear : touching);
    }
    EXPECT_GT(clear, 300);
    EXPECT_GT(touching, 300);
}

/// A link in the middle of a stretch of a random motion of some robot.
struct Passage
{
    SpatialArm arm;
    VectorXd middle, delta;
    int link;
    double half;

    LinkMotion<3> motion(int which) const
    {
        MovingArm<SpatialArm> moving;
        moving.begin(arm, middle, delta);
        moving.place(0.0);
        return moving.motion(which, half, 0.0);
    }

    /// Ends of a link somewhere on the stretch.
    std::pair<Vector3d, Vector3d> at(int which, double t) const
    {
        SpatialArm::Placement placement;
        arm.place(middle + t * delta, placement);
        return {placement.points[2 * which], placement.points[2 * which + 1]};
    }
};

Passage randomPassage(int trial, std::mt19937 &generator)
{
    Passage passage{trial % 2 == 0 ? snake() : sixAxisArm(), {}, {}, 0, 0.0};
    passage.middle = randomVector(passage.arm.dimension(), 1.5, generator);
    passage.delta = randomVector(passage.arm.dimension(), 1.0, generator);
    passage.link = passage.arm.linkCount() - 1 - trial % 3;
    passage.half = 0.5 * std::pow(10.0, -3.0 * randomPoint(1.0, generator).cwiseAbs().x());
    return passage;
}

/// The heart of the matter: what is certified is free all along the stretch, and this is not for want of trying.
TEST(SpatialChecker, CertifiedStretchesNeverCollide)
{
    std::mt19937 generator(9);
    int firstOrder[obstacleKinds] = {}, secondOrder[obstacleKinds] = {}, collisions[obstacleKinds] = {};
    for (int trial = 0; trial < 8000; ++trial)
    {
        const int kind = trial % obstacleKinds;
        const Passage passage = randomPassage(trial, generator);
        const LinkMotion<3> motion = passage.motion(passage.link);
        SpatialObstacle obstacle = randomObstacle(kind, generator);
        const double gap = motion.reach() * std::pow(10.0, -2.5 * randomPoint(1.0, generator).cwiseAbs().x());
        if (!bringNear(obstacle, motion.a.position, motion.b.position, motion.radius, gap))
            continue;
        const Finding finding = makeAnalyticChecker(modelWith(obstacle))->examine(motion);
        ASSERT_NE(finding, Finding::Touching);
        double least = std::numeric_limits<double>::infinity();
        for (int k = -20; k <= 20; ++k)
        {
            const auto [a, b] = passage.at(passage.link, passage.half * k / 20.0);
            least = std::min(least, nearnessOf(obstacle, a, b).distance - motion.radius);
        }
        if (finding == Finding::Clear)
        {
            ASSERT_GT(least, 0.0) << "trial " << trial << ", " << obstacle.name;
            ++(gap > motion.reach() ? firstOrder : secondOrder)[kind];
        }
        collisions[kind] += least <= 0.0;
    }
    for (int kind = 0; kind < obstacleKinds; ++kind)
    {
        EXPECT_GT(secondOrder[kind], 100) << kind;
        EXPECT_GT(collisions[kind], 20) << kind;
    }
}

TEST(SpatialChecker, CertifiedPairsOfLinksNeverCollide)
{
    std::mt19937 generator(10);
    int clear = 0, collisions = 0;
    for (int trial = 0; trial < 20000; ++trial)
    {
        Passage passage = randomPassage(0, generator);
        passage.middle = randomVector(passage.arm.dimension(), 3.0, generator);
        const int one = trial % 2 + 2, other = one - 2;
        const LinkMotion<3> first = passage.motion(one), second = passage.motion(other);
        const auto checker = makeAnalyticChecker({passage.arm, {}, true});
        const Finding finding = checker->examine(first, second);
        const bool touches = !checker->clears({first.a.position, first.b.position, first.radius},
                                              {second.a.position, second.b.position, second.radius});
        ASSERT_EQ(finding == Finding::Touching, touches);
        double least = std::numeric_limits<double>::infinity();
        for (int k = -20; k <= 20; ++k)
        {
            const auto [a, b] = passage.at(one, passage.half * k / 20.0);
            const auto [c, d] = passage.at(other, passage.half * k / 20.0);
            least = std::min(least, nearness(a, b, Capsule{c, d, second.radius}).distance - first.radius);
        }
        if (finding == Finding::Clear)
        {
            ASSERT_GT(least, 0.0) << "trial " << trial;
            clear += least < first.reach() + second.reach();
        }
        collisions += least <= 0.0;
    }
    EXPECT_GT(clear, 1000);
    EXPECT_GT(collisions, 100);
}

/// A link that swings about a pivot below an obstacle at the origin (without any: another link) and comes as close to
/// it as `gap` in the middle of its way. With the obstacle's radius r there, the distance is gap + 0.3 (1 - cos q).
SpatialModel swing(double gap, double r, const std::vector<SpatialObstacle> &obstacles)
{
    Eigen::Isometry3d pivot = Eigen::Isometry3d::Identity();
    pivot.translation().z() = -0.3;
    const double height = 0.3 + r + 0.05 + gap;
    std::vector<SpatialLink> links{{0, {-1.0, 0.0, height}, {1.2, 0.0, height}, 0.05}};
    if (obstacles.empty())
        links.push_back({-1, {0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, r});
    return {SpatialArm({{SpatialJoint::Kind::Revolute, -1, pivot, Vector3d::UnitY(), std::nullopt}}, links), obstacles,
            obstacles.empty()};
}

/// First-order certificates would need steps in proportion to the gap.
TEST(SpatialChecker, PlacementsGrowLikeTheLogarithmOfTheGap)
{
    const Vector3d tilted = Vector3d(0.2, 1.0, 0.0).normalized();
    Eigen::Isometry3d edgeUp(Eigen::AngleAxisd(0.5 * std::acos(0.0), Vector3d::UnitY()));
    edgeUp.pretranslate(Vector3d(0.0, 0.0, -std::sqrt(0.02)));
    const Box box{edgeUp, {0.1, 0.7, 0.1}};
    // The same box as a prism along y, also without ends, and as one whose end has an edge at the origin.
    const std::vector<Eigen::Vector2d> square{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
    Eigen::Isometry3d alongY = edgeUp;
    alongY.rotate(Eigen::AngleAxisd(std::acos(0.0), Vector3d::UnitX()));
    const Prism prism{square, alongY, 0.7};
    const Prism ridge{square, alongY, std::numeric_limits<double>::infinity()};
    const Prism end{{{-0.1, -0.7}, {0.1, -0.7}, {0.1, 0.7}, {-0.1, 0.7}}, edgeUp, 0.1};
    // A cylinder whose rim is at the origin.
    const Vector3d axis = Vector3d(1.0, 0.0, 1.0).normalized();
    const Cylinder rim{-0.5 * axis - 0.2 * Vector3d(-1.0, 0.0, 1.0).normalized(), axis, 0.2, 0.5};
    const std::vector<std::pair<double, std::vector<SpatialObstacle>>> scenes{
        {0.4, {{"sphere", Sphere{Vector3d::Zero(), 0.4}}}},
        {0.3, {{"capsule", Capsule{-tilted, tilted, 0.3}}}},
        {0.2, {{"cylinder", Cylinder{Vector3d::Zero(), tilted, 0.2, 1.0}}}},
        {0.2, {{"pipe", Cylinder{Vector3d::Zero(), tilted, 0.2, std::numeric_limits<double>::infinity()}}}},
        {0.0, {{"rim", rim}}},
        {0.0, {{"box", box}}},
        {0.0, {{"mesh", boxMesh(box, 3)}}},
        {0.0, {{"prism", prism}}},
        {0.0, {{"endless prism", ridge}}},
        {0.0, {{"end of a prism", end}}},
        {0.1, {}}};  // link against link
    for (const auto &[radius, obstacles] : scenes)
    {
        std::vector<std::uint64_t> counts;
        for (const double gap : {1e-2, 1e-4, 1e-6, 1e-8})
        {
            const auto checker = makeArmChecker("analytic", swing(gap, radius, obstacles));
            std::uint64_t placements = 0;
            ASSERT_NEAR(checker->clearance(VectorXd::Zero(1)), gap, 1e-12);
            EXPECT_TRUE(checker->isMotionFree(VectorXd::Constant(1, -0.5), VectorXd::Constant(1, 1.1), placements));
            counts.push_back(placements);
        }
        EXPECT_LE(counts[3], counts[1] + 100) << (obstacles.empty() ? "self" : obstacles[0].name);
    }
}
}  // namespace
}  // namespace narrows
