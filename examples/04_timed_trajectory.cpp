// SPDX-License-Identifier: BSD-3-Clause
// What a controller wants: joint values, velocities, accelerations and jerks, a thousand times a second. A plain OMPL
// program plans with viapoint and writes the motion that it has certified.
//
//   04_timed_trajectory SCENARIO.yaml OUTPUT.csv [PARAMETER=VALUE]...
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/ViaPointHomotopy.h"
#include "scenario/Problem.h"
#include "validity/TrajectoryVerdict.h"

namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double rate = 1000.0;  // samples per second

void write(const narrows::JointTrajectory &motion, const std::string &file)
{
    std::ofstream out(file);
    out << "time";
    for (Eigen::Index joint = 1; joint <= motion.joints(); ++joint)
        out << fmt::format(",q_{0},v_{0},a_{0},j_{0}", joint);
    out << '\n';
    narrows::JointTrajectory::States state;
    const int samples = static_cast<int>(std::ceil(rate * motion.duration()));
    for (int i = 0; i <= samples; ++i)
    {
        const double time = std::min(i / rate, motion.duration());
        motion.at(time, state);
        out << fmt::format("{:.9g}", time);
        for (Eigen::Index joint = 0; joint < motion.joints(); ++joint)
            out << fmt::format(",{:.12g},{:.12g},{:.12g},{:.12g}", state(joint, 0), state(joint, 1), state(joint, 2),
                               state(joint, 3));
        out << '\n';
    }
    if (!out.flush())
        throw std::runtime_error(file + " cannot be written");
}

void run(const std::string &file, const std::string &output, const std::map<std::string, std::string> &parameters)
{
    const narrows::Scenario scenario = narrows::readScenario(file);
    const narrows::Problem problem = narrows::makeProblem(scenario);
    const ob::PlannerPtr planner = narrows::makePlanner("viapoint", problem.context, parameters);
    og::SimpleSetup setup(problem.si);
    setup.setStartState(ob::ScopedState<>(problem.space, problem.pdef->getStartState(0)));
    setup.setGoal(problem.pdef->getGoal());
    setup.setPlanner(planner);
    if (setup.solve(10.0) != ob::PlannerStatus::EXACT_SOLUTION)
        throw std::runtime_error(scenario.name + ": no way was found");
    const auto &viaPoint = dynamic_cast<const narrows::ViaPointHomotopy &>(*planner);
    if (viaPoint.trajectory() == nullptr)
        throw std::runtime_error(scenario.name + ": start and goal are equal");
    const narrows::JointTrajectory &motion = *viaPoint.trajectory();
    const narrows::TrajectoryVerdict verdict = std::visit(
        [&](const auto &world) { return narrows::verifyTrajectory(*world.model, world.task, *problem.space, motion); },
        scenario.world);
    if (!verdict.accepted)
        throw std::runtime_error(scenario.name + ": the verifier refuses the motion: " + verdict.chords.reason);
    write(motion, output);
    std::cout << fmt::format("{}: {:.3f} s, with stops {:.3f} s, clearance {:.2g} proven by the verifier\n",
                             scenario.name, motion.duration(), viaPoint.measures().at("stop_duration"),
                             verdict.clearance);
}
}  // namespace

int main(int count, char **arguments)
{
    if (count < 3)
    {
        std::cerr << "usage: 04_timed_trajectory SCENARIO.yaml OUTPUT.csv [PARAMETER=VALUE]...\n";
        return 2;
    }
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(1);
    try
    {
        std::map<std::string, std::string> parameters;
        for (int i = 3; i < count; ++i)
        {
            const std::string word = arguments[i];
            const std::size_t sign = word.find('=');
            if (sign == std::string::npos)
                throw std::invalid_argument(word + ": parameters are NAME=VALUE");
            parameters[word.substr(0, sign)] = word.substr(sign + 1);
        }
        run(arguments[1], arguments[2], parameters);
    }
    catch (const std::exception &error)
    {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
