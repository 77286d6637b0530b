// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/RandomNumbers.h>

#include "kernel/threading/AffineSlice.h"
#include "kernel/threading/CentredStep.h"
#include "kernel/threading/Overlap.h"
#include "planners/JointChart.h"
#include "planners/ThreadingTree.h"
#include "planners/TipCells.h"

namespace narrows
{
/// Two trees, from starts (side 0) and from goals (side 1), that grow towards samples and each other (RRT-Connect), in
/// joint space or in nested slices of it. Where a tree's straight step is blocked and links cross gaps, it goes on
/// along the configurations in which they do so in the middle (CentredStep). Every edge is a motion that the validator
/// has accepted.
class ThreadingSearch
{
public:
    /// How one sample is used.
    struct Stride
    {
        int dimension = 0;  ///< of the slice that is searched; 0: all of joint space
        double range = std::numeric_limits<double>::infinity();  ///< longest edge, > 0
        bool bends = true;  ///< steps that end in an obstacle are bent along it, if obstacles are known
    };

    /// How a blocked step goes on through gaps. The defaults are for use, the rest for ablations.
    struct Centring
    {
        double lengthening = 0.5;  ///< of links at both ends, at most, in sizes of the gap; >= 0
        double square = 0.9;     ///< share of the steps in which all links shall stand square to their gaps, in [0, 1]
        double narrow = 0.75;    ///< share of the steps in which only the narrowest gaps count, in [0, 1]
        bool recentring = true;  ///< where the tangent leaves nothing of the way, go to the middle itself
    };

    /// What the search has done so far.
    struct Counts
    {
        std::uint64_t samples = 0;  ///< calls of grow() and explore()
        std::uint64_t blocked = 0;  ///< straight steps that were not free
        std::uint64_t centred = 0;  ///< centred steps that were
        std::uint64_t refused = 0;  ///< and those that were not
        std::uint64_t draws = 0;    ///< random steps whose end was looked at
        std::uint64_t bent = 0;     ///< steps along an obstacle
        std::uint64_t looks = 0;    ///< for obstacles in the way of a step, before it was certified

        std::uint64_t slides() const { return centred + refused; }  ///< centred steps that were tried
    };

    /// \param si decides which motions are free \param chart of its space
    /// \param midGap finds the gaps, when a step is blocked for the first time; null: no centred steps
    /// \param collision null: steps that end in obstacles are not bent along them
    /// \param centring of blocked steps
    ThreadingSearch(const ob::SpaceInformationPtr &si, const JointChart &chart,
                    std::function<std::unique_ptr<const GapEquations>()> midGap, std::unique_ptr<Overlap> collision,
                    const Centring &centring);

    void addStart(const ob::State *state) { addRoot(0, state); }  ///< a free state, which is copied
    void addGoal(const ob::State *state) { addRoot(1, state); }   ///< the same; starts come first
    /// How many starts (side 0) or goals (side 1) there are.
    int roots(int side) const { return static_cast<int>(rootsOf(side).size()); }
    /// The root's place in the chart.
    const Eigen::VectorXd &root(int side, int number) const;

    /// \param slices that are searched besides joint space, through the first roots of both trees, in the chart
    void setSlices(AffineSlices slices);
    const AffineSlices &slices() const { return slices_; }  ///< those of setSlices()

    /// Joins a start and a goal by the straight motion; false if it is not free.
    bool goStraight(int start, int goal);

    /// Grows one tree towards a sample, the other towards what that has led to; next time the trees change places.
    /// \param stride how the sample is used \param sample in the chart, and in the slice
    /// \param random for choices at gaps \param ptc asked between steps \return whether the trees have met
    bool grow(const Stride &stride, const Eigen::VectorXd &sample, ompl::RNG &random,
              const ob::PlannerTerminationCondition &ptc);

    /// Grows one tree from a node at the edge of what its tips have reached (TipCells) by a random step whose end is
    /// free, and the other towards that, if its tips have been nearby: BKPIECE1's step (OMPL).
    /// \param range longest step, > 0; joints turn by at most that by the root of their number, all of them or each
    /// against the one that carries it
    /// \param random for node and step \param ptc asked between steps \return whether the trees have met
    bool explore(double range, ompl::RNG &random, const ob::PlannerTerminationCondition &ptc);

    /// Once they have met: from a start to a goal.
    std::shared_ptr<og::PathGeometric> path() const;

    /// That of the starts (side 0) or of the goals (side 1).
    const ThreadingTree &tree(int side) const { return trees_[static_cast<std::size_t>(side)]; }
    /// The state of a node; of roots, exactly the one that was given.
    void write(int side, int node, ob::State *state) const;
    const Counts &counts() const { return counts_; }  ///< since the search was made
    /// The least distance that was left between the trees when one had gone towards the other; infinite at first.
    double leastDistance() const { return leastDistance_; }
    /// Whether few blocked steps could go on through gaps: passages wind, but are not narrow.
    bool isWinding() const
    {
        return static_cast<double>(counts_.centred) < leastGapShare * static_cast<double>(counts_.blocked);
    }
    /// Whether trees mostly go along gaps: several centred steps a sample.
    bool isThreading() const
    {
        return static_cast<double>(counts_.centred) > leastSlides * static_cast<double>(counts_.samples);
    }

private:
    /// Part of the blocked steps that go on through a gap where gaps matter. Measured when cells have their first turn:
    /// two in three and more in tubes of two and three gaps; at most 0.57 in mazes of long chains with openings that
    /// count as gaps, and 0.06 in the horn.
    static constexpr double leastGapShare = 0.6;
    /// Centred steps per sample from which on trees mostly go along gaps. After the first samples there are 1.8 and
    /// more in tubes, at most 1.1 in mazes and the horn.
    static constexpr double leastSlides = 1.5;
    /// Until so many steps have been blocked, motions are certified without looking at them first, and blocked steps
    /// not bent: in the open, the next sample costs less.
    static constexpr int openSteps = 3;

