// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SliceHomotopy.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "kernel/CurveTracker.h"
#include "kernel/FullHomotopy.h"

namespace narrows
{
namespace
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A point among balls, in as many dimensions as their centers have: P / (|q - c|^2 - r^2) for each.
struct Ball
{
    VectorXd center;
    double radius, strength;
};

class PointAmongBalls : public Repulsion
{
public:
    explicit PointAmongBalls(std::vector<Ball> balls) : balls_(std::move(balls)) {}

    int dimension() const override { return static_cast<int>(balls_.front().center.size()); }
    void evaluate(const Eigen::Ref<const VectorXd> &q, Sample &sample) const override
    {
        sample.value = 0.0;
        sample.gradient = VectorXd::Zero(q.size());
        sample.poles.clear();
        for (const Ball &ball : balls_)
        {
            const VectorXd offset = q - ball.center;
            const double pole = offset.squaredNorm() - ball.radius * ball.radius;
            sample.poles.push_back(pole);
            sample.value += ball.strength / pole;
            sample.gradient -= 2.0 * ball.strength / (pole * pole) * offset;
        }
    }
    double value(const Eigen::Ref<const VectorXd> &q) const override
    {
        Sample sample;
        evaluate(q, sample);
        return sample.value;
    }
    /// Least distance of the straight way between two points to a ball.
    double clearance(const VectorXd &from, const VectorXd &to) const
    {
        double least = 1e9;
        for (const Ball &ball : balls_)
        {
            const VectorXd along = to - from;
            const double part = std::clamp(along.dot(ball.center - from) / along.squaredNorm(), 0.0, 1.0);
            least = std::min(least, (from + part * along - ball.center).norm() - ball.radius);
        }
        return least;
    }

private:
    std::vector<Ball> balls_;
};

VectorXd vector(std::initializer_list<double> numbers)
{
    return Eigen::Map<const VectorXd>(numbers.begin(), static_cast<Eigen::Index>(numbers.size()));
}

using Balls = std::shared_ptr<const PointAmongBalls>;

Balls balls(std::vector<Ball> list)
{
    return std::make_shared<PointAmongBalls>(std::move(list));
}

SliceHomotopy acrossThePlane(const Balls &repulsion)
{
    return SliceHomotopy({repulsion}, vector({-1, 0}), vector({1, 0}), vector({0, 1}), vector({1}));
}

double least(const Balls &repulsion, const Trace &trace)
{
    double clearance = 1e9;
    for (std::size_t i = 1; i < trace.configurations.size(); ++i)
        clearance = std::min(clearance, repulsion->clearance(trace.configurations[i - 1], trace.configurations[i]));
    return clearance;
}

TEST(SliceHomotopy, GoesRoundABallInTheWay)
{
    for (const double strength : {0.1, 0.01, 1e-3})
    {
        const Balls ball = balls({{vector({0, 0.05}), 0.3, strength}});
        const Trace trace = track(acrossThePlane(ball));
        EXPECT_EQ(trace.status, TraceStatus::ReachedGoal) << strength;
    }
}

// A pole of strength 1e-7, as the paper has one in case 3, is far thinner than a step.
TEST(SliceHomotopy, DoesNotStepOverAThinPole)
{
    for (const double strength : {1e-3, 1e-5, 1e-7})
    {
        const Balls ball = balls({{vector({0, 0.05}), 0.3, strength}});
        const Trace trace = track(acrossThePlane(ball));
        EXPECT_EQ(trace.status, TraceStatus::ReachedGoal) << strength;
        for (const VectorXd &w : trace.configurations)
            ASSERT_GT(ball->clearance(w, w + 1e-12 * VectorXd::Ones(2)), 0.0) << strength;
        EXPECT_GT(
            trace.rejectedBy[static_cast<int>(StepLimit::Pole)] + trace.limitedBy[static_cast<int>(StepLimit::Pole)],
            0);
    }
}

TEST(SliceHomotopy, AGuardKeepsChordsOutsideWhereTheCurveHugsAWall)
{
    const Balls ball = balls({{vector({0, 0.05}), 0.3, 1e-5}});
    EXPECT_LT(least(ball, track(acrossThePlane(ball))), 0.0);
    TrackerOptions options;
    options.guard = [&](const VectorXd &from, const VectorXd &to)
    {
        return ball->clearance(from, to) > 0.0;
    };
    const Trace trace = track(acrossThePlane(ball), options);
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_GT(least(ball, trace), 0.0);
}

TEST(SliceHomotopy, OppositeSignsLeadBetweenTwoBalls)
{
    for (const double gap : {0.1, 1e-3, 1e-5, 1e-7})
    {
        const double radius = 0.4 - 0.5 * gap;
        const Balls gate = balls({{vector({0.1, 0.4}), radius, 0.01}, {vector({0.1, -0.4}), radius, -0.01}});
        TrackerOptions options;
        options.guard = [&](const VectorXd &from, const VectorXd &to)
        {
            return gate->clearance(from, to) > 0.0;
        };
        const SliceHomotopy curve({gate}, vector({-1, 0.3}), vector({1, 0.2}), vector({0, 1}), vector({1}));
        const Trace trace = track(curve, options);
        EXPECT_EQ(trace.status, TraceStatus::ReachedGoal) << gap;
        EXPECT_LE(trace.steps, 150) << gap;  // only the logarithm of the gap may count
        EXPECT_GT(least(gate, trace), 0.0) << gap;
    }
}

// Where poles of opposite signs overlap they cancel, and the level line leads into both obstacles at once.
TEST(SliceHomotopy, OppositePolesThatOverlapEndTheTrace)
{
    const Balls closed = balls({{vector({0.1, 0.4}), 0.45, 0.1}, {vector({0.1, -0.4}), 0.45, -0.1}});
    const SliceHomotopy curve({closed}, vector({-1, 0.3}), vector({1, 0.2}), vector({0, 1}), vector({1}));
    const Trace trace = track(curve);
    EXPECT_EQ(trace.status, TraceStatus::StepUnderflow);
    for (const VectorXd &w : trace.configurations)
        ASSERT_GT(closed->clearance(w, w + 1e-12 * VectorXd::Ones(2)), -1e-9);
}

TEST(SliceHomotopy, TwoRowsLeadThroughTwoGapsThatOneRowMisses)
{
    // Balls above and below, left and right of the straight way, each pair nearly touching.
    const double gap = 1e-4, radius = 0.4 - 0.5 * gap;
    const Balls upright = balls({{vector({-0.2, 0.4, 0}), radius, 0.01}, {vector({-0.2, -0.4, 0}), radius, -0.01}});
    const Balls level = balls({{vector({0.2, 0, 0.4}), radius, 0.01}, {vector({0.2, 0, -0.4}), radius, -0.01}});
    MatrixXd directions(3, 2);
    directions << 0, 0, 1, 0, 0, 1;
    const SliceHomotopy curve({upright, level}, vector({-1, 0.2, -0.1}), vector({1, -0.1, 0.2}), directions,
                              vector({1, 1}));
    TrackerOptions options;
    options.guard = [&](const VectorXd &from, const VectorXd &to)
    {
        return std::min(upright->clearance(from, to), level->clearance(from, to)) > 0.0;
    };
    const Trace trace = track(curve, options);
    EXPECT_EQ(trace.status, TraceStatus::ReachedGoal);
    EXPECT_GT(std::min(least(upright, trace), least(level, trace)), 0.0);
}

/// A homotopy with as many rows as there are repulsions, between random ends.
SliceHomotopy randomSlice(std::mt19937_64 &generator, int joints, int rows)
{
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto random = [&](int n)
    {
        return VectorXd(VectorXd::NullaryExpr(n, [&] { return number(generator); }));
    };
    std::vector<std::shared_ptr<const Repulsion>> repulsions;
    for (int i = 0; i < rows; ++i)
        repulsions.push_back(balls({{4.0 * random(joints), 0.2, 0.5}, {4.0 * random(joints), 0.2, -0.3}}));
    return SliceHomotopy(repulsions, random(joints), random(joints),
                         MatrixXd::NullaryExpr(joints, rows, [&] { return number(generator); }),
                         VectorXd::Constant(rows, 0.7));
}

void expectJacobian(const HomotopyCurve &curve, const VectorXd &z)
{
    CurvePoint point, above, below;
    point.z = z;
    curve.evaluate(point);
    for (Eigen::Index j = 0; j < z.size(); ++j)
    {
        above.z = below.z = z;
        above.z[j] += 1e-6;
        below.z[j] -= 1e-6;
        curve.evaluate(above);
        curve.evaluate(below);
        const VectorXd column = (above.residual - below.residual) / 2e-6;
        EXPECT_LE((column - point.jacobian.col(j)).norm(), 1e-6 * std::max(1.0, column.norm())) << "unknown " << j;
    }
}

TEST(SliceHomotopy, JacobiansAgreeWithDifferences)
{
    std::mt19937_64 generator(3);
    for (const int rows : {1, 2, 3})
    {
        const SliceHomotopy curve = randomSlice(generator, 4, rows);
        expectJacobian(curve, 0.3 * curve.goalPoint() + 0.1 * VectorXd::Ones(rows + 1));
    }
    const Balls repulsion = balls({{vector({0.2, 0.1, 3.0}), 0.3, 0.4}});
    const FullHomotopy full(repulsion, vector({0, 0, 0}), vector({1, 1, 1}), MatrixXd::Random(3, 3));
    expectJacobian(full, vector({0.1, 0.7, 0.2, 0.4}));
}

TEST(SliceHomotopy, AScheduleKeepsTheEndsAndBendsTheWay)
{
    JointSchedule schedule;
    schedule.held = {-1, 1, 0};
    schedule.share = 0.4;
    const Balls repulsion = balls({{vector({0.2, 0.1, 3.0}), 0.3, 0.4}});
    const VectorXd start = vector({0, 0, 0}), goal = vector({1, 1, 1});
    const SliceHomotopy curve({repulsion}, start, goal, vector({0, 1, -1}), vector({1}), schedule);
    VectorXd w;
    curve.configuration(curve.startPoint(), w);
    EXPECT_LE((w - start).norm(), 1e-15);
    curve.configuration(curve.goalPoint(), w);
    EXPECT_LE((w - goal).norm(), 1e-15);
    curve.configuration(0.3 * curve.goalPoint(), w);
    EXPECT_EQ(w[0], 0.0);            // still held
    EXPECT_NEAR(w[1], 0.75, 1e-15);  // half of its part of lambda is over: 1 - (1/2)^2
    EXPECT_NEAR(w[2], 0.3, 1e-15);
    for (const double lambda : {0.1, 0.5, 0.7, 0.95})
        expectJacobian(curve, lambda * curve.goalPoint() + 0.1 * VectorXd::Unit(2, 0));
    schedule.share = 1.0;
    EXPECT_THROW(SliceHomotopy({repulsion}, start, goal, vector({0, 1, -1}), vector({1}), schedule),
                 std::invalid_argument);
    schedule = {{1, 0}, 0.4};
    EXPECT_THROW(SliceHomotopy({repulsion}, start, goal, vector({0, 1, -1}), vector({1}), schedule),
                 std::invalid_argument);
}

TEST(SliceHomotopy, StartAndGoalSolveIt)
{
    std::mt19937_64 generator(4);
    const SliceHomotopy slice = randomSlice(generator, 5, 2);
    const FullHomotopy full(balls({{vector({0.2, 0.1, 3.0}), 0.3, 0.4}}), vector({0, 0, 0}), vector({1, 1, 1}),
                            MatrixXd::Identity(3, 3));
    for (const HomotopyCurve *curve :
         {static_cast<const HomotopyCurve *>(&slice), static_cast<const HomotopyCurve *>(&full)})
        for (const VectorXd &z : {curve->startPoint(), curve->goalPoint()})
        {
            CurvePoint point;
            point.z = z;
            curve->evaluate(point);
            EXPECT_LE(point.residual.norm(), 1e-14);
        }
    VectorXd w;
    slice.configuration(slice.goalPoint(), w);
    EXPECT_LE((w - slice.goal()).norm(), 1e-15);
}

TEST(SliceHomotopy, IsTheSliceOfTheFullForm)
{
    // Every solution of the slice solves the printed equations: both residuals vanish together.
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const Balls repulsion = balls({{vector({0.5, 0.2, 0.6}), 0.2, 0.05}});
    const MatrixXd rows = MatrixXd::NullaryExpr(3, 3, [&] { return number(generator); });
    const VectorXd start = vector({-1, 0, 0}), goal = vector({1, 0.5, 0});
    const SliceHomotopy slice = SliceHomotopy::fromRows(repulsion, start, goal, rows);
    const FullHomotopy full(repulsion, start, goal, rows);
    CurvePoint planar, printed;
    for (int trial = 0; trial < 20; ++trial)
    {
        planar.z = Eigen::Vector2d(number(generator), number(generator));
        slice.evaluate(planar);
        printed.z.resize(4);
        printed.z << planar.w, planar.z[1] / slice.lambdaScale();
        full.evaluate(printed);
        EXPECT_LE(printed.residual.head(2).norm(), 1e-14);
        EXPECT_NEAR(printed.residual[2], planar.residual[0], 1e-12 * std::max(1.0, std::abs(planar.residual[0])));
    }
}

TEST(SliceHomotopy, RefusesImpossibleConstants)
{
    const Balls ball = balls({{vector({0, 1}), 0.5, 0.1}});
    const VectorXd start = vector({-1, 0}), goal = vector({1, 0}), up = vector({0, 1}), one = vector({1});
    const auto refused = [&](const std::vector<std::shared_ptr<const Repulsion>> &repulsions, const VectorXd &from,
                             const VectorXd &to, const MatrixXd &directions, const VectorXd &couplings)
    {
        EXPECT_THROW(SliceHomotopy(repulsions, from, to, directions, couplings), std::invalid_argument);
    };
    refused({}, start, goal, MatrixXd(2, 0), VectorXd(0));
    refused({nullptr}, start, goal, up, one);
    refused({ball}, vector({1}), goal, up, one);
    refused({ball}, start, vector({1, std::nan("")}), up, one);
    refused({ball}, start, vector({0, 1.5}), up, one);  // on a pole
    refused({ball}, start, goal, vector({0, 0}), one);
    refused({ball}, start, goal, vector({0, std::nan("")}), one);
    refused({ball}, start, goal, vector({0, 1, 0}), one);
    refused({ball}, start, goal, up, vector({0}));
    refused({ball}, start, goal, up, vector({1, 1}));
    MatrixXd dependent(2, 2);
    dependent << 1, -2, 1, -2;
    refused({ball, ball}, start, goal, dependent, vector({1, 1}));

    const VectorXd from = vector({0, 0, 0}), to = vector({1, 1, 1});
    const Balls spatial = balls({{vector({0, 5, 0}), 0.3, 0.1}});
    MatrixXd rows = MatrixXd::Identity(3, 3);
    rows.row(1) = 2.0 * rows.row(0);
    EXPECT_THROW(SliceHomotopy::fromRows(spatial, from, to, rows), std::invalid_argument);
    EXPECT_THROW(FullHomotopy(spatial, from, to, rows), std::invalid_argument);
    EXPECT_THROW(SliceHomotopy::fromRows(spatial, from, to, rows.topRows(2)), std::invalid_argument);
    EXPECT_THROW(FullHomotopy(spatial, from, to, rows.topRows(2)), std::invalid_argument);
    EXPECT_THROW(rowsOfSlice(vector({0, 0}), 1.0), std::invalid_argument);
}

TEST(SliceHomotopy, RowsOfASliceLeadBackToIt)
{
    const VectorXd direction = vector({3, -4, 12});
    const MatrixXd rows = rowsOfSlice(direction, -0.5);
    const Balls repulsion = balls({{vector({0, 5, 0}), 0.3, 0.1}});
    const SliceHomotopy slice = SliceHomotopy::fromRows(repulsion, vector({0, 0, 0}), vector({1, 1, 1}), rows);
    EXPECT_LE((slice.directions().col(0) - direction / 13.0).norm(), 1e-14);
    EXPECT_NEAR(slice.couplings()[0], -0.5, 1e-14);
}
}  // namespace
}  // namespace narrows
