// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/CableDrive.h"

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "HyperRedundantArm.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr unsigned int seed = 12;
constexpr double pi = 3.14159265358979323846;
constexpr double d = 30.0;
constexpr double r = 55.0;

/// The paper's name of a cable: link from 1, then a, b or c.
int cable(int link, char letter)
{
    return 3 * (link - 1) + (letter - 'a');
}

CableDrive drive(UniversalOrder order = UniversalOrder::PitchFirst)
{
    return CableDrive(hyperRedundantLengths(), d, r, order);
}

TEST(CableDrive, HasTheHolesThatThePaperNames)
{
    const CableDrive cables = drive();
    EXPECT_NEAR(cables.holeAngle(cable(5, 'b')), 0.0, 1e-15);
    EXPECT_NEAR(cables.holeAngle(cable(6, 'b')), 15.0 * pi / 180.0, 1e-15);
    EXPECT_NEAR(cables.holeAngle(cable(1, 'a')), pi, 1e-15);
    EXPECT_NEAR(cables.holeAngle(cable(4, 'b')), 345.0 * pi / 180.0, 1e-15);
}

TEST(CableDrive, SharesTheCircleAmongAllCables)
{
    for (int links = 1; links <= 9; ++links)
    {
        const CableDrive cables(std::vector<double>(links, 100.0));
        std::set<long> steps;
        for (int i = 0; i < cables.cableCount(); ++i)
        {
            const double step = cables.holeAngle(i) / (2.0 * pi) * cables.cableCount();
            EXPECT_NEAR(step, std::round(step), 1e-12);
            steps.insert(std::lround(step));
            const int next = 3 * (i / 3) + (i + 1) % 3;
            const double third = cables.holeAngle(next) - cables.holeAngle(i);
            EXPECT_NEAR(std::cos(third - 2.0 * pi / 3.0), 1.0, 1e-14) << i;
        }
        EXPECT_EQ(static_cast<int>(steps.size()), 3 * links);
        EXPECT_EQ(*steps.begin(), 0);
        EXPECT_EQ(*steps.rbegin(), 3 * links - 1);
    }
}

TEST(CableDrive, LeadsAsManyCablesThroughAJointAsThePaper)
{
    for (int i = 1; i <= 8; ++i)
        EXPECT_EQ(drive().cablesThrough(i - 1), 27 - 3 * i);
}

/// Eq. 20 as it is printed.
double printedLength(double theta, double alpha, double phi)
{
    const double x = d * std::cos(alpha) * std::cos(theta) - r * std::sin(alpha) * std::sin(phi) +
                     r * std::cos(alpha) * std::sin(theta) * std::cos(phi) + d;
    const double y = d * std::sin(alpha) * std::cos(theta) + r * std::cos(alpha) * std::sin(phi) +
                     r * std::sin(alpha) * std::sin(theta) * std::cos(phi) - r * std::sin(phi);
    const double z = -d * std::sin(theta) + r * std::cos(theta) * std::cos(phi) - r * std::cos(phi);
    return std::sqrt(x * x + y * y + z * z);
}

TEST(CableDrive, FollowsThePrintedEquation)
{
    const CableDrive cables = drive(UniversalOrder::YawFirst);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> angle(-0.7, 0.7);
    for (int i = 0; i < 1000; ++i)
    {
        const UniversalAngles angles{angle(generator), angle(generator)};
        for (int k = 0; k < 24; ++k)
            EXPECT_NEAR(cables.lengthAtJoint(k, angles), printedLength(angles.pitch, angles.yaw, cables.holeAngle(k)),
                        1e-12);
    }
}

