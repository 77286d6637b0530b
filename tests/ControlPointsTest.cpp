// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/ControlPoints.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>

#include "spaces/JointStateSpace.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Slides along x and carries a link of length 2 that turns: balls in its middle and at its end.
ControlPoints sliderWithLink()
{
    return {2,
            2,
            {0.25, 0.125},
            [](const auto &q, Eigen::MatrixXd &points, std::vector<Eigen::MatrixXd> *jacobians)
            {
                for (int k = 0; k < 2; ++k)
                {
                    const Vector2d along = (k + 1) * Vector2d(std::cos(q[1]), std::sin(q[1]));
                    points.col(k) = Vector2d(q[0], 0.0) + along;
                    if (jacobians != nullptr)
                        (*jacobians)[static_cast<std::size_t>(k)] << 1.0, -along.y(), 0.0, along.x();
                }
            }};
}

DistanceFunction disc(const std::string &name, const Vector2d &center, double radius)
{
    return {name, [=](const auto &point, VectorXd *gradient)
            {
                const Vector2d apart = point - center;
                if (gradient != nullptr)
                    *gradient = apart.normalized();
                return apart.norm() - radius;
            }};
}

std::shared_ptr<const RepulsionModel> twoDiscs()
{
    return controlPointModel(sliderWithLink(), {disc("A", {0.0, 3.0}, 0.5), disc("B", {4.0, 0.0}, 1.0)}, 0.7);
}

TEST(ControlPointModel, SumsOnePolePerObstacleAndBall)
{
    const auto model = twoDiscs();
    EXPECT_EQ(model->groups(), (std::vector<std::string>{"A", "B"}));
    EXPECT_EQ(model->naturalStrength(1), 0.7);
    Repulsion::Sample sample;
    const VectorXd q = Vector2d(0.0, 0.0);  // balls at (1, 0) and (2, 0)
    model->continuous({0.3, -0.2})->evaluate(q, sample);
    const double poles[] = {std::sqrt(10.0) - 0.75, std::sqrt(13.0) - 0.625, 1.75, 0.875};
    ASSERT_EQ(sample.poles.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(sample.poles[i], poles[i], 1e-15);
    EXPECT_NEAR(sample.value, 0.3 / poles[0] + 0.3 / poles[1] - 0.2 / poles[2] - 0.2 / poles[3], 1e-15);
    EXPECT_EQ(model->continuous({0.3, -0.2})->value(q), sample.value);
    EXPECT_EQ(model->points({0.3, -0.2}, 5)->value(q), sample.value);
}

TEST(ControlPointModel, HasTheGradientsOfItsValues)
{
    const auto model = twoDiscs();
    const auto repulsion = model->continuous({0.3, -0.2});
    const VectorXd q = Vector2d(0.4, 0.9);
    Repulsion::Sample sample;
    repulsion->evaluate(q, sample);
    VectorXd gradient, ignored;
    model->clearance(q, gradient);
    for (int j = 0; j < 2; ++j)
    {
        const VectorXd step = 1e-6 * VectorXd::Unit(2, j);
        EXPECT_NEAR(sample.gradient[j], (repulsion->value(q + step) - repulsion->value(q - step)) / 2e-6, 1e-8);
        EXPECT_NEAR(gradient[j], (model->clearance(q + step, ignored) - model->clearance(q - step, ignored)) / 2e-6,
                    1e-8);
    }
}

TEST(ControlPointModel, LeavesOutWhatHasNoStrength)
{
    Repulsion::Sample sample;
    twoDiscs()->continuous({0.0, 1.0})->evaluate(VectorXd(Vector2d(0.0, 0.0)), sample);
    EXPECT_EQ(sample.poles.size(), 2u);
    VectorXd gradient;
    const auto alone = controlPointModel(sliderWithLink(), {}, 1.0);
    EXPECT_EQ(alone->clearance(VectorXd(Vector2d(0.0, 0.0)), gradient), std::numeric_limits<double>::infinity());
    EXPECT_EQ(gradient.norm(), 0.0);
}

TEST(ControlPointModel, RefusesWhatIsMissing)
{
    EXPECT_THROW(controlPointModel({0, 2, {0.1}, sliderWithLink().place}, {}, 1.0), std::invalid_argument);
    EXPECT_THROW(controlPointModel({2, 2, {}, sliderWithLink().place}, {}, 1.0), std::invalid_argument);
    EXPECT_THROW(controlPointModel({2, 2, {0.1}, nullptr}, {}, 1.0), std::invalid_argument);
    EXPECT_THROW(controlPointModel({2, 2, {-0.1}, sliderWithLink().place}, {}, 1.0), std::invalid_argument);
    EXPECT_THROW(controlPointModel(sliderWithLink(), {{"A", nullptr}}, 1.0), std::invalid_argument);
    EXPECT_THROW(controlPointModel(sliderWithLink(), {disc("A", {5, 5}, 1), disc("A", {6, 5}, 1)}, 1.0),
                 std::invalid_argument);
    EXPECT_THROW(controlPointModel(sliderWithLink(), {}, 0.0), std::invalid_argument);
    EXPECT_THROW(twoDiscs()->continuous({1.0}), std::invalid_argument);
}

TEST(JointStateSpace, CountsAsTheStateSays)
{
    const JointStateSpace space({{false, Interval{-2.0, 2.0}}, {true, std::nullopt, true}});
    ob::State *a = space.allocState(), *b = space.allocState();
    space.fromConfiguration(Vector2d(1.0, 3.0), a);
    space.fromConfiguration(Vector2d(-0.5, 3.5), b);
    VectorXd q, delta;
    space.toConfiguration(b, q);
    EXPECT_NEAR(q[1], 3.5 - 2.0 * std::acos(-1.0), 1e-15);
    space.displacement(a, b, delta);
    EXPECT_NEAR(delta[0], -1.5, 1e-15);
    EXPECT_NEAR(delta[1], 0.5, 1e-14);  // the short way
    space.freeState(a);
    space.freeState(b);
}

TEST(JointStateSpace, RefusesJointsThatMakeNoSense)
{
    EXPECT_THROW(JointStateSpace({}), std::invalid_argument);
    EXPECT_THROW(JointStateSpace({{false, std::nullopt}}), std::invalid_argument);
    EXPECT_THROW(JointStateSpace({{true, Interval{1.0, 1.0}}}), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