    enum class Progress
    {
        Trapped,
        Advanced,
        Reached
    };
    struct Root
    {
        ob::ScopedState<> state;
        int node;
    };
    /// A tree on its way to a target.
    struct Way
    {
        int side;
        int node;    ///< where it has got
        int target;  ///< node of the other tree; -1: a sample
        Eigen::VectorXd goal;
        Stride stride;
        bool isGiven = false;  ///< the way to the goal is the difference, not the short way round
        bool isPlain = false;  ///< blocked steps are given up, and of its nodes nearest() finds the last one only
        int unlisted = 0;      ///< nodes of a row that nearest() does not find yet
        int slides = 0;        ///< centred steps so far
        bool sliding = false;  ///< the last step was a centred one
    };

    void addRoot(int side, const ob::State *state);
    ThreadingTree &treeOf(int side) { return trees_[static_cast<std::size_t>(side)]; }
    const std::vector<Root> &rootsOf(int side) const { return roots_[static_cast<std::size_t>(side)]; }
    Eigen::VectorXd coordinates(const Eigen::VectorXd &x) const;
    int nearest(int side, const Stride &stride, const Eigen::VectorXd &x) const;
    /// The other tree goes towards where this one has got. \return whether it has arrived
    bool answer(const Way &way, int from, const Stride &stride, ompl::RNG &random,
                const ob::PlannerTerminationCondition &ptc);
    /// A random step: direction_ to next_, which is free. False if none has been found.
    bool drawStep(const Eigen::VectorXd &from, double range, ompl::RNG &random);
    /// Up to date with the tree.
    TipCells &cellsOf(int side);
    void measureWay(const Way &way);

    /// Whether nothing has shown yet that the place is other than open.
    bool looksOpen() const { return counts_.blocked <= openSteps; }
    Progress advance(Way &way, ompl::RNG &random);
    /// \param isGoalFree as far as is known, so that it is not looked at
    Progress stepStraight(Way &way, bool isGoalFree = false);
    Progress slide(Way &way, ompl::RNG &random);
    bool hasGaps();  ///< finds them when first asked
    /// Whether an obstacle holds the end of a step; depth_ and gradient_ say how to get it out.
    bool isDeep(const Eigen::VectorXd &x);
    /// The same, but with only a look at the links (firstMet) where the step would not be bent anyway.
    bool isBlockedAt(const Eigen::VectorXd &x, const Stride &stride);
    /// The first joint from `joint` on whose link an obstacle holds there (Overlap); -1 if none is known to.
    int firstMet(const Eigen::VectorXd &x, int joint);
    /// Whether an obstacle is seen in the way of a step: spares most of the motion checks that would fail.
    bool meetsObstacle(const Eigen::VectorXd &from, const Eigen::VectorXd &step);
    Progress stepAlong(Way &way);
    int levelOf(const Stride &stride) const;
    bool chooseCrossings(ompl::RNG &random);
    /// Where the crossings leave nothing of the way, the middle itself may be worth going to: of all gaps or of one.
    bool recentre(Way &way, double least, ompl::RNG &random);
    /// Along tangent_; or by 0, into the middle, if that is at least so far.
    bool slideBy(Way &way, double length, double least);
    double leastSlide() const;
    /// Adds the end of a motion if it is free.
    bool extend(Way &way, const Eigen::VectorXd &x, int level, bool listed);
    void listLast(Way &way);

    ob::SpaceInformationPtr si_;
    JointChart chart_;
    std::function<std::unique_ptr<const GapEquations>()> makeMidGap_;  ///< unset once it has been called
    std::unique_ptr<const GapEquations> midGap_;
    Centring centring_;
    std::optional<CentredStep> centredStep_;
    std::unique_ptr<Overlap> collision_;
    AffineSlices slices_;
    std::array<ThreadingTree, 2> trees_;
    std::array<std::vector<Root>, 2> roots_;
    std::array<std::optional<TipCells>, 2> cells_;
    int turn_ = 0;
    std::pair<int, int> meeting_{-1, -1};
    double leastDistance_ = std::numeric_limits<double>::infinity();
    Counts counts_;

    // Memory that is kept between steps.
    std::array<double, 2> slideStep_;
    ob::ScopedState<> from_, to_;
    std::vector<GapCrossing> crossings_;
    Eigen::VectorXd direction_, step_, turning_, q_, tangent_, next_, gradient_, push_;
    double depth_ = 0.0;
};
}  // namespace narrows