/// A cable from hole to hole where the arm's own forward kinematics puts them.
double directLength(const SpatialArm &arm, const SpatialArm::Placement &placement, const CableDrive &cables, int index)
{
    const double phi = cables.holeAngle(index);
    const Vector3d hole(0.0, r * std::sin(phi), r * std::cos(phi));
    double length = 0.0;
    for (int i = 0; i <= index / 3; ++i)
    {
        const Vector3d centre = placement.points[2 * i];
        const Eigen::Matrix3d before = placement.frames[2 * i].linear();  // the slide's, then the link's before
        const Eigen::Matrix3d behind = placement.frames[2 * i + 2].linear();
        const Vector3d from = centre + before * (hole - d * Vector3d::UnitX());
        const Vector3d to = centre + behind * (hole + d * Vector3d::UnitX());
        length += (to - from).norm() + (arm.links()[i].to - arm.links()[i].from).norm() - 2.0 * d;
    }
    return length;
}

TEST(CableDrive, TotalsAreTheDistancesBetweenTheHolesInSpace)
{
    const SpatialArm arm = hyperRedundantArm();
    const ChainGeometry chain = chainGeometry(arm).value();
    const CableDrive cables = drive();
    std::mt19937 generator(seed);
    SpatialArm::Placement placement;
    VectorXd lengths;
    for (int pose = 0; pose < 2000; ++pose)
    {
        const VectorXd q = randomPose(chain, generator);
        arm.place(q, placement);
        cables.totalLengths(q.tail(16), lengths);
        ASSERT_EQ(lengths.size(), 24);
        for (int k = 0; k < 24; ++k)
            EXPECT_NEAR(lengths[k], directLength(arm, placement, cables, k), 1e-10);  // asked are 1e-9
    }
}

TEST(CableDrive, StraightCablesAreAsLongAsTheLinks)
{
    VectorXd lengths;
    drive().totalLengths(VectorXd::Zero(16), lengths);
    const std::vector<double> sums{486, 972, 1458, 1944, 2430, 2636, 2842, 3126};
    for (int k = 0; k < 24; ++k)
        EXPECT_NEAR(lengths[k], sums[k / 3], 1e-11);
}

class CableInverse : public testing::TestWithParam<UniversalOrder>
{
};

