// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/PreparedRun.h"

#include <limits>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/RandomNumbers.h>

#include "benchmark/QuietOmpl.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
bool hasRecipe(const RunSpec &spec)
{
    return spec.recipe && spec.scenario->methods.count(spec.planner) > 0;
}
}  // namespace

std::map<std::string, std::string> givenParameters(const RunSpec &spec)
{
    std::map<std::string, std::string> parameters = spec.parameters;
    if (hasRecipe(spec))
        parameters.insert(spec.scenario->methods.at(spec.planner).begin(),
                          spec.scenario->methods.at(spec.planner).end());
    return parameters;
}

Record announce(const RunSpec &spec)
{
    Record record;
    record.prescribed = hasRecipe(spec);
    record.usesModel = findPlanner(spec.planner).usesModel;
    record.parameters = givenParameters(spec);
    return record;
}

void seedOmpl(std::uint32_t seed)
{
    // OMPL warns that a second seed "will not lead to deterministic sampling"; it does for all that is built after it.
    const QuietOmpl quiet(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(seed == 0 ? std::numeric_limits<std::uint32_t>::max() : seed);
}

ob::OptimizationObjectivePtr firstSolution(const ob::SpaceInformationPtr &si)
{
    const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(si);
    objective->setCostThreshold(objective->infiniteCost());
    return objective;
}

PreparedRun prepare(const RunSpec &spec)
{
    PreparedRun run;
    run.problem = makeProblem(*spec.scenario, spec.problem);
    run.unsupported = whyUnsupported(spec.planner, run.problem.context);
    if (!run.unsupported.empty())
        return run;

    run.problem.pdef->setOptimizationObjective(firstSolution(run.problem.si));
    run.planner = makePlanner(spec.planner, run.problem.context, givenParameters(spec));
    run.planner->setProblemDefinition(run.problem.pdef);
    run.planner->setup();
    return run;
}
}  // namespace narrows
