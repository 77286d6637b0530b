// SPDX-License-Identifier: BSD-3-Clause
// The curves of the paper's three cases, in the printed form and in its plane.
#include <cmath>

#include <gtest/gtest.h>

#include "PaperCases.h"
#include "kernel/CurveTracker.h"
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

TrackerOptions plane(const PaperRecipe &recipe)
{
    TrackerOptions options;
    options.window = recipe.window;
    return options;
}

// Table 4 of the paper.
TEST(PaperCurve, Case1TakesThePrinted146Hyperspheres)
{
    const PaperRecipe recipe = paperRecipe(1);
    const Trace trace = traceSpheres(recipe.full, spheres(recipe));
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(trace.steps, 146);
    EXPECT_LE(largestJointStep(trace), 0.03);  // Fig. 12
}

TEST(PaperCurve, Case2TakesThePrinted323HyperspheresBeyondLambdaOne)
{
    const PaperRecipe recipe = paperRecipe(2);
    const Trace trace = traceSpheres(recipe.full, spheres(recipe));
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(trace.steps, 323);
    EXPECT_EQ(trace.wrongRoots, 2);
    EXPECT_LE(largestJointStep(trace), 0.03);  // Fig. 17
}

TEST(PaperCurve, Case2StoppedAtTheFirstLambdaOneIsAWrongRoot)
{
    PaperRecipe recipe = paperRecipe(2);
    recipe.window.lambdaMax = 1.0;
    EXPECT_EQ(traceSpheres(recipe.full, spheres(recipe)).status, TraceStatus::WrongRoot);
    EXPECT_EQ(traceSpheres(recipe.full, spheres(recipe)).steps, 219);
    EXPECT_EQ(track(recipe.slice, plane(recipe)).status, TraceStatus::WrongRoot);
}

