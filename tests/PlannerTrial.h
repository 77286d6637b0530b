// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <exception>
#include <map>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "TinyChainProblem.h"
#include "TinyPipeProblem.h"
#include "TinyProblem.h"
#include "planners/PlannerFactory.h"
#include "spaces/OmplVersions.h"

namespace narrows
{
inline constexpr unsigned int seed = 20;

/// What planners of OMPL 1.5.2 were seen to do against the contract. The tests below fail when one of them stops doing
/// so.
enum class Quirk
{
    NeverExact,             ///< does not reach a single goal state, only comes near it
    TakesAllTime,           ///< goes on after the first solution although the objective is satisfied
    NoSecondSolve,          ///< solve() after solve() says INVALID_START, because the start has been used up
    DoesNotEnd,             ///< draws samples without asking the termination condition until enough of them are free
    InvalidStartNotNamed,   ///< an invalid start is a timeout or UNKNOWN instead of INVALID_START
    CrashesWithoutProblem,  ///< solve() without start, goal or any problem is a segmentation fault instead of an
                            ///< exception
    StartNotMarked,         ///< getPlannerData() does not say which vertex is the start
    GoalNotMarked,          ///< getPlannerData() does not say which vertex is the goal
    // No test would miss these.
    Leaks,         ///< never frees some states
    Unrepeatable,  ///< compares costs that it has not set yet: what is done depends on what was in memory before
};

inline const std::map<std::string, std::set<Quirk>> quirks = {
    {"abitstar", {Quirk::InvalidStartNotNamed}},
    {"aitstar", {Quirk::DoesNotEnd}},
    {"anytimepathshortening", {Quirk::InvalidStartNotNamed, Quirk::CrashesWithoutProblem}},
    {"bfmt", {Quirk::NoSecondSolve, Quirk::StartNotMarked, Quirk::GoalNotMarked}},
    {"birlrt", {Quirk::GoalNotMarked}},
    {"bitstar", {Quirk::InvalidStartNotNamed}},
    {"cforest", {Quirk::InvalidStartNotNamed, Quirk::CrashesWithoutProblem}},
    {"lazyprm", {Quirk::Leaks}},
    {"lazyprmstar", {Quirk::Leaks}},
    {"lbtrrt", {Quirk::TakesAllTime, Quirk::NoSecondSolve, Quirk::Unrepeatable}},
    {"rrtsharp", {Quirk::CrashesWithoutProblem}},
    {"rrtxstatic", {Quirk::CrashesWithoutProblem}},
    {"sorrtstar", {Quirk::Leaks}},
    {"sst", {Quirk::Leaks, Quirk::NeverExact, Quirk::CrashesWithoutProblem}},
    {"stride", {Quirk::GoalNotMarked}},
};

/// Where OMPL 2.0.2 is otherwise: psbl has become worse, the others are mended.
inline const std::map<std::string, Quirk> changedInOmpl2{{"aitstar", Quirk::DoesNotEnd},
                                                         {"psbl", Quirk::InvalidStartNotNamed},
                                                         {"rrtsharp", Quirk::CrashesWithoutProblem},
                                                         {"rrtxstatic", Quirk::CrashesWithoutProblem},
                                                         {"sst", Quirk::CrashesWithoutProblem}};

inline bool has(const std::string &planner, Quirk quirk)
{
    const auto found = quirks.find(planner);
    const bool before = found != quirks.end() && found->second.count(quirk) > 0;
    const auto changed = changedInOmpl2.find(planner);
    const bool differs = isOmpl2 && changed != changedInOmpl2.end() && changed->second == quirk;
    return before != differs;
}

using Counter = std::shared_ptr<std::atomic<long>>;

inline Counter counter()
{
    return std::make_shared<std::atomic<long>>(0);
}

/// True from the given number of questions on: a limit that does not depend on the machine.
inline ob::PlannerTerminationCondition questions(long limit, const Counter &asked = counter())
{
    return ob::PlannerTerminationCondition([asked, limit] { return ++*asked > limit; });
}

/// Questions that suffice for the tiny problem.
inline long enoughFor(const std::string &planner)
{
    if (findPlanner(planner).threaded)
        return 100'000'000;  // how often threads ask is a matter of chance
    return has(planner, Quirk::TakesAllTime) ? 2000 : 20'000;
}

/// The problem that a planner is tried on: one of its robots. Random numbers repeat only for what is built after the
/// seed is set.
inline Problem seededProblem(const std::string &planner = "")
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(seed);
    if (planner == "vdsm")
        return makeProblem(tinyPipeScenario());
    return planner == "tight" ? makeProblem(tinyChainScenario()) : tinyProblem();
}

