// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/Problem.h"

#include <cmath>
#include <stdexcept>

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/goals/GoalState.h>

#include "spaces/TipGoalRegion.h"
#include "validity/ArmValidityChecker.h"
#include "validity/ContinuousMotionValidator.h"

namespace narrows
{
namespace
{
std::shared_ptr<PlanarArmStateSpace> makeSpace(const std::string &name, const Scenario &scenario)
{
    using C = AngleConvention;
    using J = FreeJoints;
    const PlanarModel &model = *scenario.model;
    const JointLimits &limits = scenario.task.limits;
    if (name == "scenario")
        return std::make_shared<PlanarArmStateSpace>(model.arm, scenario.convention, J::Wrapping, limits);
    if (name == "absolute")
        return std::make_shared<PlanarArmStateSpace>(model.arm, C::Absolute, J::Wrapping, limits);
    if (name == "relative")
        return std::make_shared<PlanarArmStateSpace>(model.arm, C::Relative, J::Wrapping, limits);
    if (name == "absolute_line")
        return std::make_shared<PlanarArmStateSpace>(model.arm, C::Absolute, J::Unbounded, limits);
    if (name == "relative_line")
        return std::make_shared<PlanarArmStateSpace>(model.arm, C::Relative, J::Unbounded, limits);
    throw std::invalid_argument(
        "space \"" + name + "\" is unknown; there are scenario, absolute, relative, absolute_line and relative_line");
}

void setMotionValidator(const ob::SpaceInformationPtr &si, const std::string &motion,
                        const std::shared_ptr<const PlanarChecker> &checker, const std::shared_ptr<CheckCounts> &counts)
{
    if (motion == "continuous")
    {
        si->setMotionValidator(std::make_shared<ContinuousMotionValidator>(si, checker, counts));
        return;
    }
    std::size_t read = 0;
    double resolution = 0.0;
    try
    {
        resolution = std::stod(motion, &read);
    }
    catch (const std::logic_error &)
    {
        read = 0;
    }
    if (read != motion.size() || !(resolution > 0.0 && resolution <= 1.0))
        throw std::invalid_argument("motion \"" + motion + "\" is neither \"continuous\" nor a resolution in (0, 1]");
    si->setStateValidityCheckingResolution(resolution);
    si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
}

ob::GoalPtr makeGoal(const ob::SpaceInformationPtr &si, const PlanarTask &task)
{
    if (const auto *tip = std::get_if<TipGoal>(&task.goal))
        return std::make_shared<TipGoalRegion>(si, *tip);
    const auto *space = si->getStateSpace()->as<PlanarArmStateSpace>();
    auto goal = std::make_shared<ob::GoalState>(si);
    ob::ScopedState<> state(si);
    space->fromAbsolute(std::get<Eigen::VectorXd>(task.goal), state.get());
    goal->setState(state);
    return goal;
}
}  // namespace

Problem makeProblem(const Scenario &scenario, const ProblemOptions &options)
{
    Problem problem;
    problem.model = scenario.model;
    problem.space = makeSpace(options.space, scenario);
    problem.counts = std::make_shared<CheckCounts>();
    problem.si = std::make_shared<ob::SpaceInformation>(problem.space);

    const std::shared_ptr<const PlanarChecker> checker = makeChecker(options.checker, *scenario.model);
    problem.si->setStateValidityChecker(std::make_shared<ArmValidityChecker>(problem.si, checker, problem.counts));
    setMotionValidator(problem.si, options.motion, checker, problem.counts);
    problem.si->setup();

    problem.pdef = std::make_shared<ob::ProblemDefinition>(problem.si);
    ob::ScopedState<> start(problem.si);
    problem.space->fromAbsolute(scenario.task.start, start.get());
    problem.pdef->addStartState(start);
    problem.pdef->setGoal(makeGoal(problem.si, scenario.task));
    return problem;
}
}  // namespace narrows