TEST_P(CableInverse, FindsAllAnglesShortOfTheLargestBend)
{
    for (const double faceDistance : {10.0, d, 60.0})
    {
        const CableDrive cables(hyperRedundantLengths(), faceDistance, r, GetParam());
        std::mt19937 generator(seed);
        const double most = std::min(cables.largestBend(), 1.5);
        std::uniform_real_distribution<double> angle(-most, most);
        int bends = 0;
        for (int i = 0; i < 10'000; ++i)
        {
            const UniversalAngles angles{angle(generator), angle(generator)};
            if (bendAngle(angles.pitch, angles.yaw) > 0.99 * cables.largestBend())
                continue;
            ++bends;
            const int joint = i % 8;
            Vector3d lengths;
            for (int k = 0; k < 3; ++k)
                lengths[k] = cables.lengthAtJoint(3 * joint + k, angles);
            const JointSolution found = cables.anglesAtJoint(joint, lengths);
            ASSERT_EQ(found.status, CableStatus::Solved) << angles.pitch << ' ' << angles.yaw;
            EXPECT_NEAR(found.angles.pitch, angles.pitch, 1e-12);
            EXPECT_NEAR(found.angles.yaw, angles.yaw, 1e-12);
            EXPECT_LT(found.residual, 1e-12);
        }
        EXPECT_GT(bends, 5000);
    }
    EXPECT_NEAR(drive().largestBend() * 180.0 / pi, 57.22, 0.01);
}

TEST_P(CableInverse, CountsAnglesWithoutTurnsThatItTook)
{
    const CableDrive cables(hyperRedundantLengths(), 60.0, r, GetParam());
    const UniversalAngles angles{1.5558912939469889, -1.6316819901444011};
    for (int joint = 0; joint < 8; ++joint)
    {
        Vector3d lengths;
        for (int k = 0; k < 3; ++k)
            lengths[k] = cables.lengthAtJoint(3 * joint + k, angles);
        const JointSolution found = cables.anglesAtJoint(joint, lengths);
        EXPECT_LE(std::abs(found.angles.pitch), pi);
        EXPECT_LE(std::abs(found.angles.yaw), pi);
    }
}

TEST_P(CableInverse, FindsAllAnglesFromTheTotals)
{
    const ChainGeometry chain = chainGeometry(hyperRedundantArm()).value();
    const CableDrive cables = drive(GetParam());
    std::mt19937 generator(seed);
    VectorXd lengths;
    for (int pose = 0; pose < 1000; ++pose)
    {
        const VectorXd angles = randomPose(chain, generator).tail(16);
        cables.totalLengths(angles, lengths);
        const DriveSolution found = cables.anglesFromTotals(lengths);
        ASSERT_EQ(found.status, CableStatus::Solved) << found.joint;
        EXPECT_EQ(found.joint, -1);
        EXPECT_LT((found.angles - angles).lpNorm<Eigen::Infinity>(), 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(Orders, CableInverse, testing::Values(UniversalOrder::PitchFirst, UniversalOrder::YawFirst),
                         [](const auto &order)
                         { return order.param == UniversalOrder::PitchFirst ? "PitchFirst" : "YawFirst"; });

TEST(CableFailure, OneCableTooLongIsInconsistent)
{
    const CableDrive cables = drive();
    VectorXd angles = VectorXd::Constant(16, 0.1);
    VectorXd lengths;
    cables.totalLengths(angles, lengths);
    lengths[cable(4, 'b')] += 0.5;
    const DriveSolution found = cables.anglesFromTotals(lengths);
    EXPECT_EQ(found.status, CableStatus::Inconsistent);
    EXPECT_EQ(found.joint, 3);
    EXPECT_LT((found.angles.head(6) - angles.head(6)).norm(), 1e-12);
    EXPECT_EQ(found.angles.tail(10), VectorXd::Zero(10));
    EXPECT_EQ(cables.anglesFromTotals(lengths, 1.0).status, CableStatus::Solved) << "measured lengths are not exact";
}

TEST(CableFailure, ABendThatTheFacesForbidIsNamed)
{
    const CableDrive cables = drive();
    for (const UniversalAngles &angles : {UniversalAngles{1.1, 0.0}, UniversalAngles{0.0, -1.2}})
    {
        Vector3d lengths;
        for (int k = 0; k < 3; ++k)
            lengths[k] = cables.lengthAtJoint(k, angles);
        EXPECT_EQ(cables.anglesAtJoint(0, lengths).status, CableStatus::FacesMeet) << angles.pitch;
    }
}

TEST(CableFailure, WhatIsNoNumberIsNamed)
{
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(drive().anglesAtJoint(2, {60.0, value, 60.0}).status, CableStatus::NotFinite);
}

TEST(CableFailure, AbsurdLengthsEndInAName)
{
    const CableDrive cables = drive();
    for (const Vector3d &lengths : {Vector3d(0.0, 0.0, 0.0), Vector3d(-50.0, 60.0, 60.0), Vector3d(1e6, 0.0, 1e6)})
    {
        const JointSolution found = cables.anglesAtJoint(0, lengths);
        EXPECT_EQ(found.status, CableStatus::Inconsistent) << toString(found.status) << ' ' << lengths.transpose();
        EXPECT_TRUE(std::isfinite(found.angles.pitch) && std::isfinite(found.angles.yaw));
    }
}

TEST(CableFailure, BadDimensionsAreRefused)
{
    EXPECT_THROW(CableDrive({}), std::invalid_argument);
    EXPECT_THROW(CableDrive({100.0, -1.0}), std::invalid_argument);
    EXPECT_THROW(CableDrive({100.0}, 0.0), std::invalid_argument);
    EXPECT_THROW(CableDrive({100.0}, 30.0, std::nan("")), std::invalid_argument);
    EXPECT_THROW(drive().anglesFromTotals(VectorXd::Zero(23)), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
