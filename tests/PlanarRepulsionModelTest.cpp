// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PlanarRepulsionModel.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "kernel/LinkPair.h"
#include "kernel/PointRepulsion.h"

namespace narrows
{
namespace
{
using Eigen::VectorXd;

/// A gripper on a slide among all kinds of obstacles.
std::shared_ptr<PlanarModel> scene()
{
    return std::make_shared<PlanarModel>(
        PlanarModel{PlanarArm({0.2, -0.1}, {{1.0, -1}, {0.8, 0}, {0.5, 1}, {0.4, 1}, {0.6, 3}}, 0.03,
                              Slide{Eigen::Vector2d(0.6, 0.8), -2.0, 2.0}),
                    {{"C", Circle{{2.0, 1.5}, 0.3}},
                     {"E", Superellipse{{-1.0, 1.5}, {0.6, 0.3}, 4.0}},
                     {"F", Superellipse{{0.0, -2.0}, {0.5, 0.7}, 2.5}},
                     {"P", Polygon{{{2.0, -1.0}, {3.0, -1.0}, {3.0, 0.0}, {2.8, 0.0}, {2.8, -0.8}, {2.0, -0.8}}}}},
                    true});
}

JointLimits limits(AngleConvention convention)
{
    return {convention, {Interval{-4.0, 4.0}, Interval{-3.5, 3.8}, std::nullopt, Interval{-4.5, 4.2}, std::nullopt}};
}

/// Free configurations with room of at least 1e-3 to everything.
std::vector<VectorXd> freeConfigurations(const RepulsionModel &model, const Repulsion &repulsion, int count)
{
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> uniform(-2.0, 2.0);
    std::vector<VectorXd> free;
    Repulsion::Sample sample;
    VectorXd gradient;
    for (int trial = 0; trial < 10000 && static_cast<int>(free.size()) < count; ++trial)
    {
        VectorXd q(model.dimension());
        for (double &value : q)
            value = uniform(generator);
        repulsion.evaluate(q, sample);
        const bool allPositive =
            std::all_of(sample.poles.begin(), sample.poles.end(), [](double pole) { return pole > 1e-2; });
        if (allPositive && model.clearance(q, gradient) > 1e-3)
            free.push_back(q);
    }
    return free;
}

TEST(PlanarRepulsionModel, NamesItsGroups)
{
    const auto model = planarRepulsionModel(scene(), limits(AngleConvention::Absolute));
    EXPECT_EQ(model->groups(), (std::vector<std::string>{"C", "E", "F", "P", "limits", "self"}));
    auto plain = scene();
    plain->arm = PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}});  // no slide, no pair that does not meet
    EXPECT_EQ(planarRepulsionModel(plain, {})->groups(), (std::vector<std::string>{"C", "E", "F", "P"}));
}

TEST(PlanarRepulsionModel, CirclesAreTheExactDistance)
{
    const auto model = std::make_shared<PlanarModel>(
        PlanarModel{PlanarArm({0, 0}, {{2.0, -1}, {1.0, 0}}, 0.1), {{"C", Circle{{1.0, 1.0}, 0.4}}}});
    const auto repulsion = planarRepulsionModel(model, {})->continuous({0.3});
    Repulsion::Sample sample;
    repulsion->evaluate(Eigen::Vector2d::Zero(), sample);  // distances 1 and sqrt(2), radius 0.5
    ASSERT_EQ(sample.poles.size(), 2u);
    EXPECT_NEAR(sample.poles[0], 1.0 - 0.25, 1e-15);
    EXPECT_NEAR(sample.poles[1], 2.0 - 0.25, 1e-15);
    EXPECT_NEAR(sample.value, 0.3 / 0.75 + 0.3 / 1.75, 1e-15);
}

TEST(PlanarRepulsionModel, IsTheNearestOfManyPoints)
{
    // The continuous pole is what the paper's poles come to at the link's nearest point.
    auto model = scene();
    model->obstacles.resize(1);
    model->selfCollision = false;
    const auto poles = planarRepulsionModel(model, {});
    const int n = 4000;
    const PointRepulsion many(*model, {1.0}, n);
    const auto repulsion = poles->continuous({1.0, 0.0});
    Repulsion::Sample exact, points;
    for (const VectorXd &q : freeConfigurations(*poles, *repulsion, 30))
    {
        repulsion->evaluate(q, exact);
        many.evaluate(q, points);
        ASSERT_EQ(exact.poles.size(), 5u);
        for (int link = 0; link < 5; ++link)
        {
            const auto first = points.poles.begin() + link * n;
            EXPECT_NEAR(exact.poles[link], *std::min_element(first, first + n), 2e-3);
        }
    }
}

