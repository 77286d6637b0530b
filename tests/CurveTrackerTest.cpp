// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/CurveTracker.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "KnownCurves.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

const double pi = std::acos(-1.0);

TrackerOptions wide()
{
    TrackerOptions options;
    options.window.lambdaMin = -3.0;
    options.window.lambdaMax = 3.0;
    return options;
}

double length(const Trace &trace)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < trace.configurations.size(); ++i)
        sum += (trace.configurations[i] - trace.configurations[i - 1]).norm();
    return sum;
}

/// A wave that turns round in lambda at each of its crests: 4 folds on the way from s = 0 to s = 1.
KnownCurve wave()
{
    return graph(
        1.0, [](double s) { return s + 0.3 * std::sin(4.0 * pi * s); },
        [](double s) { return 1.0 + 1.2 * pi * std::cos(4.0 * pi * s); });
}

TEST(CurveTracker, FollowsAStraightLineInFewSteps)
{
    const Trace trace = track(graph(
        2.0, [](double s) { return 0.5 * s; }, [](double) { return 0.5; }));
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    // 0.02, 0.04, ... until 0.35 is the longest; sqrt(5) in all.
    EXPECT_EQ(trace.steps, 10);
    EXPECT_EQ(trace.rejected, 0);
    EXPECT_NEAR(length(trace), std::sqrt(5.0), 1e-12);
}

TEST(CurveTracker, FoldsDoNotReverseTheDirection)
{
    const Trace trace = track(wave(), wide());
    ASSERT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(trace.folds, 4);
    EXPECT_EQ(trace.wrongRoots, 0);  // the highest crest stays below 1
    for (std::size_t i = 1; i < trace.configurations.size(); ++i)
    {
        const double s = trace.configurations[i][0];
        EXPECT_GT(s, trace.configurations[i - 1][0]);
        EXPECT_NEAR(trace.lambdas[i], s + 0.3 * std::sin(4.0 * pi * s), 2e-5);
    }
}

TEST(CurveTracker, AClosedCurveThroughTheStartIsALoop)
{
    // A circle of radius 1/2 about (1/2, 0); the goal lies elsewhere.
    const KnownCurve circle =
        levelLine(0.0, 0.0,
                  [](double s, double lambda) {
                      return Level{(s - 0.5) * (s - 0.5) + lambda * lambda - 0.25, 2.0 * (s - 0.5), 2.0 * lambda};
                  });
    const Trace trace = track(circle, wide());
    EXPECT_EQ(trace.status, TraceStatus::ClosedLoop);
    EXPECT_NEAR(length(trace), pi, 0.15);  // chords, and up to a step beyond the start
    EXPECT_EQ(trace.folds, 2);
}

/// m turns of a helix about the axis of lambda; its ends lie on the same line.
KnownCurve helix(double m)
{
    return KnownCurve(Vector3d::Zero(), Vector3d(0.0, 0.0, 1.0),
                      [m](CurvePoint &point)
                      {
                          const double angle = 2.0 * pi * m * point.z[2];
                          point.residual << point.z[0] - std::cos(angle) + 1.0, point.z[1] - std::sin(angle);
                          point.jacobian << 1.0, 0.0, 2.0 * pi * m * std::sin(angle),  //
                              0.0, 1.0, -2.0 * pi * m * std::cos(angle);
                      });
}

TEST(CurveTracker, AHelixThatComesBackNearItsStartIsNoLoop)
{
    for (const double m : {1.0, 20.0, 100.0})
    {
        const Trace trace = track(helix(m));
        EXPECT_EQ(trace.status, TraceStatus::ReachedGoal) << m << " turns";
        // Chords of at most 0.35 of a circle of radius 1 are at most 0.6 % shorter than it.
        EXPECT_NEAR(length(trace), std::hypot(2.0 * pi * m, 1.0), 0.006 * 2.0 * pi * m) << m << " turns";
    }
}

