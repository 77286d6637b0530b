// SPDX-License-Identifier: BSD-3-Clause
#include "validity/Verifier.h"

#include <stdexcept>
#include <string>

#include "validity/JointRules.h"
#include "validity/PathProof.h"

namespace narrows
{
namespace
{
Verdict refusal(const char *reason, std::size_t waypoint)
{
    Verdict verdict;
    verdict.reason = reason;
    verdict.segment = static_cast<int>(waypoint);
    return verdict;
}

template <class Model, class Task>
void requireConsistency(const Model &model, const Task &task, const VerifierOptions &options)
{
    const int dimension = model.arm.dimension(), links = model.arm.linkCount();
    const auto *goal = std::get_if<0>(&task.goal);
    const auto *tip = std::get_if<1>(&task.goal);
    if (task.start.size() != dimension || (goal && goal->size() != dimension))
        throw std::invalid_argument("start and goal must have " + std::to_string(dimension) + " values");
    if (tip && (tip->link < 0 || tip->link >= links))
        throw std::invalid_argument("the goal's link must be one of the arm's " + std::to_string(links));
    if (!(options.clearanceTolerance > 0.0))
        throw std::invalid_argument("clearanceTolerance must be positive");
}

template <class Model, class Task, class Rules>
bool reachesGoal(const Model &model, const Task &task, const Rules &rules, const Eigen::VectorXd &last,
                 double tolerance)
{
    if (const auto *goal = std::get_if<0>(&task.goal))
        return rules.same(last, *goal, tolerance);
    const auto &goal = std::get<1>(task.goal);
    typename proof::MotionOf<Model>::Type motion(model.arm);
    motion.place(last, last, 0.0);
    return (motion.link(goal.link).to.position - goal.point).norm() <= goal.tolerance;
}

template <class Model, class Task, class Rules>
Verdict judge(const Model &model, const Task &task, const Rules &rules, const std::vector<Eigen::VectorXd> &path,
              const VerifierOptions &options)
{
    requireConsistency(model, task, options);
    if (path.empty())
    {
        Verdict verdict;
        verdict.reason = "empty_path";
        return verdict;
    }
    for (std::size_t i = 0; i < path.size(); ++i)
        if (path[i].size() != model.arm.dimension())
            return refusal("dimension", i);
    for (std::size_t i = 0; i < path.size(); ++i)
        if (!path[i].allFinite() || !(path[i] - path[i == 0 ? 0 : i - 1]).allFinite())
            return refusal("not_finite", i);
    if (!rules.same(path.front(), task.start, options.startTolerance))
        return refusal("start", 0);
    if (!reachesGoal(model, task, rules, path.back(), options.goalTolerance))
        return refusal("goal", path.size() - 1);
    for (std::size_t i = 0; i < path.size(); ++i)
        if (!rules.within(path[i]))
            return refusal("limits", i);
    return proof::PathProof<Model>(model, path, options.clearanceTolerance).run();
}
}  // namespace

Verdict verify(const PlanarModel &model, const PlanarTask &task, const std::vector<Eigen::VectorXd> &path,
               const VerifierOptions &options)
{
    const int links = model.arm.linkCount();
    if (!task.limits.angles.empty() && static_cast<int>(task.limits.angles.size()) != links)
        throw std::invalid_argument("joint limits must be given for none or all of the " + std::to_string(links) +
                                    " links");
    return judge(model, task, proof::PlanarRules(model.arm, task.limits), path, options);
}

Verdict verify(const SpatialModel &model, const SpatialTask &task, const std::vector<Eigen::VectorXd> &path,
               const VerifierOptions &options)
{
    return judge(model, task, proof::SpatialRules(model.arm), path, options);
}
}  // namespace narrows