struct Trial
{
    Problem problem;
    ob::PlannerPtr planner;

    const og::PathGeometric &path() const { return *problem.pdef->getSolutionPath()->as<og::PathGeometric>(); }
};

inline Trial makeTrial(const std::string &name, Problem problem, std::map<std::string, std::string> parameters = {})
{
    if (name == "hppm")  // a curve that goes round the circle; with the defaults it escapes
        parameters.insert({{"rows", "1, 3, 2; 1, -1, 4; 1, 1, -2"}, {"points_per_link", "5"}, {"repulsion", "0.1"}});
    Trial trial{std::move(problem), nullptr};
    trial.planner = makePlanner(name, trial.problem.context, parameters);
    trial.planner->setProblemDefinition(trial.problem.pdef);
    trial.planner->setup();
    return trial;
}

inline Trial makeTrial(const std::string &name, const std::map<std::string, std::string> &parameters = {})
{
    return makeTrial(name, seededProblem(name), parameters);
}

/// PlannerStatus converts to bool as well as to its enum, so that gtest cannot compare two of them.
inline ob::PlannerStatus::StatusType type(ob::PlannerStatus status)
{
    return status;
}

inline void expectTruthful(ob::PlannerStatus status, const ob::ProblemDefinition &pdef)
{
    EXPECT_EQ(status == ob::PlannerStatus::EXACT_SOLUTION, pdef.hasExactSolution()) << status.asString();
    EXPECT_EQ(status == ob::PlannerStatus::APPROXIMATE_SOLUTION, pdef.hasApproximateSolution()) << status.asString();
}

inline void expectJoined(const Trial &trial)
{
    const og::PathGeometric &path = trial.path();
    ASSERT_GE(path.getStateCount(), 2U);
    const ob::SpaceInformation &si = *trial.problem.si;
    const ob::State *goal = trial.problem.pdef->getGoal()->as<ob::GoalState>()->getState();
    EXPECT_TRUE(si.equalStates(path.getState(0), trial.problem.pdef->getStartState(0)));
    EXPECT_TRUE(si.equalStates(path.getState(static_cast<unsigned int>(path.getStateCount() - 1)), goal));
    EXPECT_TRUE(path.check());
}

/// Thrown out of a planner that will not stop by itself.
struct EndlessSampling : std::exception
{
    const char *what() const noexcept override { return "the planner does not come to an end"; }
};

/// Only the start and the goal are free: no way leads from one to the other.
class TwoStates : public ob::StateValidityChecker
{
public:
    explicit TwoStates(const Problem &problem)
      : ob::StateValidityChecker(problem.si),
        start_(problem.pdef->getStartState(0)),
        goal_(problem.pdef->getGoal()->as<ob::GoalState>()->getState())
    {
    }

    bool isValid(const ob::State *state) const override
    {
        if (++asked_ > 200'000)
            throw EndlessSampling();
        return si_->equalStates(state, start_) || si_->equalStates(state, goal_);
    }

private:
    const ob::State *start_;
    const ob::State *goal_;
    mutable std::atomic<long> asked_{0};
};
}  // namespace narrows