// Two branches that nearly meet at (0, 1/2): which way the curve goes there is decided by the sign of a tiny number.
TEST(CurveTracker, StaysOnItsBranchWhereTwoNearlyMeet)
{
    for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
        for (const double sign : {1.0, -1.0})
        {
            const double end = std::sqrt(0.25 + sign * gap * gap);
            const KnownCurve hyperbola =
                levelLine(end, end,
                          [=](double s, double lambda)
                          {
                              const double l = lambda - 0.5;
                              return Level{s * s - l * l - sign * gap * gap, 2.0 * s, -2.0 * l};
                          });
            const Trace trace = track(hyperbola, wide());
            if (sign > 0.0)
                EXPECT_EQ(trace.status, TraceStatus::ReachedGoal) << gap;
            else
                EXPECT_EQ(trace.status, TraceStatus::TurnedBack) << gap;
            for (const VectorXd &z : trace.configurations)
                ASSERT_GT(sign > 0.0 ? z[0] : 0.5 - z[1], 0.0) << gap;
        }
}

/// The line s = 0 and a circle beside it, at a distance of `gap`.
KnownCurve lineAndIsola(double gap)
{
    const double radius = 0.3;
    return levelLine(0.0, 0.0,
                     [=](double s, double lambda)
                     {
                         const double x = s - radius - gap, y = lambda - 0.5;
                         const double circle = x * x + y * y - radius * radius;
                         return Level{s * circle, circle + 2.0 * s * x, 2.0 * s * y};
                     });
}

TEST(CurveTracker, PassesAnIsolaWithoutBeingCaught)
{
    for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4})
    {
        const Trace trace = track(lineAndIsola(gap), wide());
        EXPECT_EQ(trace.status, TraceStatus::ReachedGoal) << gap;
        for (const VectorXd &z : trace.configurations)
            ASSERT_LE(std::abs(z[0]), 0.1 * gap) << gap;
    }
}

TEST(CurveTracker, TheDeterminantLimitSeesAnIsolaThatTheTangentDoesNot)
{
    TrackerOptions options = wide();
    const Trace trace = track(lineAndIsola(1e-4), options);
    options.maxDeterminantRatio = 1.5;
    const Trace careful = track(lineAndIsola(1e-4), options);
    EXPECT_EQ(careful.status, TraceStatus::ReachedGoal);
    EXPECT_GT(careful.rejectedBy[static_cast<int>(StepLimit::Determinant)], 0);
    EXPECT_GT(careful.steps, trace.steps);
}

// The augmented determinant changes its sign where two branches cross: there is no way to go on that is right.
KnownCurve crossing()
{
    return levelLine(0.0, 0.0,
                     [](double s, double lambda) {
                         return Level{s * (s - lambda + 0.503), 2.0 * s - lambda + 0.503, -s};
                     });
}

TEST(CurveTracker, ACrossingOfTwoBranchesEndsTheTrace)
{
    const Trace trace = track(crossing(), wide());
    EXPECT_EQ(trace.status, TraceStatus::StepUnderflow);
    EXPECT_NEAR(trace.lambdas.back(), 0.503, 1e-6);
    EXPECT_TRUE(trace.lastRejection.has_value());
}

// Where a curve ends in a crossing, steps shorter than a share of the way to the nearer end are not worth trying.
TEST(CurveTracker, AnEndShareGivesUpACrossingSooner)
{
    const Trace patient = track(crossing(), wide());
    TrackerOptions options = wide();
    options.endShare = 3e-3;
    const Trace brisk = track(crossing(), options);
    EXPECT_EQ(brisk.status, TraceStatus::StepUnderflow);
    EXPECT_NEAR(brisk.lambdas.back(), 0.503, 3e-3);
    EXPECT_LT(2 * brisk.rejected, patient.rejected);
}

