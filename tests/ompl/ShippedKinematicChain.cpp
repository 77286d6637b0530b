// SPDX-License-Identifier: BSD-3-Clause
// OMPL's KinematicChain as it is shipped (demos/KinematicChain.h of an OMPL source tree, unmodified: its space, its
// checker, its horn, motions looked at in steps), and what our verifier says of the paths that count as solved there:
// docs/checking.md. Then the same once more with motions decided without steps.
//
//   ShippedKinematicChain LINKS RUNS SECONDS
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>

#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "demos/KinematicChain.h"
#include "validity/ArmChecker.h"
#include "validity/Verifier.h"

namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;
using Eigen::VectorXd;

/// The horn's lines as triangles that are 1e-8 high: our obstacles have an inside.
std::vector<narrows::PlanarObstacle> obstaclesOf(const Environment &lines)
{
    std::vector<narrows::PlanarObstacle> result;
    for (const Segment &line : lines)
    {
        const Eigen::Vector2d from(line.x0, line.y0), way = Eigen::Vector2d(line.x1, line.y1) - from;
        const Eigen::Vector2d left = Eigen::Vector2d(-way.y(), way.x()).normalized();
        result.push_back({"wall" + std::to_string(result.size()),
                          narrows::Polygon{{from, from + way, from + 0.5 * way + 1e-8 * left}}});
    }
    return result;
}

narrows::PlanarModel modelOf(unsigned int links, const Environment &lines)
{
    std::vector<narrows::PlanarLink> chain;
    for (unsigned int i = 0; i < links; ++i)
        chain.push_back({1.0 / links, static_cast<int>(i) - 1});
    return {narrows::PlanarArm({0.0, 0.0}, chain), obstaclesOf(lines), true};
}

/// Absolute angles of relative ones.
VectorXd accumulated(VectorXd relative)
{
    for (Eigen::Index i = 1; i < relative.size(); ++i)
        relative[i] += relative[i - 1];
    return relative;
}

VectorXd valuesOf(const ob::State *state, unsigned int links)
{
    return Eigen::Map<const VectorXd>(state->as<KinematicChainSpace::StateType>()->values, links);
}

/// The way between two states as KinematicChainSpace interpolates it: every joint the short way.
VectorXd wayBetween(const ob::State *from, const ob::State *to, unsigned int links)
{
    VectorXd way = valuesOf(to, links) - valuesOf(from, links);
    for (double &turn : way)
        turn = std::remainder(turn, 2.0 * M_PI);
    return way;
}

/// Motions decided without steps, by our checker.
class ExactMotions : public ob::MotionValidator
{
public:
    ExactMotions(const ob::SpaceInformationPtr &si, const narrows::PlanarModel &model)
      : ob::MotionValidator(si), checker_(narrows::makeArmChecker("analytic", model))
    {
    }

    bool checkMotion(const ob::State *from, const ob::State *to) const override
    {
        const unsigned int links = si_->getStateDimension();
        std::uint64_t placements = 0;
        const VectorXd end = accumulated(valuesOf(to, links));
        return si_->isValid(to) && checker_->isFree(end) &&
               checker_->isMotionFree(accumulated(valuesOf(from, links)), accumulated(wayBetween(from, to, links)),
                                      placements);
    }

    bool checkMotion(const ob::State *from, const ob::State *to, std::pair<ob::State *, double> &last) const override
    {
        const bool free = checkMotion(from, to);
        last.second = free ? 1.0 : 0.0;
        if (last.first != nullptr)
            si_->copyState(last.first, free ? to : from);
        return free;
    }

private:
    std::unique_ptr<const narrows::ArmChecker> checker_;
};

narrows::Verdict judge(const narrows::PlanarModel &model, const og::PathGeometric &path, unsigned int links)
{
    std::vector<VectorXd> rows{valuesOf(path.getState(0), links)};
    for (unsigned int i = 1; i < path.getStateCount(); ++i)
        rows.push_back(rows.back() + wayBetween(path.getState(i - 1), path.getState(i), links));
    for (VectorXd &row : rows)
        row = accumulated(row);
    // A path that ends near the goal as OMPL means it shall not fail for that.
    return narrows::verify(model, {rows.front(), rows.back(), {}}, rows);
}