TEST(PaperCurve, Case3IsReachedByTheRecipeAndNotByThePrintedRepulsions)
{
    const PaperRecipe recipe = paperRecipe(3);
    const Trace full = traceSpheres(recipe.full, spheres(recipe));
    EXPECT_EQ(full.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(full.steps, 966);
    EXPECT_LE(largestJointStep(full), 0.02);  // Fig. 21
    EXPECT_EQ(track(recipe.slice, plane(recipe)).status, TraceStatus::ReachedGoal);

    const PaperRecipe printed = paperRecipe(3, {1e-7, -1.2, 450.0, 60.0, -0.0001, 10.0, -63.0});
    EXPECT_EQ(traceSpheres(printed.full, spheres(printed)).status, TraceStatus::WrongRoot);
    EXPECT_EQ(track(printed.slice, plane(printed)).status, TraceStatus::WrongRoot);
}

TEST(PaperCurve, LeavingCase3TowardsLargerLambdaTurnsBack)
{
    PaperRecipe recipe = paperRecipe(3);
    recipe.window.decreasing = false;
    EXPECT_EQ(traceSpheres(recipe.full, spheres(recipe)).status, TraceStatus::TurnedBack);
    EXPECT_EQ(track(recipe.slice, plane(recipe)).status, TraceStatus::TurnedBack);
}

TEST(PaperCurve, BothFormsGiveTheSameCurve)
{
    for (const int number : {1, 2})
    {
        const PaperRecipe recipe = paperRecipe(number);
        const Trace full = traceSpheres(recipe.full, spheres(recipe));
        TrackerOptions options = plane(recipe);
        options.maxStep = 5e-4;  // so that the chords of the polyline stay within 1e-7 of the curve
        options.maxSteps = 100000;
        const Trace fine = track(recipe.slice, options);
        ASSERT_EQ(fine.status, TraceStatus::ReachedGoal);
        for (std::size_t i = 0; i < full.configurations.size(); ++i)
            ASSERT_LE(distanceTo(fine, full.configurations[i]), 1e-6) << "case " << number << ", sphere " << i;
    }
}

/// Newton's estimate of how far the points of a trace of the slice lie off the curve.
double farthestOff(const SliceHomotopy &slice, const Trace &trace)
{
    CurvePoint point;
    double farthest = 0.0;
    for (std::size_t i = 0; i < trace.configurations.size(); ++i)
    {
        const VectorXd offset = trace.configurations[i] - slice.start() - trace.lambdas[i] * slice.difference();
        point.z = Eigen::Vector2d(offset.dot(slice.directions().col(0)), trace.lambdas[i] * slice.lambdaScale());
        slice.evaluate(point);
        farthest = std::max(farthest, std::abs(point.residual[0]) / point.jacobian.norm());
    }
    return farthest;
}

TEST(PaperCurve, PointsOfThePlaneFormLieOnTheCurve)
{
    for (const int number : {1, 2, 3})
    {
        const PaperRecipe recipe = paperRecipe(number);
        TrackerOptions options = plane(recipe);
        EXPECT_LE(farthestOff(recipe.slice, track(recipe.slice, options)), 1e-4) << "case " << number;
        options.tolerance = 1e-5;
        EXPECT_LE(farthestOff(recipe.slice, track(recipe.slice, options)), 1e-9) << "case " << number;
    }
}

TEST(PaperCurve, TheFullCurveLiesInThePlane)
{
    const PaperRecipe recipe = paperRecipe(2);
    const SliceHomotopy &slice = recipe.slice;
    const VectorXd direction = slice.directions().col(0);
    const Trace full = traceSpheres(recipe.full, spheres(recipe));
    for (std::size_t i = 0; i < full.configurations.size(); ++i)
    {
        const VectorXd offset = full.configurations[i] - slice.start() - full.lambdas[i] * slice.difference();
        EXPECT_LE((offset - offset.dot(direction) * direction).norm(), 1e-9) << "sphere " << i;
    }
}

TEST(PaperCurve, TheAdaptiveTrackerFollowsTheFullFormToo)
{
    for (const int number : {1, 2, 3})
    {
        const PaperRecipe recipe = paperRecipe(number);
        const Trace full = track(recipe.full, plane(recipe));
        const Trace slice = track(recipe.slice, plane(recipe));
        EXPECT_EQ(full.status, TraceStatus::ReachedGoal) << "case " << number;
        EXPECT_EQ(full.wrongRoots, slice.wrongRoots) << "case " << number;
        EXPECT_EQ(full.folds, slice.folds) << "case " << number;
    }
}

TEST(PaperCurve, RowsAndDirectionAreTwoWaysToTheSameHomotopy)
{
    const PaperRecipe recipe = paperRecipe(1);
    const SliceHomotopy &slice = recipe.slice;
    const Eigen::MatrixXd rows = rowsOfSlice(slice.directions().col(0), slice.couplings()[0]);
    const Scenario scenario = paperCase(1);
    const auto poles = std::make_shared<PointRepulsion>(*scenario.planar().model, std::vector<double>{-0.1, 0.1}, 5);
    const Trace full = traceSpheres(FullHomotopy(poles, slice.start(), slice.goal(), rows), spheres(recipe));
    EXPECT_EQ(full.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(full.steps, 146);
}

// Thin poles of one sign: the curve keeps within 1e-6 of the walls on its way to another root. The tracker once got
// lost there, because the error that a long step leaves is long for the short one after it.
TEST(PaperCurve, AThinPoleIsFollowedAlongTheWall)
{
    for (const double repulsion : {1e-6, 1e-7, 1e-8})
    {
        const PaperRecipe recipe = paperRecipe(1, {repulsion, repulsion});
        const Trace trace = track(recipe.slice);
        EXPECT_EQ(trace.status, TraceStatus::WrongRoot) << repulsion;
        TrackerOptions fine;
        fine.maxStep = 0.01;
        fine.tolerance = 1e-4;
        const Trace truth = track(recipe.slice, fine);
        EXPECT_EQ(truth.status, TraceStatus::WrongRoot) << repulsion;
        EXPECT_LE((trace.configurations.back() - truth.configurations.back()).norm(), 5e-3) << repulsion;
    }
}

TEST(Trackers, StopWhenAsked)
{
    const PaperRecipe recipe = paperRecipe(1);
    const auto now = []()
    {
        return true;
    };
    EXPECT_EQ(traceSpheres(recipe.full, spheres(recipe), now).status, TraceStatus::Interrupted);
    EXPECT_EQ(track(recipe.slice, plane(recipe), now).status, TraceStatus::Interrupted);
    SphereOptions few = spheres(recipe);
    few.maxSpheres = 10;
    EXPECT_EQ(traceSpheres(recipe.full, few).status, TraceStatus::MaxSteps);
    TrackerOptions fewSteps = plane(recipe);
    fewSteps.maxSteps = 5;
    EXPECT_EQ(track(recipe.slice, fewSteps).status, TraceStatus::MaxSteps);
}

TEST(Trackers, StandStillWhenTheGoalIsTheStart)
{
    const Scenario scenario = paperCase(1);
    const auto poles = std::make_shared<PointRepulsion>(*scenario.planar().model, std::vector<double>{-0.1, 0.1}, 5);
    const VectorXd &start = scenario.planar().task.start;
    const Eigen::MatrixXd rows = Eigen::MatrixXd::Identity(3, 3);
    for (const Trace &trace :
         {track(SliceHomotopy::fromRows(poles, start, start, rows)), track(FullHomotopy(poles, start, start, rows)),
          traceSpheres(FullHomotopy(poles, start, start, rows))})
    {
        EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
        EXPECT_EQ(trace.configurations, std::vector<VectorXd>{start});
    }
}

TEST(Trackers, TooStrongRepulsionTurnsTheCurveBack)
{
    // With 20 points per link instead of 5, n P is so large that dPhi/ds changes its sign near the start.
    const PaperRecipe recipe = paperRecipe(1, {}, 20);
    EXPECT_EQ(traceSpheres(recipe.full, spheres(recipe)).status, TraceStatus::TurnedBack);
    EXPECT_EQ(track(recipe.slice, plane(recipe)).status, TraceStatus::TurnedBack);
}

TEST(Trackers, SpheresRefuseOptionsOutOfRange)
{
    const PaperRecipe recipe = paperRecipe(1);
    SphereOptions options;
    options.radius = 0.0;
    EXPECT_THROW(traceSpheres(recipe.full, options), std::invalid_argument);
    options = {};
    options.maxSpheres = 0;
    EXPECT_THROW(traceSpheres(recipe.full, options), std::invalid_argument);
    options = {};
    options.window.lambdaMin = 0.0;
    EXPECT_THROW(traceSpheres(recipe.full, options), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
