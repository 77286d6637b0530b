// SPDX-License-Identifier: BSD-3-Clause
#include "validity/TrajectoryCertificate.h"

#include <random>

#include <gtest/gtest.h>

#include "kernel/trajectory/PolynomialTrajectory.h"
#include "spaces/PlanarArmStateSpace.h"
#include "spaces/SpatialArmStateSpace.h"
#include "validity/ArmChecker.h"
#include "validity/TrajectoryVerdict.h"

namespace narrows
{
namespace
{
/// One link of length 1 from the origin; a disc that it touches from the angle `edge` on: its center is at 90 degrees,
/// 1 away.
struct OneLink
{
    explicit OneLink(std::optional<Interval> limits = std::nullopt, double radius = 0.2, int links = 1)
    {
        std::vector<PlanarLink> chain;
        for (int i = 0; i < links; ++i)
            chain.push_back({1.0 / links, i - 1});
        task.limits.convention = AngleConvention::Relative;
        task.limits.angles.assign(static_cast<std::size_t>(links), limits);
        model.emplace(PlanarModel{PlanarArm({0.0, 0.0}, chain), {{"disc", Circle{{0.0, 1.0}, radius}}}});
        space.emplace(model->arm, AngleConvention::Relative, FreeJoints::Unbounded, task.limits);
        checker = makeArmChecker("analytic", *model);
    }

    CertificateFinding check(const JointTrajectory &motion, const TrajectoryCertificateOptions &options = {}) const
    {
        return TrajectoryCertificate(
                   *space, [this](ConfigurationRef q) { return checker->clearance(q); }, false, options)
            .check(motion);
    }

    TrajectoryVerdict verify(const JointTrajectory &motion)
    {
        JointTrajectory::States state;
        const JointCoordinates coordinates(*space);
        motion.at(0.0, state);
        task.start = coordinates.toConfiguration() * state.col(0);
        motion.at(motion.duration(), state);
        task.goal = Eigen::VectorXd(coordinates.toConfiguration() * state.col(0));
        return verifyTrajectory(*model, task, *space, motion);
    }

