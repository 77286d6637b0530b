// SPDX-License-Identifier: BSD-3-Clause
#include "validity/Verifier.h"

#include <optional>
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

void requireLink(int link, int links)
{
    if (link < 0 || link >= links)
        throw std::invalid_argument("the goal's link must be one of the arm's " + std::to_string(links));
}

/// Consistency of a goal with the arm, for each kind of goal.
struct RequireGoal
{
    int dimension;
    int links;

    void operator()(const Eigen::VectorXd &goal) const
    {
        if (goal.size() != dimension)
            throw std::invalid_argument("start and goal must have " + std::to_string(dimension) + " values");
    }
    template <class Tip>
    void operator()(const Tip &tip) const
    {
        requireLink(tip.link, links);
    }
    void operator()(const SpatialTipPath &tips) const
    {
        requireLink(tips.link, links);
        if (tips.points.empty())
            throw std::invalid_argument("the goal's tip path must have points");
    }
};

template <class Model, class Task>
void requireConsistency(const Model &model, const Task &task, const VerifierOptions &options)
{
    const int dimension = model.arm.dimension();
    if (task.start.size() != dimension)
        throw std::invalid_argument("start and goal must have " + std::to_string(dimension) + " values");
    std::visit(RequireGoal{dimension, model.arm.linkCount()}, task.goal);
    if (!(options.clearanceTolerance > 0.0))
        throw std::invalid_argument("clearanceTolerance must be positive");
}

/// Where the path is not what the goal asks for, as a refusal; nothing if it is.
template <class Model, class Rules>
class MissedGoal
{
public:
    /// \param tolerance for goals that are configurations
    MissedGoal(const Model &model, const Rules &rules, const std::vector<Eigen::VectorXd> &path, double tolerance)
      : motion_(model.arm), rules_(rules), path_(path), tolerance_(tolerance)
    {
    }

    std::optional<Verdict> operator()(const Eigen::VectorXd &goal)
    {
        return missedIf(!rules_.same(path_.back(), goal, tolerance_));
    }

    template <class Tip>
    std::optional<Verdict> operator()(const Tip &tip)
    {
        return missedIf(!isAt(path_.back(), tip.link, tip.point, tip.tolerance));
    }

    /// One waypoint of the path may stand for several tips that follow each other.
    std::optional<Verdict> operator()(const SpatialTipPath &tips)
    {
        std::size_t reached = 0;
        for (const Eigen::VectorXd &row : path_)
            while (reached < tips.points.size() && isAt(row, tips.link, tips.points[reached], tips.tolerance))
                ++reached;
        if (reached == tips.points.size())
            return missedIf(!isAt(path_.back(), tips.link, tips.points.back(), tips.tolerance));
        Verdict verdict = refusal("tip_path", path_.size() - 1);
        verdict.tip = static_cast<int>(reached);
        return verdict;
    }

private:
    std::optional<Verdict> missedIf(bool missed) const
    {
        return missed ? std::optional<Verdict>(refusal("goal", path_.size() - 1)) : std::nullopt;
    }

    template <class Point>
    bool isAt(const Eigen::VectorXd &row, int link, const Point &point, double within)
    {
        motion_.place(row, row, 0.0);
        return (motion_.link(link).to.position - point).norm() <= within;
    }

    typename proof::MotionOf<Model>::Type motion_;
    const Rules &rules_;
    const std::vector<Eigen::VectorXd> &path_;
    double tolerance_;
};

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
    MissedGoal<Model, Rules> missed(model, rules, path, options.goalTolerance);
    if (const std::optional<Verdict> verdict = std::visit(missed, task.goal))
        return *verdict;
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