TEST(PlanarRepulsionModel, GradientsAgreeWithDifferences)
{
    for (const AngleConvention convention : {AngleConvention::Absolute, AngleConvention::Relative})
    {
        const auto model = planarRepulsionModel(scene(), limits(convention));
        const auto repulsion = model->continuous({0.1, -0.2, 0.3, 0.15, 0.05, -0.1});
        const std::vector<VectorXd> configurations = freeConfigurations(*model, *repulsion, 60);
        ASSERT_EQ(configurations.size(), 60u);
        Repulsion::Sample sample;
        VectorXd gradient, ignored;
        for (const VectorXd &q : configurations)
        {
            repulsion->evaluate(q, sample);
            EXPECT_EQ(sample.value, repulsion->value(q));
            model->clearance(q, gradient);
            for (int i = 0; i < q.size(); ++i)
            {
                const VectorXd step = 1e-6 * VectorXd::Unit(q.size(), i);
                const double slope = (repulsion->value(q + step) - repulsion->value(q - step)) / 2e-6;
                EXPECT_NEAR(sample.gradient[i], slope, 1e-5 * (1.0 + std::abs(slope))) << "joint " << i;
                const double before = model->clearance(q - step, ignored);
                const double after = model->clearance(q + step, ignored);
                EXPECT_NEAR(gradient[i], (after - before) / 2e-6, 1e-5) << "joint " << i;
            }
        }
    }
}

TEST(PlanarRepulsionModel, ClearanceGradientLeadsOutOfACollision)
{
    const auto model = planarRepulsionModel(scene(), {});
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> uniform(-2.0, 2.0);
    int collisions = 0, freed = 0;
    VectorXd gradient;
    for (int trial = 0; trial < 200; ++trial)
    {
        VectorXd q(6);
        for (double &value : q)
            value = uniform(generator);
        double clearance = model->clearance(q, gradient);
        if (clearance > 0.0)
            continue;
        ++collisions;
        for (int step = 0; step < 200 && clearance <= 0.0; ++step)
        {
            q += 0.02 * gradient.normalized();
            clearance = model->clearance(q, gradient);
        }
        freed += clearance > 0.0 ? 1 : 0;
    }
    EXPECT_GT(collisions, 50);
    EXPECT_GT(freed, collisions * 8 / 10);
}

TEST(PlanarRepulsionModel, PolesOfLimitsAreTheRoomThatIsLeft)
{
    const auto model = std::make_shared<PlanarModel>(
        PlanarModel{PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}}, 0.0, Slide{Eigen::Vector2d(1.0, 0.0), -0.5, 1.0}), {}});
    const VectorXd q = Eigen::Vector3d(0.25, 0.4, 1.0);
    const std::vector<std::optional<Interval>> angles{std::nullopt, Interval{-0.7, 2.0}};
    Repulsion::Sample sample;
    planarRepulsionModel(model, {AngleConvention::Absolute, angles})->continuous({0.1})->evaluate(q, sample);
    const std::vector<double> absolute{0.75, 0.75, 1.7, 1.0};
    ASSERT_EQ(sample.poles.size(), 4u);
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(sample.poles[i], absolute[i], 1e-15);
    planarRepulsionModel(model, {AngleConvention::Relative, angles})->continuous({0.1})->evaluate(q, sample);
    EXPECT_NEAR(sample.poles[2], 1.3, 1e-15);
    EXPECT_NEAR(sample.poles[3], 1.4, 1e-15);
    EXPECT_NEAR(sample.value, 0.1 / 0.75 + 0.1 / 0.75 + 0.1 / 1.3 + 0.1 / 1.4, 1e-15);
}

TEST(PlanarRepulsionModel, PolesChangeSignWhereTheLimitIsPassedOrLinksCross)
{
    auto model = scene();
    model->obstacles.clear();
    model->arm = PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}, {1.0, 1}});
    const auto repulsion = planarRepulsionModel(model, {AngleConvention::Absolute, {Interval{-1.0, 1.0}}});
    ASSERT_EQ(repulsion->groups(), (std::vector<std::string>{"limits", "self"}));
    const auto both = repulsion->continuous({1.0, 1.0});
    Repulsion::Sample sample;
    both->evaluate(Eigen::Vector3d(0.0, 2.0, 3.8), sample);  // the third link stays beside the first
    ASSERT_EQ(sample.poles.size(), 3u);
    EXPECT_GT(sample.poles[2], 0.0);
    both->evaluate(Eigen::Vector3d(0.0, 2.0, 4.9), sample);  // and cuts through it
    EXPECT_LT(sample.poles[2], 0.0);
    both->evaluate(Eigen::Vector3d(1.5, 2.0, 3.0), sample);
    EXPECT_LT(sample.poles[1], 0.0);
    EXPECT_GT(sample.poles[0], 0.0);
}