/// Start and goal of KinematicChainBenchmark.cpp.
void ask(og::SimpleSetup &setup, unsigned int links)
{
    ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
    for (unsigned int i = 0; i < links; ++i)
    {
        start[i] = i == 0 ? 0.0 : M_PI / links;
        goal[i] = i == 0 ? M_PI - 0.001 : 0.0;
    }
    setup.setStartAndGoalStates(start, goal);
}

/// Does OMPL's own checker refuse a state of the path when it looks a thousand times per motion?
bool isRefusedByItsOwnChecker(og::PathGeometric path)
{
    path.interpolate(static_cast<unsigned int>(1000 * path.getStateCount()));
    for (const ob::State *state : path.getStates())
        if (!path.getSpaceInformation()->isValid(state))
            return true;
    return false;
}

struct Tally
{
    int solved = 0;
    int refusedByOwn = 0;
    std::map<std::string, int> verdicts;  ///< reasons; "accepted"
};

template <typename Planner>
Tally race(og::SimpleSetup &setup, const narrows::PlanarModel &model, unsigned int links, int runs, double seconds)
{
    Tally tally;
    setup.setPlanner(std::make_shared<Planner>(setup.getSpaceInformation()));
    for (int run = 0; run < runs; ++run)
    {
        setup.clear();
        if (setup.solve(seconds) != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++tally.solved;
        tally.refusedByOwn += isRefusedByItsOwnChecker(setup.getSolutionPath()) ? 1 : 0;
        const narrows::Verdict verdict = judge(model, setup.getSolutionPath(), links);
        ++tally.verdicts[verdict.accepted ? "accepted" : verdict.reason];
    }
    return tally;
}

void print(const std::string &motions, const std::string &planner, int runs, const Tally &tally)
{
    std::cout << std::left << std::setw(8) << motions << std::setw(12) << planner << "solved " << tally.solved << " of "
              << runs << "; own checker refuses " << tally.refusedByOwn << "; verifier:";
    for (const auto &[verdict, count] : tally.verdicts)
        std::cout << ' ' << verdict << ' ' << count;
    std::cout << std::endl;
}

void raceAll(const std::string &motions, og::SimpleSetup &setup, const narrows::PlanarModel &model, unsigned int links,
             int runs, double seconds)
{
    print(motions, "STRIDE", runs, race<og::STRIDE>(setup, model, links, runs, seconds));
    print(motions, "EST", runs, race<og::EST>(setup, model, links, runs, seconds));
    print(motions, "KPIECE1", runs, race<og::KPIECE1>(setup, model, links, runs, seconds));
    print(motions, "RRT", runs, race<og::RRT>(setup, model, links, runs, seconds));
    print(motions, "PRM", runs, race<og::PRM>(setup, model, links, runs, seconds));
    print(motions, "RRTConnect", runs, race<og::RRTConnect>(setup, model, links, runs, seconds));
    print(motions, "BKPIECE1", runs, race<og::BKPIECE1>(setup, model, links, runs, seconds));
}
}  // namespace

int main(int argc, char **argv)
{
    if (argc != 4)
    {
        std::cerr << "usage: ShippedKinematicChain LINKS RUNS SECONDS\n";
        return 2;
    }
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(1);
    const auto links = static_cast<unsigned int>(std::stoul(argv[1]));
    const int runs = std::stoi(argv[2]);
    const double seconds = std::stod(argv[3]);
    Environment horn = createHornEnvironment(links, std::log(static_cast<double>(links)) / links);
    const narrows::PlanarModel model = modelOf(links, horn);
    for (const bool exact : {false, true})
    {
        const auto chain = std::make_shared<KinematicChainSpace>(links, 1.0 / links, &horn);
        og::SimpleSetup setup(chain);
        const auto &si = setup.getSpaceInformation();
        setup.setStateValidityChecker(std::make_shared<KinematicChainValidityChecker>(si));
        if (exact)
            si->setMotionValidator(std::make_shared<ExactMotions>(si, model));
        ask(setup, links);
        raceAll(exact ? "exact" : "shipped", setup, model, links, runs, seconds);
    }
    return 0;
}
