// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/Problem.h"

#include <limits>
#include <stdexcept>

#include <ompl/base/goals/GoalState.h>

#include "kernel/PlanarRepulsionModel.h"
#include "kernel/SpatialRepulsionModel.h"
#include "spaces/TipPathGoal.h"
#include "validity/ArmValidityChecker.h"
#include "validity/ContinuousMotionValidator.h"
#include "validity/SampledMotionValidator.h"

namespace narrows
{
namespace
{
/// The convention that a space's name asks for; the scenario's own if it does not care.
AngleConvention conventionOf(const std::string &space, AngleConvention own)
{
    if (space == "scenario")
        return own;
    return space == "absolute" || space == "absolute_line" ? AngleConvention::Absolute : AngleConvention::Relative;
}

FreeJoints freeJointsOf(const std::string &space)
{
    return space == "absolute_line" || space == "relative_line" ? FreeJoints::Unbounded : FreeJoints::Wrapping;
}

void checkSpaceName(const std::string &space)
{
    for (const char *known : {"scenario", "absolute", "relative", "absolute_line", "relative_line"})
        if (space == known)
            return;
    throw std::invalid_argument(
        "space \"" + space + "\" is unknown; there are scenario, absolute, relative, absolute_line and relative_line");
}

std::shared_ptr<ArmStateSpace> makeSpace(const std::string &name, const PlanarWorld &world)
{
    return std::make_shared<PlanarArmStateSpace>(world.model->arm, conventionOf(name, world.convention),
                                                 freeJointsOf(name), world.task.limits);
}

std::shared_ptr<ArmStateSpace> makeSpace(const std::string &name, const SpatialWorld &world)
{
    if (conventionOf(name, AngleConvention::Relative) == AngleConvention::Absolute)
        throw std::invalid_argument("space \"" + name +
                                    "\" is for planar robots: joints in space turn about axes that "
                                    "move, so that there are no absolute angles");
    return std::make_shared<SpatialArmStateSpace>(world.model->arm, freeJointsOf(name));
}

void setMotionValidator(const ob::SpaceInformationPtr &si, const std::string &motion,
                        const std::shared_ptr<const ArmChecker> &checker, const std::shared_ptr<CheckCounts> &counts)
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
    // OMPL throws an exception of its own outside of this range.
    constexpr double least = std::numeric_limits<double>::epsilon();
    if (read != motion.size() || !(resolution >= least && resolution <= 1.0 - least))
        throw std::invalid_argument("motion \"" + motion +
                                    "\" is neither \"continuous\" nor a resolution greater than 0 and less than 1");
    si->setStateValidityCheckingResolution(resolution);
    si->setMotionValidator(std::make_shared<SampledMotionValidator>(si, checker, counts));
}

ob::GoalPtr makeGoal(const ob::SpaceInformationPtr &si, const Eigen::VectorXd &configuration)
{
    ob::ScopedState<> state(si);
    si->getStateSpace()->as<ArmStateSpace>()->fromConfiguration(configuration, state.get());
    const auto goal = std::make_shared<ob::GoalState>(si);
    goal->setState(state);
    return goal;
}

ob::GoalPtr makeGoal(const ob::SpaceInformationPtr &si, const TipGoal &tip)
{
    return std::make_shared<TipGoalRegion>(si, tip);
}

ob::GoalPtr makeGoal(const ob::SpaceInformationPtr &si, const SpatialTipGoal &tip)
{
    return std::make_shared<SpatialTipGoalRegion>(si, tip);
}

ob::GoalPtr makeGoal(const ob::SpaceInformationPtr &si, const SpatialTipPath &path)
{
    return std::make_shared<TipPathGoal>(si, path);
}

template <typename Task>
ob::ProblemDefinitionPtr makeDefinition(const ob::SpaceInformationPtr &si, const Task &task)
{
    auto pdef = std::make_shared<ob::ProblemDefinition>(si);
    ob::ScopedState<> start(si);
    si->getStateSpace()->as<ArmStateSpace>()->fromConfiguration(task.start, start.get());
    pdef->addStartState(start);
    pdef->setGoal(std::visit([&](const auto &goal) { return makeGoal(si, goal); }, task.goal));
    return pdef;
}

PlannerContext makeContext(const ob::SpaceInformationPtr &si, const PlanarWorld &world)
{
    const auto poles = [model = world.model, limits = world.task.limits]
    {
        return planarRepulsionModel(model, limits);
    };
    return {si, poles, world.model, nullptr, false};
}

PlannerContext makeContext(const ob::SpaceInformationPtr &si, const SpatialWorld &world)
{
    const auto poles = [model = world.model]
    {
        return spatialRepulsionModel(model);
    };
    return {si, poles, nullptr, world.model, std::holds_alternative<SpatialTipPath>(world.task.goal)};
}
}  // namespace

Problem makeProblem(const Scenario &scenario, const ProblemOptions &options)
{
    checkSpaceName(options.space);
    Problem problem;
    problem.space = std::visit([&](const auto &world) { return makeSpace(options.space, world); }, scenario.world);
    problem.counts = std::make_shared<CheckCounts>();
    problem.si = std::make_shared<ob::SpaceInformation>(problem.space);

    const std::shared_ptr<const ArmChecker> checker = makeArmChecker(options.checker, scenario.world);
    problem.si->setStateValidityChecker(std::make_shared<ArmValidityChecker>(problem.si, checker, problem.counts));
    setMotionValidator(problem.si, options.motion, checker, problem.counts);
    problem.si->setup();

    problem.pdef =
        std::visit([&](const auto &world) { return makeDefinition(problem.si, world.task); }, scenario.world);
    problem.context = std::visit([&](const auto &world) { return makeContext(problem.si, world); }, scenario.world);
    return problem;
}
}  // namespace narrows