    std::optional<PlanarModel> model;
    PlanarTask task;
    std::optional<PlanarArmStateSpace> space;
    std::unique_ptr<const ArmChecker> checker;
};

/// base + height (4 t (1 - t))^2: to the height and back, at rest at both ends, in time 1.
PolynomialTrajectory excursion(double base, double height)
{
    Eigen::RowVectorXd coefficients(5);
    coefficients << base, 0.0, 16.0 * height, -32.0 * height, 16.0 * height;
    return PolynomialTrajectory({{1.0, coefficients}});
}

// The link touches the disc where the distance of the disc's center from the link is its radius, sin(90 deg - q) = 0.2.
const double edge = std::acos(0.2);

TEST(TrajectoryCertificate, DecidesExcursionsByTheirPeaks)
{
    OneLink scene;
    for (const double nearness : {1e-2, 1e-4, 1e-6})
    {
        const CertificateFinding free = scene.check(excursion(0.1, edge - 0.1 - nearness));
        EXPECT_EQ(free.status, CertificateStatus::Free) << nearness;
        const CertificateFinding collision = scene.check(excursion(0.1, edge - 0.1 + nearness));
        EXPECT_EQ(collision.status, CertificateStatus::Collision) << nearness;
        // It is in collision while (4 t (1 - t))^2 exceeds 1 - nearness / height.
        const double height = edge - 0.1 + nearness;
        const double entry = 0.5 - 0.5 * std::sqrt(1.0 - std::sqrt(1.0 - nearness / height));
        EXPECT_NEAR(collision.time, 0.5, 0.5 - entry);
    }
    EXPECT_LT(scene.check(excursion(0.1, edge - 0.1 - 1e-6)).placements, 2000u);
}

TEST(TrajectoryCertificate, FindsWhatLiesBetweenSamples)
{
    // Free at the ends, at 1000 samples a second, and nowhere near them in between: a needle of 1/4 ms.
    OneLink scene;
    const double before = 0.49925, width = 0.0005;
    std::vector<PolynomialTrajectory::Piece> pieces{{before, Eigen::RowVectorXd::Constant(1, 0.1)}};
    PolynomialTrajectory needle = excursion(0.1, edge).stretched(width);
    pieces.push_back(needle.pieces().front());
    pieces.push_back({1.0 - before - width, Eigen::RowVectorXd::Constant(1, 0.1)});
    const PolynomialTrajectory motion(pieces);
    JointTrajectory::States state;
    for (int i = 0; i <= 1000; ++i)
    {
        motion.at(1e-3 * i, state);
        ASSERT_TRUE(scene.checker->isFree(state.col(0))) << i;
    }
    const CertificateFinding finding = scene.check(motion);
    EXPECT_EQ(finding.status, CertificateStatus::Collision);
    EXPECT_NEAR(finding.time, before + 0.5 * width, 0.5 * width);
    EXPECT_FALSE(scene.verify(motion).accepted);
    EXPECT_EQ(scene.verify(motion).chords.reason, "collision");
}

TEST(TrajectoryCertificate, KeepsAMargin)
{
    OneLink scene;
    // At angle q the distance to the disc is cos q - 0.2.
    for (const double margin : {0.0, 0.05, 0.3})
    {
        const double height = std::acos(0.2 + margin) - 0.1;
        EXPECT_EQ(scene.check(excursion(0.1, height - 1e-4), {margin}).status, CertificateStatus::Free);
        EXPECT_EQ(scene.check(excursion(0.1, height + 1e-4), {margin}).status, CertificateStatus::Collision);
    }
}

TEST(TrajectoryCertificate, KeepsLimitsAllAlong)
{
    OneLink scene(Interval{-1.0, 1.0});
    EXPECT_EQ(scene.check(excursion(-1.0, 2.0)).status, CertificateStatus::Free);  // from one limit to the other
    EXPECT_EQ(scene.check(excursion(-1.0, 2.0 + 1e-7)).status, CertificateStatus::Limit);
    EXPECT_NEAR(scene.check(excursion(-1.0, 2.0 + 1e-7)).time, 0.5, 1e-3);
    EXPECT_EQ(scene.check(excursion(1.0, -2.0 - 1e-7)).status, CertificateStatus::Limit);
    EXPECT_TRUE(scene.verify(excursion(-1.0, 2.0)).accepted);
    EXPECT_EQ(scene.verify(excursion(-1.0, 2.0 + 1e-7)).chords.reason, "limits");
}

TEST(TrajectoryCertificate, SaysWhenItIsUndecided)
{
    OneLink scene;
    const CertificateFinding finding = scene.check(excursion(0.1, edge - 0.1 - 1e-6), {0.0, 20});
    EXPECT_EQ(finding.status, CertificateStatus::Undecided);
    EXPECT_EQ(finding.placements, 20u);
    EXPECT_GT(finding.time, 0.0);
}

TEST(TrajectoryCertificate, RefusesWhatDoesNotFit)
{
    OneLink scene;
    const PolynomialTrajectory two({{1.0, Eigen::MatrixXd::Zero(2, 1)}});
    EXPECT_THROW(scene.check(two), std::invalid_argument);
    EXPECT_THROW(scene.check(excursion(0.0, 0.1), {-1.0}), std::invalid_argument);
    EXPECT_THROW(scene.check(excursion(0.0, 0.1), {0.0, 0}), std::invalid_argument);
    EXPECT_THROW(verifyTrajectory(*scene.model, scene.task, *scene.space, two), std::invalid_argument);
}

TEST(TrajectoryCertificate, FullTurnsCount)
{
    // Without limits the joint goes on beyond pi, through the disc from the other side.
    OneLink scene;
    EXPECT_EQ(scene.check(excursion(0.1, edge - 0.1 - 0.01 - 6.283185307179586)).status, CertificateStatus::Collision);
    EXPECT_EQ(scene.check(excursion(0.1, -4.2)).status, CertificateStatus::Free);
}

/// Random motions of seven relative joints: what the certificate says, the verifier says too, and so do samples.
TEST(TrajectoryCertificate, AgreesWithVerifierAndSamples)
{
    OneLink scene(Interval{-2.5, 2.5}, 0.35, 7);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> angle(-0.6, 0.6);
    int free = 0, collisions = 0;
    for (int trial = 0; trial < 200; ++trial)
    {
        Eigen::MatrixXd coefficients = Eigen::MatrixXd::NullaryExpr(7, 4, [&] { return angle(random); });
        coefficients(0, 0) += 0.4;
        const PolynomialTrajectory motion({{1.0, coefficients}});
        const CertificateFinding finding = scene.check(motion);
        const TrajectoryVerdict verdict = scene.verify(motion);
        ASSERT_NE(finding.status, CertificateStatus::Undecided);
        EXPECT_EQ(verdict.accepted, finding.status == CertificateStatus::Free) << trial << verdict.chords.reason;
        const bool isFree = finding.status == CertificateStatus::Free;
        ++(isFree ? free : collisions);
        double least = std::numeric_limits<double>::infinity();
        JointTrajectory::States state;
        const JointCoordinates coordinates(*scene.space);
        for (int i = 0; i <= 2000; ++i)
        {
            motion.at(i / 2000.0, state);
            least = std::min(least, scene.checker->clearance(coordinates.toConfiguration() * state.col(0)));
        }
        if (isFree)
        {
            EXPECT_GT(least, 0.0) << trial;
            EXPECT_LE(verdict.clearance, least) << trial;
        }
        else if (finding.status == CertificateStatus::Collision)
        {
            motion.at(finding.time, state);
            EXPECT_LE(scene.checker->clearance(coordinates.toConfiguration() * state.col(0)), 1e-9) << trial;
        }
    }
    EXPECT_GT(free, 5);
    EXPECT_GT(collisions, 5);
}

TEST(ArmTravel, BoundsRandomMovesInThePlaneAndInSpace)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(-2.0, 2.0), change(0.0, 0.4);
    const SpatialArm gantry(
        {{SpatialJoint::Kind::Prismatic, -1, Eigen::Isometry3d::Identity(), Eigen::Vector3d::UnitX(),
          Interval{-5.0, 5.0}},
         {SpatialJoint::Kind::Prismatic, 0, Eigen::Isometry3d::Identity(), Eigen::Vector3d(-0.8, 0.6, 0.0),
          Interval{-5.0, 5.0}},
         {SpatialJoint::Kind::Revolute, 1, Eigen::Isometry3d::Identity(), Eigen::Vector3d::UnitZ(), std::nullopt}},
        {{2, Eigen::Vector3d::Zero(), Eigen::Vector3d(1.0, 0.0, 0.5), 0.1}});
    const SpatialArmStateSpace space(gantry, FreeJoints::Unbounded);
    const ArmTravel travel(space, false);
    EXPECT_EQ(ArmTravel(space, true)(Eigen::Vector3d(1.0, 0.0, 0.0)), 2.0);
    double tightest = 0.0;
    for (int trial = 0; trial < 2000; ++trial)
    {
        const Eigen::Vector3d q(angle(random), angle(random), angle(random));
        const Eigen::Vector3d most(change(random), change(random), change(random));
        Eigen::Vector3d moved = q;
        for (int i = 0; i < 3; ++i)
            moved[i] += random() % 2 == 0 ? most[i] : -most[i];
        SpatialArm::Placement before, after;
        gantry.place(q, before);
        gantry.place(moved, after);
        for (int end = 0; end < 2; ++end)
        {
            const double way = (after.points[end] - before.points[end]).norm();
            EXPECT_LE(way, travel(most) * (1.0 + 1e-12));
            tightest = std::max(tightest, way / travel(most));
        }
    }
    EXPECT_GT(tightest, 0.8);
}
}  // namespace
}  // namespace narrows
