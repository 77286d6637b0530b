// SPDX-License-Identifier: BSD-3-Clause
// The analytic checker against the scalar one, state by state. NARROWS_STATES=1000000 looks at a million per scene.
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "PaperCases.h"
#include "ScalarChecker.h"
#include "scenario/Scenario.h"

namespace narrows
{
namespace
{
int statesPerScene()
{
    const char *asked = std::getenv("NARROWS_STATES");
    return asked != nullptr ? std::atoi(asked) : 20000;
}

struct Tally
{
    int free = 0, disagreements = 0;
};

/// Up to `most` states at once: the batch's verdicts, the single ones and the scalar checker's.
void compareBatch(const ArmChecker &checker, const ScalarChecker &scalar, const Eigen::MatrixXd &states, Tally &tally)
{
    std::vector<char> batch;
    checker.areFree(states, batch);
    ASSERT_EQ(batch.size(), states.rows());
    for (Eigen::Index k = 0; k < states.rows(); ++k)
    {
        const Eigen::VectorXd q = states.row(k);
        const bool free = checker.isFree(q);
        tally.free += free;
        tally.disagreements += free != scalar.isFree(q) || batch[k] != (free ? 1 : 0);
    }
}

/// Half of the states spread over the whole joint space, half crowded around `crowd`.
Tally compare(const PlanarModel &model, const Eigen::VectorXd &crowd, int states)
{
    const auto checker = makeArmChecker("analytic", model);
    const ScalarChecker scalar(model);
    std::mt19937_64 generator(17);
    std::uniform_real_distribution<double> uniform(-std::acos(-1.0), std::acos(-1.0));
    std::normal_distribution<double> normal(0.0, 0.05);
    Tally tally;
    Eigen::MatrixXd batch(37, crowd.size());  // two whole blocks and a part of one
    for (int first = 0; first < states; first += 37)
    {
        for (Eigen::Index k = 0; k < batch.rows(); ++k)
            for (Eigen::Index i = 0; i < crowd.size(); ++i)
                batch(k, i) = k % 2 == 0 ? uniform(generator) : crowd[i] + normal(generator);
        compareBatch(*checker, scalar, batch, tally);
    }
    return tally;
}

TEST(CheckerAgreement, OnThePapersCases)
{
    for (const int number : {1, 2, 3})
    {
        const PlanarWorld world = paperCase(number).planar();
        const Tally tally = compare(*world.model, std::get<Eigen::VectorXd>(world.task.goal), statesPerScene());
        EXPECT_EQ(tally.disagreements, 0) << number;
        EXPECT_GT(tally.free, statesPerScene() / 10) << number;
        EXPECT_LT(tally.free, statesPerScene()) << number;
    }
}

/// Boxes, a polygon that is not convex, more obstacles than an ObstacleBits has bits, thick links that may not touch.
TEST(CheckerAgreement, OnAChainAmongEverything)
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> place(-4.0, 4.0), size(0.02, 0.12);
    std::vector<PlanarObstacle> obstacles;
    for (int i = 0; i < 60; ++i)
    {
        const Eigen::Vector2d center(place(generator), place(generator));
        const double extent = size(generator);
        if (center.norm() < 0.8)
            continue;
        const std::string name = std::to_string(i);
        if (i % 3 == 0)
            obstacles.push_back({name, Circle{center, extent}});
        else if (i % 3 == 1)
            obstacles.push_back({name, Superellipse{center, {extent, 2.0 * extent}, i % 2 == 0 ? 4.0 : 3.0}});
        else
        {
            Polygon arrow;
            for (const Eigen::Vector2d &corner :
                 {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, -1), Eigen::Vector2d(0.3, 0), Eigen::Vector2d(1, 1)})
                arrow.vertices.emplace_back(center + 2.0 * extent * corner);
            obstacles.push_back({name, arrow});
        }
    }
    ASSERT_GT(obstacles.size(), 40u);
    std::vector<PlanarLink> links;
    for (int i = 0; i < 10; ++i)
        links.push_back({0.35, i - 1});
    links.push_back({0.3, 4});  // a branch
    const PlanarModel model{PlanarArm({0, 0}, links, 0.01), obstacles, true};
    const Tally tally = compare(model, Eigen::VectorXd::LinSpaced(11, -0.5, 0.9), statesPerScene());
    EXPECT_EQ(tally.disagreements, 0);
    EXPECT_GT(tally.free, statesPerScene() / 50);
}
}  // namespace
}  // namespace narrows
