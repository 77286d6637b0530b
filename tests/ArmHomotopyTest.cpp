// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/ArmHomotopy.h"

#include <cmath>

#include <gtest/gtest.h>

#include "PaperCases.h"
#include "kernel/PlaneTracker.h"
#include "kernel/SphereTracker.h"

namespace narrows
{
namespace
{
using Eigen::VectorXd;

double largestJointStep(const Trace &trace)
{
    double largest = 0.0;
    for (std::size_t i = 1; i < trace.configurations.size(); ++i)
        largest = std::max(largest, (trace.configurations[i] - trace.configurations[i - 1]).cwiseAbs().maxCoeff());
    return largest;
}

/// Distance from a point to the polyline of a trace.
double distanceTo(const Trace &trace, const VectorXd &point)
{
    double nearest = (point - trace.configurations.front()).norm();
    for (std::size_t i = 1; i < trace.configurations.size(); ++i)
    {
        const VectorXd &from = trace.configurations[i - 1];
        const VectorXd along = trace.configurations[i] - from;
        const double t = std::min(1.0, std::max(0.0, along.dot(point - from) / along.squaredNorm()));
        nearest = std::min(nearest, (point - from - t * along).norm());
    }
    return nearest;
}

SphereOptions spheres(const PaperRecipe &recipe)
{
    SphereOptions options;
    options.window = recipe.window;
    return options;
}

PlaneOptions plane(const PaperRecipe &recipe)
{
    PlaneOptions options;
    options.window = recipe.window;
    return options;
}

// Table 4 of the paper.
TEST(ArmHomotopy, Case1TakesThePrinted146Hyperspheres)
{
    const PaperRecipe recipe = paperRecipe(1);
    const Trace trace = traceSpheres(recipe.homotopy, spheres(recipe));
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(trace.steps, 146);
    EXPECT_LE(largestJointStep(trace), 0.03);  // Fig. 12
}

TEST(ArmHomotopy, Case2TakesThePrinted323HyperspheresBeyondLambdaOne)
{
    const PaperRecipe recipe = paperRecipe(2);
    const Trace trace = traceSpheres(recipe.homotopy, spheres(recipe));
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(trace.steps, 323);
    EXPECT_EQ(trace.wrongRoots, 2);
    EXPECT_LE(largestJointStep(trace), 0.03);  // Fig. 17
}

TEST(ArmHomotopy, Case2StoppedAtTheFirstLambdaOneIsAWrongRoot)
{
    PaperRecipe recipe = paperRecipe(2);
    recipe.window.lambdaMax = 1.0;
    EXPECT_EQ(traceSpheres(recipe.homotopy, spheres(recipe)).status, TraceStatus::WrongRoot);
    EXPECT_EQ(traceSpheres(recipe.homotopy, spheres(recipe)).steps, 219);
    EXPECT_EQ(tracePlane(recipe.homotopy, plane(recipe)).status, TraceStatus::WrongRoot);
}

TEST(ArmHomotopy, Case3IsReachedByTheRecipeAndNotByThePrintedRepulsions)
{
    const PaperRecipe recipe = paperRecipe(3);
    const Trace full = traceSpheres(recipe.homotopy, spheres(recipe));
    EXPECT_EQ(full.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(full.steps, 966);
    EXPECT_LE(largestJointStep(full), 0.02);  // Fig. 21
    EXPECT_EQ(tracePlane(recipe.homotopy, plane(recipe)).status, TraceStatus::ReachedGoal);

    const PaperRecipe printed = paperRecipe(3, {1e-7, -1.2, 450.0, 60.0, -0.0001, 10.0, -63.0});
    EXPECT_EQ(traceSpheres(printed.homotopy, spheres(printed)).status, TraceStatus::WrongRoot);
    EXPECT_EQ(tracePlane(printed.homotopy, plane(printed)).status, TraceStatus::WrongRoot);
}

TEST(ArmHomotopy, LeavingCase3TowardsLargerLambdaTurnsBack)
{
    PaperRecipe recipe = paperRecipe(3);
    recipe.window.decreasing = false;
    EXPECT_EQ(traceSpheres(recipe.homotopy, spheres(recipe)).status, TraceStatus::TurnedBack);
    EXPECT_EQ(tracePlane(recipe.homotopy, plane(recipe)).status, TraceStatus::TurnedBack);
}

TEST(ArmHomotopy, BothFormsGiveTheSameCurve)
{
    for (const int number : {1, 2})
    {
        const PaperRecipe recipe = paperRecipe(number);
        const Trace full = traceSpheres(recipe.homotopy, spheres(recipe));
        PlaneOptions options = plane(recipe);
        options.maxStep = 5e-4;  // so that the chords of the polyline stay within 1e-7 of the curve
        options.maxSteps = 100000;
        const Trace fine = tracePlane(recipe.homotopy, options);
        ASSERT_EQ(fine.status, TraceStatus::ReachedGoal);
        for (std::size_t i = 0; i < full.configurations.size(); ++i)
            ASSERT_LE(distanceTo(fine, full.configurations[i]), 1e-6) << "case " << number << ", sphere " << i;
    }
}

TEST(ArmHomotopy, PointsOfThePlaneFormLieOnTheCurve)
{
    for (const int number : {1, 2, 3})
    {
        const PaperRecipe recipe = paperRecipe(number);
        const ArmHomotopy &h = recipe.homotopy;
        const Trace trace = tracePlane(h, plane(recipe));
        ArmRepulsion::Sample sample;
        VectorXd residual;
        for (std::size_t i = 0; i < trace.configurations.size(); ++i)
        {
            h.repulsion().evaluate(trace.configurations[i], sample);
            const VectorXd offset = trace.configurations[i] - h.start() - trace.lambdas[i] * h.difference();
            const double s = offset.dot(h.direction());
            const Eigen::Vector2d gradient =
                h.planeGradient(sample).cwiseProduct(Eigen::Vector2d(1.0 / h.difference().norm(), 1.0));
            // Newton's estimate of the distance to the curve; the third case's poles bend it most.
            EXPECT_LE(std::abs(h.planeResidual(trace.lambdas[i], s, sample)) / gradient.norm(),
                      number < 3 ? 1e-6 : 1e-5)
                << "case " << number << ", step " << i;
        }
    }
}

TEST(ArmHomotopy, TheFullCurveLiesInThePlane)
{
    const PaperRecipe recipe = paperRecipe(2);
    const ArmHomotopy &h = recipe.homotopy;
    const Trace full = traceSpheres(h, spheres(recipe));
    for (std::size_t i = 0; i < full.configurations.size(); ++i)
    {
        const VectorXd offset = full.configurations[i] - h.start() - full.lambdas[i] * h.difference();
        EXPECT_LE((offset - offset.dot(h.direction()) * h.direction()).norm(), 1e-9) << "sphere " << i;
    }
}

TEST(ArmHomotopy, RowsAndDirectionAreTwoWaysToTheSameHomotopy)
{
    const PaperRecipe recipe = paperRecipe(1);
    const ArmHomotopy &rows = recipe.homotopy;
    const ArmHomotopy direction =
        ArmHomotopy::fromDirection(rows.repulsion(), rows.start(), rows.goal(), rows.direction(), rows.strength());
    const Trace a = tracePlane(rows, plane(recipe));
    const Trace b = tracePlane(direction, plane(recipe));
    ASSERT_EQ(a.configurations.size(), b.configurations.size());
    for (std::size_t i = 0; i < a.configurations.size(); ++i)
        EXPECT_LE((a.configurations[i] - b.configurations[i]).norm(), 1e-9);
    const Trace full = traceSpheres(direction, spheres(recipe));
    EXPECT_EQ(full.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(full.steps, 146);
}

TEST(ArmHomotopy, JacobianAgreesWithDifferences)
{
    const ArmHomotopy &h = paperRecipe(2).homotopy;
    VectorXd z(9);
    z << 0.5 * (h.start() + h.goal()), 0.4;
    ArmRepulsion::Sample sample;
    Eigen::MatrixXd jacobian;
    VectorXd plus, minus;
    h.repulsion().evaluate(z.head(8), sample);
    h.jacobian(sample, jacobian);
    for (int j = 0; j < 9; ++j)
    {
        const VectorXd step = 1e-6 * VectorXd::Unit(9, j);
        const VectorXd above = z + step, below = z - step;
        h.repulsion().evaluate(above.head(8), sample);
        h.residual(above.head(8), above[8], sample, plus);
        h.repulsion().evaluate(below.head(8), sample);
        h.residual(below.head(8), below[8], sample, minus);
        EXPECT_LE(((plus - minus) / 2e-6 - jacobian.col(j)).norm(), 1e-5 * std::max(1.0, jacobian.col(j).norm()));
    }
}

TEST(ArmHomotopy, StartAndGoalSolveIt)
{
    const ArmHomotopy &h = paperRecipe(1).homotopy;
    ArmRepulsion::Sample sample;
    VectorXd residual;
    h.repulsion().evaluate(h.start(), sample);
    h.residual(h.start(), 0.0, sample, residual);
    EXPECT_LE(residual.norm(), 1e-14);
    EXPECT_LE(std::abs(h.planeResidual(0.0, 0.0, sample)), 1e-14);
    h.repulsion().evaluate(h.goal(), sample);
    h.residual(h.goal(), 1.0, sample, residual);
    EXPECT_LE(residual.norm(), 1e-14);
    EXPECT_LE(std::abs(h.planeResidual(1.0, 0.0, sample)), 1e-14);
}

TEST(ArmHomotopy, RefusesImpossibleConstants)
{
    const ArmHomotopy &h = paperRecipe(1).homotopy;
    Eigen::MatrixXd dependent = h.rows();
    dependent.row(1) = 2.0 * dependent.row(0);
    EXPECT_THROW(ArmHomotopy::fromRows(h.repulsion(), h.start(), h.goal(), dependent), std::invalid_argument);
    EXPECT_THROW(ArmHomotopy::fromRows(h.repulsion(), h.start(), h.goal(), h.rows().topRows(2)), std::invalid_argument);
    EXPECT_THROW(ArmHomotopy::fromRows(h.repulsion(), h.start().head(2), h.goal(), h.rows()), std::invalid_argument);
    EXPECT_THROW(ArmHomotopy::fromDirection(h.repulsion(), h.start(), h.goal(), VectorXd::Zero(3), 1.0),
                 std::invalid_argument);
    EXPECT_THROW(ArmHomotopy::fromDirection(h.repulsion(), h.start(), h.goal(), VectorXd::Ones(3), 0.0),
                 std::invalid_argument);
}

TEST(Trackers, StopWhenAsked)
{
    const PaperRecipe recipe = paperRecipe(1);
    const auto now = []()
    {
        return true;
    };
    EXPECT_EQ(traceSpheres(recipe.homotopy, spheres(recipe), now).status, TraceStatus::Interrupted);
    EXPECT_EQ(tracePlane(recipe.homotopy, plane(recipe), now).status, TraceStatus::Interrupted);
    SphereOptions few = spheres(recipe);
    few.maxSpheres = 10;
    EXPECT_EQ(traceSpheres(recipe.homotopy, few).status, TraceStatus::MaxSteps);
    PlaneOptions fewSteps = plane(recipe);
    fewSteps.maxSteps = 5;
    EXPECT_EQ(tracePlane(recipe.homotopy, fewSteps).status, TraceStatus::MaxSteps);
}

TEST(Trackers, StandStillWhenTheGoalIsTheStart)
{
    const ArmHomotopy &h = paperRecipe(1).homotopy;
    const ArmHomotopy still = ArmHomotopy::fromRows(h.repulsion(), h.start(), h.start(), h.rows());
    EXPECT_EQ(tracePlane(still).status, TraceStatus::ReachedGoal);
    EXPECT_EQ(traceSpheres(still).status, TraceStatus::ReachedGoal);
}

TEST(Trackers, TooStrongRepulsionTurnsTheCurveBack)
{
    // With 20 points per link instead of 5, n P is so large that dPhi/ds changes its sign near the start.
    const PaperRecipe recipe = paperRecipe(1, {}, 20);
    EXPECT_EQ(traceSpheres(recipe.homotopy, spheres(recipe)).status, TraceStatus::TurnedBack);
    EXPECT_EQ(tracePlane(recipe.homotopy, plane(recipe)).status, TraceStatus::TurnedBack);
}

TEST(Trackers, RefuseOptionsOutOfRange)
{
    const ArmHomotopy &h = paperRecipe(1).homotopy;
    SphereOptions spheresOptions;
    spheresOptions.radius = 0.0;
    EXPECT_THROW(traceSpheres(h, spheresOptions), std::invalid_argument);
    PlaneOptions planeOptions;
    planeOptions.contraction = 1.0;
    EXPECT_THROW(tracePlane(h, planeOptions), std::invalid_argument);
    planeOptions = {};
    planeOptions.window.lambdaMax = 0.5;
    EXPECT_THROW(tracePlane(h, planeOptions), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
