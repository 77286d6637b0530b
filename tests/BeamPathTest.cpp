// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/beams/BeamPath.h"

#include <gtest/gtest.h>

#include "LadderScenes.h"
#include "kernel/chain/ChainCertificate.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

BeamOptions optionsFor(double length)
{
    BeamOptions options;
    options.fan.linkLength = length;
    options.fan.radius = 5.0;
    options.fan.spacing = 10.0;
    options.window = 50.0;
    return options;
}

BeamPath<2> pathThrough(const ChainScene<2> &scene, const BeamOptions &options)
{
    return beamPath<2>(middleOf(scene), signedDistance<2>(scene.walls), options);
}

ChainFailure judge(const std::string &shape, double length, const BeamOptions &options)
{
    const ChainScene<2> scene = ladderScene(shape, length);
    const BeamPath<2> beams = pathThrough(scene, options);
    EXPECT_EQ(beams.failure, BeamFailure::None) << toText(beams.failure);
    // Twice the links of the family: the path swings wide.
    return certifyChain<2>(LeaderPath<2>(beams.path, Vector2d::UnitY()), ChordObstacles<2>(obstaclesOf(scene.walls)),
                           {2 * scene.links, length, scene.radius})
        .failure;
}

TEST(BeamPath, PassesALinkAlmostAsLongAsGeometryAllows)
{
    EXPECT_EQ(judge("L", 540.0, optionsFor(540.0)), ChainFailure::None);  // of 541.5
    EXPECT_EQ(judge("L", 545.0, optionsFor(545.0)), ChainFailure::ChordClearance);
    EXPECT_EQ(judge("U40", 425.0, optionsFor(425.0)), ChainFailure::None);  // of 430
    EXPECT_NE(judge("U40", 435.0, optionsFor(435.0)), ChainFailure::None);
}

TEST(BeamPath, JumpsInShortBendsWithoutARamp)
{
    EXPECT_EQ(judge("Z300", 260.0, optionsFor(260.0)), ChainFailure::Jump);
    BeamOptions ramped = optionsFor(260.0);
    ramped.ramp = 300.0;
    ramped.fan.longest = 150.0;
    EXPECT_EQ(judge("Z300", 260.0, ramped), ChainFailure::None);
    EXPECT_NE(judge("Z300", 450.0, optionsFor(450.0)), ChainFailure::None);
}

TEST(BeamPath, SwingsAwayFromTheInnerCorner)
{
    const ChainScene<2> scene = ladderScene("Z600");
    const BeamPath<2> beams = pathThrough(scene, optionsFor(350.0));
    ASSERT_EQ(beams.regions.size(), 2u);
    EXPECT_EQ(beams.regions[0].side, 1) << "first to the right";
    EXPECT_EQ(beams.regions[1].side, 0);
    EXPECT_EQ(beams.path.front(), scene.entrance);
    EXPECT_EQ(beams.path.back(), scene.goal);
    EXPECT_NEAR(beams.path[5].x(), 5.1, 0.01) << "along the left wall before a bend to the right";
    EXPECT_NEAR(beams.path[beams.path.size() - 6].x(), 794.9, 0.01) << "along the right wall behind one to the left";
    EXPECT_EQ(beams.beams, 2 * static_cast<int>(beams.path.size()));
}

TEST(BeamPath, FindsTheSameRegionsHoweverDenseTheStationsAre)
{
    const ChainScene<2> scene = ladderScene("S3");
    BeamOptions options = optionsFor(400.0);
    const BeamPath<2> coarse = pathThrough(scene, options);
    EXPECT_EQ(coarse.regions.size(), 3u) << "U-turns";
    for (const double spacing : {5.0, 2.5})
    {
        options.fan.spacing = spacing;
        const BeamPath<2> fine = pathThrough(scene, options);
        ASSERT_EQ(fine.regions.size(), coarse.regions.size()) << spacing;
        for (std::size_t i = 0; i < coarse.regions.size(); ++i)
        {
            EXPECT_EQ(fine.regions[i].side, coarse.regions[i].side);
            EXPECT_NEAR(fine.regions[i].first * spacing, coarse.regions[i].first * 10.0, 20.0) << spacing;
            EXPECT_NEAR(fine.regions[i].last * spacing, coarse.regions[i].last * 10.0, 20.0) << spacing;
        }
    }
}

TEST(BeamPath, ChangesSidesInTheMiddleOrEarlier)
{
    const ChainScene<2> scene = ladderScene("Z600");
    const auto switchPlace = [&](const BeamOptions &options)
    {
        const BeamPath<2> beams = pathThrough(scene, options);
        std::size_t widest = 1;
        for (std::size_t i = 1; i < beams.path.size(); ++i)
            if ((beams.path[i] - beams.path[i - 1]).norm() > (beams.path[widest] - beams.path[widest - 1]).norm())
                widest = i;
        return std::pair<double, std::vector<CriticalRegion>>(static_cast<double>(widest), beams.regions);
    };
    const auto [middle, regions] = switchPlace(optionsFor(500.0));  // further than the regions are apart
    EXPECT_NEAR(middle, 0.5 * (regions[0].last + regions[1].first), 1.0);
    const auto [early, same] = switchPlace(optionsFor(100.0));  // shorter
    EXPECT_NEAR(early, same[0].last + 0.5 * 100.0 / 10.0, 1.5);
}

