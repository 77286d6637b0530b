// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PointRepulsion.h"

#include <cmath>

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
PlanarModel scene()
{
    return {PlanarArm({0.2, -0.1}, {{1.0, -1}, {0.8, 0}, {0.5, 1}, {0.4, 1}}, 0.05,
                      Slide{Eigen::Vector2d(0.6, 0.8), -1.0, 1.0}),
            {{"C", Circle{{2.0, 1.5}, 0.3}},
             {"E", Superellipse{{-1.0, 1.5}, {0.6, 0.3}, 4.0}},
             {"F", Superellipse{{0.0, -2.0}, {0.5, 0.7}, 2.5}}}};
}

TEST(PointRepulsion, IsTheSumOfThePaper)
{
    // One link of length 1 along x, two points, one circle: 0.3 / ((1.5^2) - 0.25) + 0.3 / (1^2 - 0.25).
    const PlanarModel model{PlanarArm({0, 0}, {{1.0, -1}}), {{"C", Circle{{2.0, 0.0}, 0.5}}}};
    const PointRepulsion repulsion(model, {0.3}, 2);
    EXPECT_NEAR(repulsion.value(Eigen::VectorXd::Zero(1)), 0.3 / 2.0 + 0.3 / 0.75, 1e-15);
}

TEST(PointRepulsion, GradientAgreesWithDifferencesOnTreesAndSlides)
{
    const PointRepulsion repulsion(scene(), {0.1, -0.2, 0.3}, 4);
    Eigen::VectorXd q(5);
    q << 0.1, 0.4, 1.1, 2.0, -0.5;
    PointRepulsion::Sample sample;
    repulsion.evaluate(q, sample);
    EXPECT_DOUBLE_EQ(sample.value, repulsion.value(q));
    for (int i = 0; i < 5; ++i)
    {
        const double h = 1e-6;
        const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(5, i);
        const double difference = (repulsion.value(q + step) - repulsion.value(q - step)) / (2.0 * h);
        EXPECT_NEAR(sample.gradient[i], difference, 1e-7) << "joint " << i;
    }
}

TEST(PointRepulsion, PolesArePositiveOutsideAndGrowByTheLinkRadius)
{
    const PlanarModel model{PlanarArm({0, 0}, {{1.0, -1}}, 0.5), {{"C", Circle{{2.0, 0.0}, 0.4}}}};
    PointRepulsion::Sample sample;
    PointRepulsion(model, {1.0}, 1).evaluate(Eigen::VectorXd::Zero(1), sample);
    ASSERT_EQ(sample.poles.size(), 1u);
    EXPECT_NEAR(sample.poles[0], 1.0 - 0.81, 1e-15);
}

TEST(PointRepulsion, RefusesWhatThePaperHasNoFunctionFor)
{
    PlanarModel model = scene();
    EXPECT_THROW(PointRepulsion(model, {0.1, 0.2}, 4), std::invalid_argument);
    EXPECT_THROW(PointRepulsion(model, {0.1, 0.2, std::nan("")}, 4), std::invalid_argument);
    EXPECT_THROW(PointRepulsion(model, {0.1, 0.2, 0.3}, 0), std::invalid_argument);
    model.obstacles.push_back({"P", Polygon{{{5, 5}, {6, 5}, {5, 6}}}});
    EXPECT_FALSE(PointRepulsion::supports(model));
    EXPECT_THROW(PointRepulsion(model, {0.1, 0.2, 0.3, 0.4}, 4), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