// Branches s = f(lambda) + k gap for every integer k; neighbours run in opposite directions. Nothing near a point tells
// the branch after next from its own: steps must not be much longer than the gap.
TEST(CurveTracker, DoesNotJumpBetweenBranchesAQuarterOfAStepApart)
{
    for (const double gap : {1e-1, 1e-2, 1e-3})
    {
        const KnownCurve bundle =
            levelLine(0.0, 0.0,
                      [=](double s, double lambda)
                      {
                          const double f = 0.5 * std::sin(2.0 * pi * lambda);
                          const double x = pi / gap * (s - f);
                          const double slope = pi / gap * std::cos(x);
                          return Level{std::sin(x), slope, -slope * pi * std::cos(2.0 * pi * lambda)};
                      });
        TrackerOptions options;
        options.maxStep = std::min(4.0 * gap, options.maxStep);
        const Trace trace = track(bundle, options);
        EXPECT_EQ(trace.status, TraceStatus::ReachedGoal) << gap;
        for (const VectorXd &z : trace.configurations)
            ASSERT_NEAR(z[0], 0.5 * std::sin(2.0 * pi * z[1]), 0.05 * gap) << gap;
    }
}

// The paper's loop ends at lambda = 1, but other solutions than the goal lie there too (case 2 passes two of them).
TEST(CurveTracker, TheGoalMayBeTheThirdRootAtLambdaOne)
{
    const double k = 1.0 / 0.18;
    const KnownCurve curve = graph(
        1.0, [=](double s) { return 1.0 + k * (s - 0.3) * (s - 0.6) * (s - 1.0); },
        [=](double s) { return k * ((s - 0.6) * (s - 1.0) + (s - 0.3) * (s - 1.0) + (s - 0.3) * (s - 0.6)); });
    const Trace first = track(curve);
    EXPECT_EQ(first.status, TraceStatus::WrongRoot);
    EXPECT_EQ(first.wrongRoots, 1);
    const Trace trace = track(curve, wide());
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(trace.wrongRoots, 2);
    EXPECT_EQ(trace.lambdas.back(), 1.0);
    EXPECT_EQ(trace.configurations.back(), VectorXd(Vector2d(1.0, 1.0)));
}

// lambda rises above 1 by no more than height and falls again: both ends of a step may lie below.
TEST(CurveTracker, AGoalBesideAFoldIsNotOverlooked)
{
    for (const double beyond : {0.3, 0.03, 1e-3, 1e-5, 0.0})
        for (const double maxStep : {0.35, 0.1, 0.03})
        {
            const KnownCurve curve = graph(
                1.0, [=](double s) { return 1.0 - (s - 1.0) * (s - 1.0 - beyond) / (1.0 + beyond); },
                [=](double s) { return -(2.0 * s - 2.0 - beyond) / (1.0 + beyond); });
            TrackerOptions options = wide();
            options.maxStep = maxStep;
            EXPECT_EQ(track(curve, options).status, TraceStatus::ReachedGoal) << beyond << ", step " << maxStep;
        }
}

TEST(CurveTracker, ARootBesideTheGoalIsNotTheGoal)
{
    for (const double gap : {1e-1, 1e-2, 1e-3})
    {
        // Parallel lines, the goal on the neighbour of the one that the start lies on.
        const KnownCurve lines = levelLine(gap - 2.0, 0.0,
                                           [=](double s, double lambda)
                                           {
                                               const double x = pi / gap * (s - 2.0 * (lambda - 1.0));
                                               const double slope = pi / gap * std::cos(x);
                                               return Level{std::sin(x), slope, -2.0 * slope};
                                           });
        const Trace trace = track(lines);
        EXPECT_EQ(trace.status, TraceStatus::WrongRoot) << gap;
        EXPECT_EQ(trace.wrongRoots, 1) << gap;
    }
}

