// SPDX-License-Identifier: BSD-3-Clause
// A hyper-redundant manipulator leads its tip along a path, as in VDSM (Machines 10 (2022) 1030): an OMPL program of
// the plain kind, with SimpleSetup. All that the paper plots goes to a file: slide, link angles, joint centres,
// clearance and cable lengths, one row per pose.
//
//   02_vdsm_tip_path SCENARIO.yaml OUTPUT.csv [PARAMETER=VALUE]...
#include <algorithm>
#include <chrono>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>

#include "kernel/CableDrive.h"
#include "kernel/JointCentres.h"
#include "planners/ModelPlanner.h"
#include "scenario/Problem.h"
#include "spaces/TipPathGoal.h"

namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;
using Path = std::vector<Eigen::VectorXd>;

constexpr double degree = 3.14159265358979323846 / 180.0;

struct Plan
{
    Path path;
    double milliseconds;
};

/// Plans in the scenario's space; what is returned is what the verifier has proven.
Plan plan(const narrows::Scenario &scenario, const narrows::Problem &problem,
          const std::map<std::string, std::string> &parameters)
{
    og::SimpleSetup setup(problem.si);
    const ob::ScopedState<> start(problem.space, problem.pdef->getStartState(0));
    setup.setStartState(start);
    setup.setGoal(problem.pdef->getGoal());
    setup.setPlanner(narrows::makePlanner("vdsm", problem.context, parameters));
    setup.setup();
    const auto begin = std::chrono::steady_clock::now();
    const ob::PlannerStatus status = setup.solve(10.0);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (status != ob::PlannerStatus::EXACT_SOLUTION)
        throw std::runtime_error(scenario.name + ": " +
                                 dynamic_cast<const narrows::ModelPlanner &>(*setup.getPlanner()).reason());
    Plan result{problem.space->unwrap(setup.getSolutionPath()), 1e3 * seconds};
    const narrows::Verdict verdict = narrows::verify(scenario.world, result.path);
    if (!verdict.accepted)
        throw std::runtime_error(scenario.name + ": the verifier refuses the path: " + verdict.reason);
    std::cout << fmt::format("{}: {} poses, {:.2f} ms, clearance {:.2f} proven by the verifier\n", scenario.name,
                             result.path.size(), result.milliseconds, verdict.clearance);
    return result;
}

void writeHead(std::ostream &out, int links)
{
    out << "pose,station,slide,clearance";
    for (int i = 1; i <= links; ++i)
        out << fmt::format(",psi_{}_deg", i);
    for (int i = 1; i <= links + 1; ++i)
        out << fmt::format(",O{0}_x,O{0}_y,O{0}_z", i);
    for (int i = 1; i <= links; ++i)
        out << fmt::format(",cable_{0}a,cable_{0}b,cable_{0}c", i);
    out << '\n';
}

/// One row per pose; `station` counts the points of the tip path, where they are reached.
void write(const narrows::SpatialWorld &world, const Path &path, const std::string &file)
{
    const auto chain = narrows::chainGeometry(world.model->arm);
    const auto &goal = std::get<narrows::SpatialTipPath>(world.task.goal);
    const auto checker = narrows::makeArmChecker("analytic", *world.model);
    const narrows::CableDrive drive(chain->lengths);
    const int links = static_cast<int>(chain->lengths.size());
    std::ofstream out(file);
    writeHead(out, links);
    std::vector<Eigen::Vector3d> centres;
    Eigen::VectorXd cables;
    std::size_t station = 0;
    for (std::size_t pose = 0; pose < path.size(); ++pose)
    {
        const Eigen::VectorXd &q = path[pose];
        narrows::jointCentres(world.model->arm, q, centres);
        const bool reached =
            station < goal.points.size() && (centres.back() - goal.points[station]).norm() <= goal.tolerance;
        out << pose << ',' << (reached ? std::to_string(++station) : "")
            << fmt::format(",{:.9g},{:.9g}", q[0], checker->clearance(q));
        for (int i = 0; i < links; ++i)
            out << fmt::format(",{:.9g}", narrows::bendAngle(q[2 * i + 1], q[2 * i + 2]) / degree);
        for (const Eigen::Vector3d &centre : centres)
            out << fmt::format(",{:.9g},{:.9g},{:.9g}", centre.x(), centre.y(), centre.z());
        drive.totalLengths(q.tail(2 * links), cables);
        for (const double length : cables)
            out << fmt::format(",{:.9g}", length);
        out << '\n';
    }
    if (!out.flush())
        throw std::runtime_error(file + " cannot be written");
}

std::pair<std::string, std::string> parameter(const std::string &word)
{
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos)
        throw std::invalid_argument(word + ": parameters are NAME=VALUE");
    return {word.substr(0, sign), word.substr(sign + 1)};
}
}  // namespace

int main(int count, char **arguments)
{
    if (count < 3)
    {
        std::cerr << "usage: 02_vdsm_tip_path SCENARIO.yaml OUTPUT.csv [PARAMETER=VALUE]...\n";
        return 2;
    }
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
    try
    {
        std::map<std::string, std::string> parameters;
        for (int i = 3; i < count; ++i)
            parameters.insert(parameter(arguments[i]));
        const narrows::Scenario scenario = narrows::readScenario(arguments[1]);
        const narrows::Problem problem = narrows::makeProblem(scenario);
        if (dynamic_cast<const narrows::TipPathGoal *>(problem.pdef->getGoal().get()) == nullptr)
            throw std::invalid_argument(scenario.name + " has no tip path");
        const std::string unsupported = narrows::whyUnsupported("vdsm", problem.context);
        if (!unsupported.empty())
            throw std::invalid_argument(scenario.name + ": " + unsupported);
        write(scenario.spatial(), plan(scenario, problem, parameters).path, arguments[2]);
    }
    catch (const std::exception &error)
    {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