TEST(PlanarRepulsionModel, LinksRepelEachOtherAtTwiceTheirRadius)
{
    const auto model =
        std::make_shared<PlanarModel>(PlanarModel{PlanarArm({0, 0}, {{2.0, -1}, {1.0, 0}, {1.0, 1}}, 0.1), {}, true});
    const VectorXd q = Eigen::Vector3d(0.0, 0.5 * std::acos(-1.0), std::acos(-1.0));  // the third lies over the first
    Repulsion::Sample sample;
    planarRepulsionModel(model, {})->continuous({1.0})->evaluate(q, sample);
    const auto at = [](double x, double y, double dx)
    {
        return Segment::between({x, y}, {x + dx, y});
    };
    ASSERT_EQ(sample.poles.size(), 1u);
    EXPECT_NEAR(sample.poles[0], pairPole(at(0, 0, 2), at(2, 1, -1), 0.2, 2.0 * (1.0 + 0.2)).value, 1e-12);
    VectorXd gradient;
    EXPECT_NEAR(planarRepulsionModel(model, {})->clearance(q, gradient), 0.8, 1e-12);
}

TEST(PlanarRepulsionModel, SeesOnWhichSideObstaclesLieAndWhichJointsAThroatPins)
{
    // Three links along x and a branch up from the first one; a throat around the second.
    const auto model = std::make_shared<PlanarModel>(
        PlanarModel{PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}, {1.0, 1}, {1.0, 0}}),
                    {{"left", Circle{{1.5, 0.52}, 0.5}}, {"right", Circle{{1.5, -0.53}, 0.5}}}});
    const auto poles = planarRepulsionModel(model, {});
    const VectorXd q = Eigen::Vector4d(0.0, 0.0, 0.0, 2.0);
    const Surroundings narrow = poles->surroundings(q, 0.1);
    EXPECT_NEAR(narrow.clearance, 0.02, 1e-12);
    ASSERT_EQ(narrow.sides.size(), 2u);
    EXPECT_EQ(narrow.sides[0] * narrow.sides[1], -1);
    EXPECT_EQ(narrow.pinned, (std::vector<int>{1, 2}));         // what hangs on the second link, not the branch
    EXPECT_TRUE(poles->surroundings(q, 0.025).pinned.empty());  // the right one is farther
    ASSERT_EQ(narrow.weights.size(), 2u);
    for (int i = 0; i < 2; ++i)
    {
        std::vector<double> strengths(2, 0.0);
        strengths[i] = 1.0;
        EXPECT_NEAR(narrow.weights[i], poles->continuous(strengths)->value(q), 1e-9 * narrow.weights[i]);
    }
}

TEST(PlanarRepulsionModel, StrengthZeroLeavesAGroupOut)
{
    const auto model = planarRepulsionModel(scene(), limits(AngleConvention::Absolute));
    Repulsion::Sample sample;
    const VectorXd q = VectorXd::Constant(6, 0.3);
    model->continuous({0.0, 0.1, 0.0, 0.1, 0.0, 0.0})->evaluate(q, sample);
    EXPECT_EQ(sample.poles.size(), 10u);
    model->continuous({0.0, 0.0, 0.0, 0.0, 0.1, 0.1})->evaluate(q, sample);
    EXPECT_EQ(sample.poles.size(), 8u + 5u);  // a slide and three limits, two sides each; five pairs
}

TEST(PlanarRepulsionModel, PointsAreThePapers)
{
    auto model = scene();
    model->obstacles.pop_back();
    const auto poles = planarRepulsionModel(model, {});
    const VectorXd q = VectorXd::Constant(6, 0.3);
    EXPECT_EQ(poles->points({0.1, 0.2, 0.3, 0.0, 0.0}, 4)->value(q),
              PointRepulsion(*model, {0.1, 0.2, 0.3}, 4).value(q));
    EXPECT_THROW(poles->points({0.1, 0.2, 0.3, 0.1, 0.0}, 4), std::invalid_argument);
    EXPECT_THROW(poles->points({0.1, 0.2, 0.3}, 4), std::invalid_argument);
    EXPECT_THROW(planarRepulsionModel(scene(), {})->points(std::vector<double>(6, 0.0), 4), std::invalid_argument);
}

TEST(PlanarRepulsionModel, RefusesWrongStrengthsAndLimits)
{
    const auto model = planarRepulsionModel(scene(), {});
    EXPECT_THROW(model->continuous({0.1}), std::invalid_argument);
    EXPECT_THROW(model->continuous({0.1, 0.1, std::nan(""), 0.1, 0.1, 0.1}), std::invalid_argument);
    const std::vector<std::optional<Interval>> tooMany(6);
    EXPECT_THROW(planarRepulsionModel(scene(), {AngleConvention::Absolute, tooMany}), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