TEST(BeamPath, WithoutACriticalRegionIsTheMiddlePath)
{
    const auto corridor = [](const Vector2d &point)
    {
        return 50.0 - std::abs(point.x());
    };
    const PointPath<2> middle{{0.0, 0.0}, {0.0, 400.0}};
    const BeamPath<2> beams = beamPath<2>(middle, corridor, optionsFor(100.0));
    EXPECT_EQ(beams.failure, BeamFailure::None);
    EXPECT_TRUE(beams.regions.empty());
    for (const Vector2d &point : beams.path)
        EXPECT_EQ(point.x(), 0.0);
}

TEST(BeamPath, ChoosesTheCoupleInWhosePlaneADuctBends)
{
    for (const bool upwards : {false, true})
    {
        // Along x, then along z or y; the first couple is the one of z.
        const Vector3d turned = upwards ? Vector3d::UnitZ() : Vector3d::UnitY();
        const PointPath<3> middle{{0.0, 0.0, 0.0}, {200.0, 0.0, 0.0}, 200.0 * Vector3d::UnitX() + 200.0 * turned};
        const auto duct = [&turned, upwards](const Vector3d &point)
        {
            const double across = upwards ? point.y() : point.z(), along = point.dot(turned);
            const double before = std::min(20.0 - std::abs(along), 220.0 - point.x());
            const double behind = std::min(20.0 - std::abs(point.x() - 200.0), along + 20.0);
            return std::min(20.0 - std::abs(across), std::max(before, behind));
        };
        BeamOptions options;
        options.fan.linkLength = 60.0;
        options.fan.radius = 2.0;
        options.fan.spacing = 4.0;
        options.window = 20.0;
        const BeamPath<3> beams = beamPath<3>(middle, duct, options);
        ASSERT_EQ(beams.failure, BeamFailure::None);
        ASSERT_EQ(beams.regions.size(), 1u);
        EXPECT_EQ(beams.regions[0].couple, upwards ? 0 : 1);
        EXPECT_NEAR(beams.path[20].dot(turned), -18.0, 0.1) << "on the outer wall before the bend";
    }
}

TEST(BeamPath, RepairsWhatCutsACorner)
{
    BeamOptions options = optionsFor(300.0);
    const ChainScene<2> scene = ladderScene("trap22");
    const auto distance = signedDistance<2>(scene.walls);
    const BeamPath<2> repaired = pathThrough(scene, options);
    ASSERT_EQ(repaired.failure, BeamFailure::None);
    EXPECT_GT(repaired.repairs, 0);
    options.repair = false;
    const BeamPath<2> raw = pathThrough(scene, options);
    EXPECT_EQ(raw.repairs, 0);
    const auto leastRoom = [&distance](const PointPath<2> &path)
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Vector2d &point : resampled<2>(path, 0.5))
            least = std::min(least, distance(point));
        return least;
    };
    EXPECT_LT(leastRoom(raw.path), 4.9);
    EXPECT_GE(leastRoom(repaired.path), 4.9);
}

TEST(BeamPath, NamesItsFailures)
{
    const auto wall = [](const Vector2d &point)
    {
        return point.y();
    };
    const BeamOptions options = optionsFor(50.0);
    EXPECT_EQ(beamPath<2>({}, wall, options).failure, BeamFailure::MiddleTooShort);
    EXPECT_EQ(beamPath<2>({{1.0, 9.0}, {1.0, 9.0}}, wall, options).failure, BeamFailure::MiddleTooShort);
    EXPECT_EQ(beamPath<2>({{0.0, 4.0}, {100.0, 40.0}}, wall, options).failure, BeamFailure::MiddleBlocked);
    EXPECT_EQ(toText(BeamFailure::MiddleBlocked), "middle_blocked");
    BeamOptions wrong = options;
    wrong.fan.couples = 5;
    EXPECT_THROW(beamPath<2>({{0.0, 9.0}, {9.0, 9.0}}, wall, wrong), std::invalid_argument);
    wrong = options;
    wrong.switchAt = 1.1;
    EXPECT_THROW(beamPath<2>({{0.0, 9.0}, {9.0, 9.0}}, wall, wrong), std::invalid_argument);
    for (const double window : {-1.0, std::numeric_limits<double>::infinity()})
    {
        wrong = options;
        wrong.window = window;
        EXPECT_THROW(beamPath<2>({{0.0, 9.0}, {9.0, 9.0}}, wall, wrong), std::invalid_argument);
    }
    wrong = options;
    wrong.fan.linkLength = 0.0;
    EXPECT_THROW(beamPath<2>({{0.0, 9.0}, {9.0, 9.0}}, wall, wrong), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
