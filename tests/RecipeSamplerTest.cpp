// SPDX-License-Identifier: BSD-3-Clause
#include "planners/RecipeSampler.h"

#include <cmath>

#include <gtest/gtest.h>

#include "kernel/PlanarRepulsionModel.h"

namespace narrows
{
namespace
{
/// Five unit links, straight along x at the start, and circles above and below the last one.
struct Throat
{
    explicit Throat(double halfWidth) : Throat(halfWidth, halfWidth) {}

    Throat(double above, double below)
      : model(std::make_shared<PlanarModel>(
            PlanarModel{PlanarArm({0, 0}, std::vector<PlanarLink>{{1, -1}, {1, 0}, {1, 1}, {1, 2}, {1, 3}}),
                        {{"above", Circle{{4.5, 0.5 + above}, 0.5}}, {"below", Circle{{4.5, -0.5 - below}, 0.5}}}})),
        poles(planarRepulsionModel(model, {}))
    {
        ends.start = Eigen::VectorXd::Zero(5);
        ends.goal.resize(5);
        ends.goal << 1.2, 1.5, 0.9, 1.1, 1.4;
        ends.turns = Eigen::VectorXi::Zero(5);
        ends.turnable = {0, 1, 2, 3, 4};
    }

    std::shared_ptr<PlanarModel> model;
    std::shared_ptr<const RepulsionModel> poles;
    CurveEnds ends;
};

std::vector<double> row(const CurveRecipe &recipe, int index)
{
    const Eigen::RowVectorXd strengths = recipe.strengths.row(index);
    return {strengths.data(), strengths.data() + strengths.size()};
}

TEST(RecipeSampler, KeepsWModerateAtBothEndsHoweverNarrow)
{
    for (const double halfWidth : {1e-1, 1e-3, 1e-6})
    {
        const Throat throat(halfWidth);
        ompl::RNG random(3);
        RecipeSampler sampler(throat.poles, throat.ends, 1);
        for (int i = 0; i < 200; ++i)
        {
            const auto w = throat.poles->continuous(row(sampler.next(random), 0));
            // Sums of poles that cancel lose as many digits as the poles are larger than their sum.
            EXPECT_LE(std::abs(w->value(throat.ends.start)), 3.0 + 1e-9 / halfWidth);
            EXPECT_LE(std::abs(w->value(throat.ends.goal)), 3.0 + 1e-9 / halfWidth);
        }
    }
}

TEST(RecipeSampler, HoldsTheLinkInTheThroatAndLeadsTheOthers)
{
    const Throat throat(1e-4);
    ompl::RNG random(4);
    RecipeSampler sampler(throat.poles, throat.ends, 1);
    int held = 0, decreasing = 0;
    for (int i = 0; i < 200; ++i)
    {
        const CurveRecipe recipe = sampler.next(random);
        EXPECT_NEAR(recipe.directions.col(0).norm(), 1.0, 1e-12);
        EXPECT_EQ(recipe.fromGoal, recipe.schedule.empty());  // the start is narrower: held curves begin there
        decreasing += recipe.window.decreasing ? 1 : 0;
        if (recipe.schedule.empty())
            continue;
        ++held;
        EXPECT_EQ(recipe.schedule.held, (std::vector<int>{0, 0, 0, 0, -1}));
        EXPECT_EQ(recipe.directions(4, 0), 0.0);
    }
    EXPECT_GT(held, 100);
    EXPECT_LT(held, 200);
    EXPECT_EQ(2 * decreasing, held);
}

TEST(RecipeSampler, TriesTheOtherDirectionOfAHeldCurveNext)
{
    const Throat throat(1e-4);
    ompl::RNG random(5);
    RecipeSampler sampler(throat.poles, throat.ends, 1);
    for (int i = 0; i < 50; ++i)
    {
        const CurveRecipe first = sampler.next(random);
        if (first.schedule.empty())
            continue;
        const CurveRecipe second = sampler.next(random);
        EXPECT_FALSE(first.window.decreasing);
        EXPECT_TRUE(second.window.decreasing);
        EXPECT_EQ(second.strengths, first.strengths);
        EXPECT_EQ(second.directions, first.directions);
        EXPECT_EQ(second.turns, first.turns);
        EXPECT_EQ(second.schedule.held, first.schedule.held);
        EXPECT_EQ(second.schedule.share, first.schedule.share);
    }
}

TEST(RecipeSampler, HoldsNothingWhereThereIsRoom)
{
    const Throat open(0.5, 3.0);  // the other side is more than twice as far
    ompl::RNG random(6);
    RecipeSampler sampler(open.poles, open.ends, 1);
    for (int i = 0; i < 50; ++i)
        EXPECT_TRUE(sampler.next(random).schedule.empty());
}

TEST(RecipeSampler, TurnsJointsInFullFromTheThirdAttemptOnIfTheyMayTurn)
{
    Throat wide(1.0);
    wide.ends.turns << 0, 1, 0, -1, 0;
    wide.ends.turnable = {1, 3};
    ompl::RNG random(7);
    RecipeSampler sampler(wide.poles, wide.ends, 1);
    int turned = 0;
    for (int i = 0; i < 200; ++i)
    {
        const Eigen::VectorXi turns = sampler.next(random).turns - wide.ends.turns;
        EXPECT_EQ(turns[0], 0);
        EXPECT_EQ(turns[2], 0);
        EXPECT_EQ(turns[4], 0);
        turned += turns.isZero() ? 0 : 1;
        EXPECT_TRUE(i >= 2 || turns.isZero()) << i;
    }
    EXPECT_GT(turned, 20);
    wide.ends.turnable.clear();
    RecipeSampler fixed(wide.poles, wide.ends, 1);
    for (int i = 0; i < 50; ++i)
        EXPECT_EQ(fixed.next(random).turns, wide.ends.turns);
}

TEST(RecipeSampler, RowsAreOrthonormalAndShareOutThePoles)
{
    const Throat wide(1.0);
    ompl::RNG random(8);
    RecipeSampler sampler(wide.poles, wide.ends, 3);
    for (int i = 0; i < 50; ++i)
    {
        const CurveRecipe recipe = sampler.next(random);
        ASSERT_EQ(recipe.directions.cols(), 3);
        ASSERT_EQ(recipe.strengths.rows(), 3);
        const Eigen::MatrixXd products = recipe.directions.transpose() * recipe.directions;
        EXPECT_TRUE(products.isApprox(Eigen::MatrixXd::Identity(3, 3), 1e-12));
        for (int group = 0; group < 2; ++group)
            EXPECT_LE((recipe.strengths.col(group).array() != 0.0).count(), 1);
    }
}

TEST(RecipeSampler, SameSeedSameRecipes)
{
    const Throat throat(1e-3);
    ompl::RNG one(9), other(9);
    RecipeSampler first(throat.poles, throat.ends, 1), second(throat.poles, throat.ends, 1);
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(first.next(one).parameters(), second.next(other).parameters());
}
}  // namespace
}  // namespace narrows