// Case 3 must be left towards smaller lambda.
TEST(CurveTracker, LeavesTheStartTheWayItIsTold)
{
    const double goal = 0.25 + std::sqrt(0.0625 + 1.0);
    const KnownCurve parabola = graph(
        goal, [](double s) { return s * (s - 0.5); }, [](double s) { return 2.0 * s - 0.5; });
    TrackerOptions options;
    EXPECT_EQ(track(parabola, options).status, TraceStatus::WrongRoot);
    options.window.decreasing = true;
    const Trace trace = track(parabola, options);
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_EQ(trace.folds, 1);
    options.window.lambdaMin = -0.05;
    EXPECT_EQ(track(parabola, options).status, TraceStatus::TurnedBack);
}

TEST(CurveTracker, ACurveThatNeverArrivesEscapes)
{
    const KnownCurve flat = graph(
        60.0, [](double s) { return std::tanh(s); }, [](double s) { return 1.0 / (std::cosh(s) * std::cosh(s)); });
    EXPECT_EQ(track(flat, wide()).status, TraceStatus::Escaped);
}

TEST(CurveTracker, TheSameCurveInMoreDimensionsTakesTheSameSteps)
{
    const KnownCurve flat = wave();
    // A third unknown that a linear equation keeps at 0.
    const KnownCurve spatial(Vector3d::Zero(), Vector3d(1.0, 0.0, 1.0),
                             [&](CurvePoint &point)
                             {
                                 CurvePoint plane;
                                 plane.z = Vector2d(point.z[0], point.z[2]);
                                 flat.evaluate(plane);
                                 point.residual << plane.residual[0], 3.0 * point.z[1];
                                 point.jacobian << plane.jacobian(0, 0), 0.0, plane.jacobian(0, 1),  //
                                     0.0, 3.0, 0.0;
                             });
    const VectorXd start = VectorXd::Zero(5);
    VectorXd goal = start;
    goal[0] = goal[4] = 1.0;
    const KnownCurve high(start, goal,
                          [&](CurvePoint &point)
                          {
                              CurvePoint plane;
                              plane.z = Vector2d(point.z[0], point.z[4]);
                              flat.evaluate(plane);
                              point.residual << plane.residual[0], point.z[1], -2.0 * point.z[2], point.z[3];
                              point.jacobian.setZero();
                              point.jacobian(0, 0) = plane.jacobian(0, 0);
                              point.jacobian(0, 4) = plane.jacobian(0, 1);
                              point.jacobian(1, 1) = point.jacobian(3, 3) = 1.0;
                              point.jacobian(2, 2) = -2.0;
                          });
    const Trace a = track(flat, wide()), b = track(spatial, wide()), c = track(high, wide());
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.steps, c.steps);
    EXPECT_EQ(a.evaluations, b.evaluations);
    EXPECT_EQ(a.evaluations, c.evaluations);
    EXPECT_EQ(c.status, TraceStatus::ReachedGoal);
}

TEST(CurveTracker, SmallerStepsAndTolerancesGiveTheSameCurve)
{
    TrackerOptions fine = wide();
    fine.maxStep = 0.01;
    fine.tolerance = 1e-6;
    const Trace trace = track(wave(), fine);
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    for (std::size_t i = 0; i < trace.configurations.size(); ++i)
    {
        const double s = trace.configurations[i][0];
        EXPECT_NEAR(trace.lambdas[i], s + 0.3 * std::sin(4.0 * pi * s), 1e-10);
    }
}

TEST(CurveTracker, CountsAndLogsEveryStep)
{
    TrackerOptions options = wide();
    options.log = true;
    options.firstStep = options.maxStep = 1.0;
    const Trace trace = track(wave(), options);
    ASSERT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_GT(trace.rejected, 0);
    EXPECT_EQ(std::accumulate(trace.limitedBy.begin(), trace.limitedBy.end(), 0), trace.steps);
    EXPECT_EQ(std::accumulate(trace.rejectedBy.begin(), trace.rejectedBy.end(), 0), trace.rejected);
    ASSERT_EQ(static_cast<int>(trace.log.size()), trace.steps + trace.rejected);
    std::size_t accepted = 0;
    for (const TraceStep &step : trace.log)
    {
        EXPECT_GT(step.corrections, 0);
        if (!step.accepted)
            continue;
        ++accepted;
        EXPECT_EQ(step.z, trace.configurations[accepted]);
    }
    EXPECT_EQ(accepted + 1, trace.configurations.size());
    EXPECT_TRUE(track(wave(), wide()).log.empty());
}

