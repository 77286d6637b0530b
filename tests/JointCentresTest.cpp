// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/JointCentres.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "HyperRedundantArm.h"
#include "SpatialRobots.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr unsigned int seed = 11;
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(JointCentres, OfTheStretchedArmLieOnItsAxis)
{
    std::vector<Vector3d> centres;
    VectorXd q = VectorXd::Zero(17);
    q[0] = 100.0;
    jointCentres(hyperRedundantArm(), q, centres);
    ASSERT_EQ(centres.size(), 9U);
    const std::vector<double> sums{0, 486, 972, 1458, 1944, 2430, 2636, 2842, 3126};
    for (std::size_t i = 0; i < centres.size(); ++i)
        EXPECT_LT((centres[i] - Vector3d(100.0 + sums[i], 0.0, 0.0)).norm(), 1e-9) << i;
}

TEST(JointCentres, YieldTheJointValuesOfAHundredThousandPoses)
{
    const SpatialArm arm = hyperRedundantArm();
    const ChainGeometry chain = chainGeometry(arm).value();
    std::mt19937 generator(seed);
    std::vector<Vector3d> centres;
    std::vector<Vector3d> again;
    VectorXd values;
    double worstPoint = 0.0;
    double worstAngle = 0.0;
    for (int pose = 0; pose < 100'000; ++pose)
    {
        const VectorXd q = randomPose(chain, generator);
        jointCentres(arm, q, centres);
        ASSERT_TRUE(valuesFromCentres(chain, centres, values));
        jointCentres(arm, values, again);
        for (std::size_t i = 0; i < centres.size(); ++i)
            worstPoint = std::max(worstPoint, (again[i] - centres[i]).norm());
        worstAngle = std::max(worstAngle, (values - q).tail(16).lpNorm<Eigen::Infinity>());
    }
    EXPECT_LT(worstPoint, 1e-10);  // millimetres; asked are 1e-9
    EXPECT_LT(worstAngle, 1e-12);
}

TEST(JointCentres, OfAChainOnASlantedSlideYieldItsValues)
{
    const SpatialArm arm = snake();
    const ChainGeometry chain = chainGeometry(arm).value();
    EXPECT_EQ(chain.axes.col(0), Vector3d(0.6, 0.8, 0.0));
    EXPECT_LT((chain.axes * chain.axes.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(chain.axes.determinant(), 1.0, 1e-12);
    std::mt19937 generator(seed);
    std::vector<Vector3d> centres;
    VectorXd values;
    for (int pose = 0; pose < 1000; ++pose)
    {
        const VectorXd q = randomPose(chain, generator);
        jointCentres(arm, q, centres);
        ASSERT_TRUE(valuesFromCentres(arm, centres, values));
        EXPECT_LT((values - q).norm(), 1e-12);
    }
}

TEST(JointCentres, OfJointsWithoutLimitsYieldBendsBeyondARightAngle)
{
    const SpatialArm arm =
        universalChain({0.0, 0.0, 0.0}, {1.0, 0.5, 0.7}, 0.0, std::make_pair(Vector3d::UnitX(), Interval{-1.0, 1.0}));
    const ChainGeometry chain = chainGeometry(arm).value();
    EXPECT_EQ(chain.maxAngle, infinity);
    VectorXd q(7);
    q << 0.3, 3.0, 1.5, -2.5, -1.4, 1.7, 0.0;
    std::vector<Vector3d> centres;
    VectorXd values;
    jointCentres(arm, q, centres);
    ASSERT_TRUE(valuesFromCentres(chain, centres, values));
    EXPECT_LT((values - q).norm(), 1e-13);
}

TEST(JointCentres, ChooseNoPitchForALinkAtRightAnglesToItsCircle)
{
    const SpatialArm arm =
        universalChain({0.0, 0.0, 0.0}, {2.0}, 0.0, std::make_pair(Vector3d::UnitX(), Interval{-1.0, 1.0}));
    VectorXd values;
    ASSERT_TRUE(valuesFromCentres(arm, {{0.5, 0.0, 0.0}, {0.5, -2.0, 0.0}}, values));
    EXPECT_EQ(values, Vector3d(0.5, 0.0, -std::acos(0.0)));
}

/// Trans(a, 0, 0) Rot(z, alpha) Rot(y, theta) Trans(0, 0, d): the paper's transform from one joint to the next.
Eigen::Isometry3d paperTransform(double a, double alpha, double theta, double d)
{
    return Eigen::Translation3d(a, 0.0, 0.0) * Eigen::AngleAxisd(alpha, Vector3d::UnitZ()) *
           Eigen::AngleAxisd(theta, Vector3d::UnitY()) * Eigen::Translation3d(0.0, 0.0, d);
}

TEST(PaperKinematics, HasThetaWhereEquation1PrintsAlphaTwice)
{
    const double a = 486.0, alpha = 0.4, theta = -0.3, d = 7.0;
    const double ca = std::cos(alpha), sa = std::sin(alpha), ct = std::cos(theta), st = std::sin(theta);
    Eigen::Matrix4d corrected;
    corrected << ca * ct, -sa, ca * st, a + d * ca * st,  //
        sa * ct, ca, sa * st, d * sa * st,                //
        -st, 0.0, ct, d * ct,                             //
        0.0, 0.0, 0.0, 1.0;
    EXPECT_LT((paperTransform(a, alpha, theta, d).matrix() - corrected).norm(), 1e-13);
    EXPECT_GT(std::abs(ca * ca - ca * ct), 0.01) << "as printed";
}

/// Eq. 11-15, yaw first, and the paper's forward kinematics of the answer.
TEST(PaperKinematics, HasTheSameCentresAndBendsAsOurs)
{
    const SpatialArm arm = hyperRedundantArm();
    const ChainGeometry chain = chainGeometry(arm).value();
    std::mt19937 generator(seed);
    std::vector<Vector3d> centres;
    for (int pose = 0; pose < 1000; ++pose)
    {
        const VectorXd q = randomPose(chain, generator);
        jointCentres(arm, q, centres);
        Eigen::Isometry3d frame(Eigen::Translation3d{centres[0]});
        double previous = 0.0;  // a_i, the length of the link before
        for (std::size_t i = 0; i < 8; ++i)
        {
            const Vector3d local = frame.linear().transpose() * (centres[i + 1] - centres[i]);
            const double theta = std::asin(-local.z() / chain.lengths[i]);
            const double alpha = std::asin(local.y() / (chain.lengths[i] * std::cos(theta)));
            frame = frame * paperTransform(previous, alpha, theta, 0.0);
            previous = chain.lengths[i];
            EXPECT_LT((frame * Vector3d(previous, 0.0, 0.0) - centres[i + 1]).norm(), 1e-9);
            EXPECT_NEAR(std::acos(std::cos(alpha) * std::cos(theta)), bendAngle(q[2 * i + 1], q[2 * i + 2]), 1e-7);
        }
    }
}

class BadCentres : public testing::Test
{
protected:
    BadCentres() { jointCentres(arm_, VectorXd::Constant(17, 0.1), centres_); }

    void expectRefused() const
    {
        VectorXd values = VectorXd::Constant(2, 7.0);
        EXPECT_FALSE(valuesFromCentres(arm_, centres_, values));
        EXPECT_EQ(values, VectorXd::Constant(2, 7.0));
    }

    SpatialArm arm_ = hyperRedundantArm();
    std::vector<Vector3d> centres_;
};

TEST_F(BadCentres, AreLinksOfAnotherLength)
{
    centres_[8] += 1e-5 * (centres_[8] - centres_[7]).normalized();  // 1e-9 of 3126 mm are 3e-6
    expectRefused();
}

TEST_F(BadCentres, BeginBesideTheSlide)
{
    for (Vector3d &centre : centres_)
        centre.y() += 1e-5;
    expectRefused();
}

TEST_F(BadCentres, AreTooFewOrTooMany)
{
    centres_.push_back(centres_.back());
    expectRefused();
    centres_.resize(8);
    expectRefused();
    centres_.clear();
    expectRefused();
}

TEST_F(BadCentres, AreNoNumbers)
{
    for (const double value : {infinity, std::numeric_limits<double>::quiet_NaN()})
        for (std::size_t i = 0; i < centres_.size(); ++i)
        {
            const double before = centres_[i].x();
            centres_[i].x() = value;
            expectRefused();
            centres_[i].x() = before;
        }
}

TEST(ChainGeometry, IsThatOfTheArm)
{
    const ChainGeometry chain = chainGeometry(hyperRedundantArm()).value();
    EXPECT_EQ(chain.origin, Vector3d::Zero());
    EXPECT_EQ(chain.axes, Eigen::Matrix3d::Identity());
    EXPECT_EQ(chain.lengths, hyperRedundantLengths());
    EXPECT_EQ(chain.radius, 61.5);
    EXPECT_EQ(chain.maxAngle, hyperRedundantBend);
    EXPECT_EQ(chain.slide.lower, -1000.0);
    EXPECT_EQ(chain.slide.upper, 1000.0);
}

TEST(ChainGeometry, IsThatOfNoOtherArm)
{
    EXPECT_FALSE(chainGeometry(sixAxisArm()));
    EXPECT_FALSE(chainGeometry(gantryHand()));
    EXPECT_FALSE(chainGeometry(universalChain({0.0, 0.0, 0.0}, {1.0, 1.0}, 0.1))) << "it does not slide";
    VectorXd values;
    EXPECT_THROW(valuesFromCentres(sixAxisArm(), {}, values), std::invalid_argument);
}

/// The chain with one thing changed.
template <typename Change>
bool isChainAfter(const Change &change)
{
    const SpatialArm arm = snake();
    std::vector<SpatialJoint> joints = arm.joints();
    std::vector<SpatialLink> links = arm.links();
    std::vector<UniversalLimit> limits = arm.universalLimits();
    change(joints, links, limits);
    return chainGeometry(SpatialArm(joints, links, limits)).has_value();
}

TEST(ChainGeometry, NeedsEveryPartOfAChain)
{
    EXPECT_TRUE(isChainAfter([](auto &, auto &, auto &) {}));
    EXPECT_FALSE(isChainAfter([](auto &joints, auto &, auto &) { joints[3].axis = Vector3d::UnitZ(); }));
    EXPECT_FALSE(isChainAfter([](auto &joints, auto &, auto &) { joints[4].limits = Interval{-0.1, 0.1}; }));
    EXPECT_FALSE(isChainAfter([](auto &joints, auto &, auto &) { joints[5].offset.translation().x() += 0.1; }));
    EXPECT_FALSE(isChainAfter([](auto &joints, auto &, auto &)
                              { joints[1].offset.rotate(Eigen::AngleAxisd(0.1, Vector3d::UnitX())); }));
    EXPECT_FALSE(isChainAfter([](auto &, auto &links, auto &) { links[2].radius *= 2.0; }));
    EXPECT_FALSE(isChainAfter([](auto &, auto &links, auto &) { links[3].to.y() = 0.01; }));
    EXPECT_FALSE(isChainAfter([](auto &, auto &links, auto &) { links.pop_back(); }));
    EXPECT_FALSE(isChainAfter([](auto &, auto &, auto &limits) { limits.pop_back(); }));
    EXPECT_FALSE(isChainAfter([](auto &, auto &, auto &limits) { limits[1].maxAngle = 0.7; }));
}

TEST(BendAngle, IsTheAngleBetweenTwoLinks)
{
    const SpatialArm arm = snake();
    std::mt19937 generator(seed);
    std::vector<Vector3d> centres;
    for (int pose = 0; pose < 1000; ++pose)
    {
        const VectorXd q = randomVector(9, 1.5, generator);
        jointCentres(arm, q, centres);
        for (int i = 1; i < 4; ++i)
        {
            const Vector3d before = centres[i] - centres[i - 1];
            const Vector3d after = centres[i + 1] - centres[i];
            const double angle = std::atan2(before.cross(after).norm(), before.dot(after));
            EXPECT_NEAR(bendAngle(q[2 * i + 1], q[2 * i + 2]), angle, 1e-12);
        }
    }
}

TEST(BendAngle, KeepsTheDigitsOfSmallAngles)
{
    EXPECT_EQ(bendAngle(0.0, 0.0), 0.0);
    EXPECT_NEAR(bendAngle(3e-9, 4e-9), 5e-9, 1e-22);
    EXPECT_NEAR(bendAngle(std::acos(-1.0), 0.0), std::acos(-1.0), 1e-12);
}
}  // namespace
}  // namespace narrows
