// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/ChordRelaxation.h"

#include <gtest/gtest.h>

#include "LeaderScenes.h"

namespace narrows
{
namespace
{
template <int D>
RelaxedPath<D> relax(const LeaderScene<D> &scene, const PointPath<D> &middle, const ChainSpec &spec, double width)
{
    return relaxChords<D>(middle, scene.entrance, ChordObstacles<D>(scene.obstacles), spec, relaxationOptions(width));
}

PointPath<2> middleOfZ300()
{
    return windowed<2>(resampled<2>({{100, 50}, {100, 1000}, {400, 1000}, {400, 1950}}, 10.0), 5, 3);
}

PointPath<3> middleOfPipe()
{
    return windowed<3>(resampled<3>(bentPipeLine(), 5.0), 4, 3);
}

TEST(ChordRelaxation, SBendAt450)
{
    const LeaderScene<2> scene = bendZ(300.0);
    const ChainSpec spec{20, 450.0, 5.0};
    const LeaderPath<2> middle(middleOfZ300(), scene.entrance);
    EXPECT_EQ(certifyChain<2>(middle, ChordObstacles<2>(scene.obstacles), spec).failure, ChainFailure::ChordClearance);
    // As the paper's path does, from wall to wall at once: a joint jumps or a link hits.
    const LeaderPath<2> switching(
        {{100, 50}, {5, 300}, {5, 1095}, {250, 1095}, {250, 905}, {495, 905}, {495, 1700}, {400, 1950}},
        scene.entrance);
    EXPECT_FALSE(certifyChain<2>(switching, ChordObstacles<2>(scene.obstacles), spec));
    EXPECT_TRUE(relax<2>(scene, middleOfZ300(), spec, 200.0).certificate);
}

TEST(ChordRelaxation, PipeWithThirteenBends)
{
    const LeaderScene<3> scene = pipeA();
    const ChainSpec spec{35, 84.0, 2.0, 1.55, true};
    const LeaderPath<3> middle(middleOfPipe(), scene.entrance);
    EXPECT_EQ(certifyChain<3>(middle, ChordObstacles<3>(scene.obstacles), spec).failure, ChainFailure::ChordClearance);
    const RelaxedPath<3> relaxed = relax<3>(scene, middleOfPipe(), spec, 40.0);
    EXPECT_TRUE(relaxed.certificate) << toText(relaxed.certificate.failure);
    EXPECT_GE(relaxed.certificate.clearance, 2.0);
    EXPECT_LE(relaxed.certificate.largestAngle, 1.55);
    EXPECT_GT(relaxed.certificate.amplification, 2.0);
    EXPECT_EQ(relaxed.nodes.front(), scene.start);
    EXPECT_EQ(relaxed.nodes.back(), scene.goal);
}

TEST(ChordRelaxation, KeepsJointsWithinTheirLimit)
{
    const LeaderScene<3> scene = pipeA();
    ChainSpec spec{60, 60.0, 2.0};
    const ChainCertificate free = relax<3>(scene, middleOfPipe(), spec, 40.0).certificate;
    ASSERT_TRUE(free);
    spec.maxAngle = free.largestAngle - 0.08;
    const RelaxedPath<3> limited = relax<3>(scene, middleOfPipe(), spec, 40.0);
    EXPECT_TRUE(limited.certificate) << toText(limited.certificate.failure) << " of " << free.largestAngle;
    EXPECT_LE(limited.certificate.largestAngle, spec.maxAngle);
}

TEST(ChordRelaxation, PushesLinksThatMeetApart)
{
    // A loop that comes back across its own beginning, 0.5 above it, with links 4 thick; and one that comes back across
    // the entrance line.
    const ChordObstacles<3> nothing({});
    const Eigen::Vector3d entrance = Eigen::Vector3d::UnitX();
    for (const double crossing : {40.0, -30.0})
    {
        const PointPath<3> loop = windowed<3>(
            resampled<3>({{0, 0, 0}, {100, 0, 0}, {100, 60, 0}, {crossing, 60, 0}, {crossing, -60, 1}}, 2.0), 5, 3);
        ChainSpec spec{40, 12.0, 2.0, 1.5, false};
        const RelaxedPath<3> without = relaxChords<3>(loop, entrance, nothing, spec, relaxationOptions(20.0));
        ASSERT_TRUE(without.certificate) << toText(without.certificate.failure);
        spec.selfCollision = true;
        EXPECT_EQ(certifyChain<3>(LeaderPath<3>(without.nodes, entrance), nothing, spec).failure,
                  ChainFailure::SelfCollision);
        const RelaxedPath<3> pushed = relaxChords<3>(loop, entrance, nothing, spec, relaxationOptions(20.0));
        EXPECT_TRUE(pushed.certificate) << crossing << " " << toText(pushed.certificate.failure);
        EXPECT_EQ(pushed.nodes.back(), loop.back());
    }
}

TEST(ChordRelaxation, CannotPartLinksThatCrossInThePlane)
{
    const PointPath<2> loop = resampled<2>({{0, 0}, {100, 0}, {100, 60}, {40, 60}, {40, -60}}, 2.0);
    const ChainSpec spec{40, 12.0, 2.0, 1.5, true};
    const RelaxedPath<2> pushed =
        relaxChords<2>(loop, {1.0, 0.0}, ChordObstacles<2>({}), spec, relaxationOptions(20.0));
    EXPECT_EQ(pushed.certificate.failure, ChainFailure::SelfCollision);
}

TEST(ChordRelaxation, EndsNearTheGoalIfThatIsAllowed)
{
    // The goal is 4 from a wall, the links are 5 thick.
    const ChordObstacles<2> wall({solidBox("wall", Eigen::Vector2d(100.0, 0.0), Eigen::Vector2d(120.0, 1000.0))});
    const ChainSpec spec{10, 60.0, 5.0};
    const PointPath<2> path = resampled<2>({{50.0, 0.0}, {50.0, 200.0}, {96.0, 400.0}}, 10.0);
    RelaxationOptions options = relaxationOptions(100.0);
    EXPECT_EQ(relaxChords<2>(path, {0.0, 1.0}, wall, spec, options).certificate.failure, ChainFailure::ChordClearance);
    options.goalRoom = 3.0;
    const RelaxedPath<2> moved = relaxChords<2>(path, {0.0, 1.0}, wall, spec, options);
    EXPECT_TRUE(moved.certificate) << toText(moved.certificate.failure);
    EXPECT_LE((moved.nodes.back() - path.back()).norm(), 3.0 + 1e-12);
    EXPECT_LE(moved.nodes.back().x(), 95.0);
    EXPECT_EQ(moved.nodes.front(), path.front());
    options.goalRoom = -1.0;
    EXPECT_THROW(relaxChords<2>(path, {0.0, 1.0}, wall, spec, options), std::invalid_argument);
}

TEST(ChordRelaxation, SaysWhyNot)
{
    // Longer than a right-angle bend lets through by any path.
    const RelaxedPath<2> relaxed =
        relax<2>(cornerL(), resampled<2>({{100, 50}, {100, 1000}, {1050, 1000}}, 10.0), {20, 545.0, 5.0}, 200.0);
    EXPECT_EQ(relaxed.certificate.failure, ChainFailure::ChordClearance);
    EXPECT_EQ(relaxed.rounds, 400);
}

TEST(ChordRelaxation, SameAnswerTwiceAndStops)
{
    const LeaderScene<2> scene = bendZ(300.0);
    const ChainSpec spec{20, 420.0, 5.0};
    const RelaxedPath<2> first = relax<2>(scene, middleOfZ300(), spec, 200.0);
    const RelaxedPath<2> second = relax<2>(scene, middleOfZ300(), spec, 200.0);
    EXPECT_EQ(first.nodes, second.nodes);
    EXPECT_EQ(first.chords, second.chords);
    const RelaxedPath<2> stopped = relaxChords<2>(middleOfZ300(), scene.entrance, ChordObstacles<2>(scene.obstacles),
                                                  spec, relaxationOptions(200.0), [] { return true; });
    EXPECT_EQ(stopped.rounds, 0);
    EXPECT_FALSE(stopped.certificate);
}

TEST(ChordRelaxation, RefusesOptions)
{
    RelaxationOptions options = relaxationOptions(200.0);
    options.spacing = 0.0;
    EXPECT_THROW(
        relaxChords<2>(middleOfZ300(), Eigen::Vector2d::UnitY(), ChordObstacles<2>({}), {20, 420.0, 5.0}, options),
        std::invalid_argument);
}
}  // namespace
}  // namespace narrows