TEST(CurveTracker, AGuardShortensChords)
{
    // A circle about the origin, which no chord may come nearer than 0.995.
    const KnownCurve circle = levelLine(-1.0, 0.0,
                                        [](double s, double lambda) {
                                            return Level{s * s + lambda * lambda - 1.0, 2.0 * s, 2.0 * lambda};
                                        });
    TrackerOptions options = wide();
    options.guard = [](const VectorXd &from, const VectorXd &to)
    {
        return (0.5 * (from + to)).norm() > 0.995;
    };
    const Trace trace = track(circle, options);
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_GT(trace.rejectedBy[static_cast<int>(StepLimit::Guard)], 0);
    for (std::size_t i = 1; i < trace.configurations.size(); ++i)
        EXPECT_GT((0.5 * (trace.configurations[i - 1] + trace.configurations[i])).norm(), 0.995);

    options.guard = [](const VectorXd &, const VectorXd &to)
    {
        return to[1] < 0.5;
    };
    const Trace stopped = track(circle, options);
    EXPECT_EQ(stopped.status, TraceStatus::StepUnderflow);
    EXPECT_EQ(stopped.lastRejection, StepLimit::Guard);
    EXPECT_NEAR(stopped.lambdas.back(), 0.5, 1e-6);
}

TEST(CurveTracker, AStartOnOrBeyondAPoleIsInvalid)
{
    for (const double pole : {0.0, -1.0, std::nan("")})
    {
        const KnownCurve line(Vector2d::Zero(), Vector2d(0.0, 1.0),
                              [=](CurvePoint &point)
                              {
                                  point.residual[0] = point.z[0];
                                  point.jacobian << 1.0, 0.0;
                                  point.poles = {1.0, pole};
                              });
        EXPECT_EQ(track(line).status, TraceStatus::InvalidStart) << pole;
    }
}

TEST(CurveTracker, AStartWithoutDirectionIsSingular)
{
    const KnownCurve nothing = levelLine(0.0, 0.0, [](double, double) { return Level{0.0, 0.0, 0.0}; });
    EXPECT_EQ(track(nothing).status, TraceStatus::Singular);
}

TEST(CurveTracker, StopsWhenAskedAndWhenItHasTriedEnough)
{
    EXPECT_EQ(track(wave(), wide(), [] { return true; }).status, TraceStatus::Interrupted);
    TrackerOptions options = wide();
    options.maxSteps = 5;
    const Trace trace = track(wave(), options);
    EXPECT_EQ(trace.status, TraceStatus::MaxSteps);
    EXPECT_EQ(trace.steps + trace.rejected, 5);
}

TEST(CurveTracker, RefusesOptionsOutOfRange)
{
    const auto refuses = [](double TrackerOptions::*option, double value)
    {
        TrackerOptions options;
        options.*option = value;
        EXPECT_THROW(track(wave(), options), std::invalid_argument) << value;
    };
    refuses(&TrackerOptions::contraction, 1.0);
    refuses(&TrackerOptions::tolerance, 0.0);
    refuses(&TrackerOptions::poleShrink, 1.0);
    refuses(&TrackerOptions::firstStep, 0.0);
    refuses(&TrackerOptions::minStep, 0.0);
    refuses(&TrackerOptions::maxStep, 1e-12);
    refuses(&TrackerOptions::maxTurn, 0.0);
    refuses(&TrackerOptions::maxCorrection, std::nan(""));
    refuses(&TrackerOptions::maxDeterminantRatio, 1.0);
    refuses(&TrackerOptions::endShare, 1.0);
    TrackerOptions options;
    options.window.lambdaMax = 0.5;
    EXPECT_THROW(track(wave(), options), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
