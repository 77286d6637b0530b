// SPDX-License-Identifier: BSD-3-Clause
// What Threader is built from besides gaps: slices, samples, overlaps, charts of joint space, trees.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>

#include "PaperScenes.h"
#include "kernel/threading/AffineSlice.h"
#include "kernel/threading/DeepestOverlap.h"
#include "kernel/threading/LowDiscrepancy.h"
#include "planners/JointChart.h"
#include "planners/ThreadingTree.h"
#include "planners/TipCells.h"
#include "spaces/PlanarArmStateSpace.h"
#include "validity/ArmChecker.h"

namespace narrows
{
namespace
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd randomVector(std::mt19937 &random, Eigen::Index size, double bound)
{
    std::uniform_real_distribution<double> value(-bound, bound);
    return VectorXd::NullaryExpr(size, [&] { return value(random); });
}

TEST(AffineSlices, HoldStartAndGoalAndAreOrthonormal)
{
    std::mt19937 random(3);
    const VectorXd start = randomVector(random, 20, 3.0), goal = randomVector(random, 20, 3.0);
    const AffineSlices slices = affineSlices(start, goal, cosineModes(20, 5), 5);
    ASSERT_EQ(slices.dimensions(), 5);
    EXPECT_LT((slices.basis.transpose() * slices.basis - MatrixXd::Identity(5, 5)).norm(), 1e-12);
    EXPECT_LT(slices.coordinates(start).norm(), 1e-12);
    const VectorXd place = slices.coordinates(goal);
    EXPECT_NEAR(place[0], (goal - start).norm(), 1e-12);
    EXPECT_LT(place.tail(4).norm(), 1e-12);
    EXPECT_LT((slices.point(place.head(1)) - goal).norm(), 1e-12);
}

TEST(AffineSlices, CosineModesAreOrthogonal)
{
    const MatrixXd modes = cosineModes(7, 7, 1);
    EXPECT_EQ(modes.rows(), 8);
    EXPECT_EQ(modes.row(0).norm(), 0.0);
    const MatrixXd gram = modes.transpose() * modes;
    EXPECT_LT((gram - MatrixXd(gram.diagonal().asDiagonal())).norm(), 1e-12);
    EXPECT_THROW(cosineModes(3, 4), std::invalid_argument);
}

TEST(AffineSlices, DropDirectionsThatAddNothing)
{
    const VectorXd start = VectorXd::Zero(3), goal = VectorXd::Ones(3);  // the first mode's direction
    const AffineSlices slices = affineSlices(start, goal, cosineModes(3, 3), 5);
    EXPECT_EQ(slices.dimensions(), 3);
    EXPECT_EQ(affineSlices(start, start, cosineModes(3, 2), 3).dimensions(), 2);
    EXPECT_THROW(affineSlices(start, VectorXd::Ones(2), cosineModes(3, 2), 3), std::invalid_argument);
}

TEST(LowDiscrepancy, IsTheGoldenRatioInOneDimension)
{
    LowDiscrepancy sequence(VectorXd::Constant(1, 0.25));
    const double step = (std::sqrt(5.0) - 1.0) / 2.0;
    for (int i = 1; i <= 100; ++i)
    {
        const double expected = 0.25 + i * step;
        EXPECT_NEAR(sequence.next()[0], expected - std::floor(expected), 1e-12);
    }
    EXPECT_THROW(LowDiscrepancy(VectorXd::Ones(2)), std::invalid_argument);
    EXPECT_THROW(LowDiscrepancy(VectorXd(0)), std::invalid_argument);
}

TEST(LowDiscrepancy, FillsBoxesMoreEvenlyThanChance)
{
    LowDiscrepancy sequence(VectorXd::Zero(2));
    MatrixXd hits = MatrixXd::Zero(8, 8);
    for (int i = 0; i < 64 * 16; ++i)
    {
        const VectorXd &point = sequence.next();
        hits(static_cast<int>(8 * point[0]), static_cast<int>(8 * point[1])) += 1.0;
    }
    EXPECT_GE(hits.minCoeff(), 13.0);  // 16 on average; of random points some box gets 7
    EXPECT_LE(hits.maxCoeff(), 19.0);
}

class OverlapOfCase : public testing::TestWithParam<int>
{
};

TEST_P(OverlapOfCase, SaysWhatTheCheckerSaysAndHowToGetOut)
{
    const PlanarModel model = paperScene(GetParam()).model;
    const auto checker = makeArmChecker("analytic", model);
    DeepestOverlap overlap(model);
    std::mt19937 random(11);
    int deep = 0;
    VectorXd gradient, unused;
    for (int i = 0; i < 500; ++i)
    {
        const VectorXd q = randomVector(random, model.arm.dimension(), M_PI);
        const double depth = overlap.deepest(q, gradient);
        ASSERT_EQ(depth < 0.0, !checker->isFree(q)) << q.transpose();
        ASSERT_EQ(overlap.isMet(q), depth < 0.0) << q.transpose();
        if (!(depth < 0.0))
            continue;
        ++deep;
        const double step = 1e-7 / gradient.norm();
        EXPECT_GT(overlap.deepest(q + step * gradient, unused), depth);
    }
    EXPECT_GT(deep, 1);
}

// The links up to one, as an arm of their own, are free as long as that is not the first that overlaps.
TEST_P(OverlapOfCase, NamesTheFirstLinkThatOverlaps)
{
    const PlanarModel model = paperScene(GetParam()).model;
    DeepestOverlap overlap(model);
    std::mt19937 random(13);
    std::set<int> named;
    for (int i = 0; i < 500; ++i)
    {
        const VectorXd q = randomVector(random, model.arm.dimension(), M_PI);
        int expected = -1;
        for (int count = 1; count <= model.arm.linkCount() && expected < 0; ++count)
        {
            PlanarModel part = model;
            const auto &links = model.arm.links();
            part.arm = PlanarArm(model.arm.base(), {links.begin(), links.begin() + count}, model.arm.radius());
            expected = DeepestOverlap(part).isMet(q.head(count)) ? count - 1 : -1;
        }
        const int met = overlap.firstMet(q, 0);
        ASSERT_EQ(met, expected) << i;
        named.insert(met);
        EXPECT_EQ(overlap.firstMet(q, std::max(met, 0)), met);
    }
    EXPECT_GE(named.size(), 3u);
}

TEST_P(OverlapOfCase, LooksAtMotionsWhereTheyAreDivided)
{
    const PlanarModel model = paperScene(GetParam()).model;
    DeepestOverlap overlap(model);
    std::mt19937 random(12);
    int met = 0;
    VectorXd unused;
    for (int i = 0; i < 400; ++i)
    {
        // Up to more than a whole turn, where directions half way do not follow from those at the ends.
        const VectorXd q = randomVector(random, model.arm.dimension(), M_PI);
        const VectorXd delta = randomVector(random, model.arm.dimension(), i % 2 == 0 ? 7.0 : 0.7);
        const int parts = 1 << i % 4;
        bool expected = false;
        for (int k = 1; k < parts; ++k)
            expected = expected || overlap.deepest(q + double(k) / parts * delta, unused) < 0.0;
        ASSERT_EQ(overlap.isMetBetween(q, delta, parts), expected) << i;
        met += expected ? 1 : 0;
    }
    EXPECT_GT(met, 2);
    EXPECT_LT(met, 398);
    EXPECT_THROW(overlap.isMetBetween(unused, unused, 3), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(PaperCases, OverlapOfCase, testing::Values(1, 2, 3));

/// A gripper whose joints wrap and whose space counts them relative to each other.
std::shared_ptr<PlanarArmStateSpace> gripperSpace(const JointLimits &limits = {})
{
    const PlanarArm arm({0, 0}, {{1.0, -1}, {1.0, 0}, {1.0, 1}, {0.5, 1}});
    return std::make_shared<PlanarArmStateSpace>(arm, AngleConvention::Relative, FreeJoints::Wrapping, limits);
}

TEST(JointChart, CountsAbsoluteAnglesWhereAllJointsWrap)
{
    auto space = gripperSpace();
    const JointChart chart(*space);
    ompl::base::ScopedState<> state(space);
    const VectorXd x{{3.0, -3.0, 2.0, 9.0}};
    chart.write(x, state->as<ob::RealVectorStateSpace::StateType>()->values);
    EXPECT_TRUE(space->satisfiesBounds(state.get()));
    VectorXd q, way;
    space->toConfiguration(state.get(), q);
    chart.shortWay(x, q, way);
    EXPECT_LT(way.norm(), 1e-12);  // the same up to full turns
    chart.read(state.get(), q);
    chart.shortWay(x, q, way);
    EXPECT_LT(way.norm(), 1e-12);
}

// A way is unambiguous if the space goes it too.
TEST(JointChart, LongWaysAreDivided)
{
    auto space = gripperSpace();
    const JointChart chart(*space);
    ompl::base::ScopedState<> from(space), to(space);
    const VectorXd x = VectorXd::Zero(4), way{{-2.5, 2.5, 0.0, 0.0}};  // the second joint turns by 5
    const double part = chart.unambiguousPart(way);
    EXPECT_LT(part, 1.0);
    for (const double share : {part, 1.0})
    {
        chart.write(x, from->as<ob::RealVectorStateSpace::StateType>()->values);
        chart.write(x + share * way, to->as<ob::RealVectorStateSpace::StateType>()->values);
        VectorXd gone;
        space->displacement(from.get(), to.get(), gone);
        EXPECT_EQ((gone - share * way).norm() < 1e-12, share < 1.0);
    }
}

TEST(JointChart, KeepsTheSpacesOwnValuesWithLimits)
{
    JointLimits limits{AngleConvention::Relative, {std::nullopt, Interval{-1, 1}}};
    auto space = gripperSpace(limits);
    const JointChart chart(*space);
    const VectorXd x{{0.3, 0.5, -0.2, 0.4}};
    VectorXd q;
    chart.toConfiguration(x, q);
    EXPECT_LT((q - VectorXd{{0.3, 0.8, 0.6, 1.2}}).norm(), 1e-12);
    EXPECT_LT((chart.fromConfiguration(q) - x).norm(), 1e-12);
    // f(q) = c . q: its derivative by x is what x times the way changes.
    const VectorXd c{{1.0, 2.0, 3.0, 4.0}}, step{{0.1, -0.2, 0.3, 0.5}};
    VectorXd moved;
    chart.toConfiguration(step, moved);
    EXPECT_NEAR(chart.gradient(c).dot(step), c.dot(moved), 1e-12);
    EXPECT_EQ(chart.lower()[1], -1.0);
    EXPECT_TRUE(std::isinf(chart.periods()[1]));
    VectorXd far{{5.0, 2.0, -5.0, -0.5}};
    chart.enforceLimits(far);
    EXPECT_EQ(far, (VectorXd{{5.0, 1.0, -5.0, -0.5}}));
}

TEST(JointChart, TurnsJointsAgainstTheOnesThatCarryThem)
{
    for (const JointLimits &limits : {JointLimits{}, JointLimits{AngleConvention::Relative, {Interval{-1, 1}}}})
    {
        auto space = gripperSpace(limits);
        const JointChart chart(*space);
        const VectorXd turns{{0.3, 0.5, -0.2, 0.4}};
        VectorXd way, q;
        chart.wayOfTurns(turns, way);
        chart.toConfiguration(way, q);
        EXPECT_LT((q - VectorXd{{0.3, 0.8, 0.6, 1.2}}).norm(), 1e-12);
    }
}

TEST(ThreadingTree, FindsTheNearestAsBruteForceDoes)
{
    std::mt19937 random(5);
    VectorXd periods = VectorXd::Constant(3, 2.0 * M_PI);
    periods[2] = std::numeric_limits<double>::infinity();
    ThreadingTree tree(periods);
    for (int i = 0; i < 200; ++i)
    {
        if (i == 100)  // slices may come when there are nodes already
            tree.reslice(2, [](const VectorXd &x) { return VectorXd(x.head(2)); });
        const VectorXd x = randomVector(random, 3, 8.0);
        const int level = i % 3 + 1;
        tree.add(x, i - 1, level, x.head(2), i % 5 != 0);
    }
    const auto distance = [&](const VectorXd &a, const VectorXd &b)
    {
        VectorXd way = a - b;
        for (int j = 0; j < 2; ++j)
            way[j] = std::remainder(way[j], 2.0 * M_PI);
        return way.norm();
    };
    for (int i = 0; i < 100; ++i)
    {
        const VectorXd x = randomVector(random, 3, 8.0);
        int best = -1, bestInSlice = -1;
        for (int node = 0; node < tree.size(); ++node)
        {
            if (node % 5 == 0)
                continue;
            if (best < 0 || distance(x, tree[node].x) < distance(x, tree[best].x))
                best = node;
            if (tree[node].level <= 2 &&
                (bestInSlice < 0 || (x - tree[node].x).head(2).norm() < (x - tree[bestInSlice].x).head(2).norm()))
                bestInSlice = node;
        }
        EXPECT_EQ(tree.nearest(x), best);
        EXPECT_EQ(tree.nearestInSlice(x.head(2)), bestInSlice);
    }
}

// Two links of length 1: cells have a side of a tenth.
TEST(TipCells, ChooseWhereTheTipHasHardlyBeen)
{
    const PlanarArm arm({0, 0}, {{1.0, -1}, {1.0, 0}});
    auto space =
        std::make_shared<PlanarArmStateSpace>(arm, AngleConvention::Absolute, FreeJoints::Wrapping, JointLimits{});
    space->setup();
    TipCells cells(space->getDefaultProjection());
    ompl::base::ScopedState<> near(space), far(space);
    near = std::vector<double>{0.0, 0.0};
    far = std::vector<double>{1.5, 1.5};
    ompl::RNG random(1);
    for (int i = 0; i < 9; ++i)
        cells.add(near.get());
    cells.add(far.get());
    EXPECT_EQ(cells.size(), 10);
    EXPECT_EQ(cells.at(far.get(), random), 9);
    far = std::vector<double>{3.0, 3.0};
    EXPECT_EQ(cells.at(far.get(), random), -1);
    // Nine nodes weigh as much as nine visits; blame halves what a cell is worth.
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(cells.choose(random), 9) << i;
    for (int i = 0; i < 4; ++i)
        cells.blame();
    EXPECT_LT(cells.choose(random), 9);
}

/// A cell as TipCells' formula sees it, looked up the slow way.
struct CellByHand
{
    Eigen::VectorXi place;
    std::vector<int> nodes = {};
    double score = 1.0, visits = 1.0;
};

int neighbours(const std::vector<CellByHand> &cells, const CellByHand &cell)
{
    return static_cast<int>(std::count_if(cells.begin(), cells.end(), [&](const CellByHand &other)
                                          { return (other.place - cell.place).cwiseAbs().sum() == 1; }));
}

double importance(const std::vector<CellByHand> &cells, const CellByHand &cell)
{
    return cell.score / ((1 + neighbours(cells, cell)) * static_cast<double>(cell.nodes.size()) * cell.visits);
}

/// The cell that matters most among those that have all four neighbours, or among the others; null if there is none.
CellByHand *mostImportant(std::vector<CellByHand> &cells, bool inner)
{
    CellByHand *best = nullptr;
    for (CellByHand &cell : cells)
        if ((neighbours(cells, cell) == 4) == inner &&
            (best == nullptr || importance(cells, cell) > importance(cells, *best) * (1.0 + 1e-9)))
            best = &cell;
    return best;
}

TEST(TipCells, ChooseAsTheFormulaDoesByHand)
{
    const PlanarArm arm({0, 0}, {{1.0, -1}, {1.0, 0}});
    auto space =
        std::make_shared<PlanarArmStateSpace>(arm, AngleConvention::Absolute, FreeJoints::Wrapping, JointLimits{});
    space->setup();
    const auto projection = space->getDefaultProjection();
    TipCells cells(projection);
    std::vector<CellByHand> byHand;
    ompl::RNG random(3);
    ompl::base::ScopedState<> state(space);
    int edge = 0, inner = 0;
    for (int i = 0; i < 600; ++i)
    {
        state = std::vector<double>{random.uniformReal(0.0, 0.5), random.uniformReal(1.0, 2.0)};
        Eigen::VectorXi place(2);
        projection->computeCoordinates(state.get(), place);
        auto cell = std::find_if(byHand.begin(), byHand.end(), [&](const CellByHand &c) { return c.place == place; });
        if (cell == byHand.end())
        {
            byHand.push_back({place});
            byHand.back().score = 1.0 + std::log(1.0 + edge + inner);
            cell = byHand.end() - 1;
        }
        cell->nodes.push_back(cells.size());
        cells.add(state.get());

        const int node = cells.choose(random);
        const auto chosen =
            std::find_if(byHand.begin(), byHand.end(), [&](const CellByHand &c)
                         { return std::find(c.nodes.begin(), c.nodes.end(), node) != c.nodes.end(); });
        ASSERT_NE(chosen, byHand.end());
        const bool isInner = neighbours(byHand, *chosen) == 4;
        ++(isInner ? inner : edge);
        // Cells that matter equally are equally good.
        EXPECT_NEAR(importance(byHand, *chosen), importance(byHand, *mostImportant(byHand, isInner)),
                    1e-9 * importance(byHand, *chosen))
            << i;
        chosen->visits += 1.0;
        if (i % 3 == 0)
        {
            cells.blame();
            chosen->score *= 0.5;
        }
    }
    EXPECT_GT(inner, 20);
    EXPECT_GT(edge, 5 * inner);
}
}  // namespace
}  // namespace narrows
