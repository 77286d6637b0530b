// SPDX-License-Identifier: BSD-3-Clause
#include "validity/Verifier.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "validity/PathProof.h"

namespace narrows
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double limitTolerance = 1e-9;  // radians or lengths: a joint that rests at its limit, after conversions

Verdict refusal(const char *reason, int waypoint = -1)
{
    Verdict verdict;
    verdict.reason = reason;
    verdict.segment = waypoint;
    return verdict;
}

/// What is asked about joint values, in the convention of the limits.
class JointRules
{
public:
    JointRules(const PlanarArm &arm, const JointLimits &limits) : arm_(arm), limits_(limits) {}

    /// Whether every joint and the slide are where they may be.
    bool within(const Eigen::VectorXd &row) const
    {
        const auto &slide = arm_.slide();
        if (slide && (row[0] < slide->lower - limitTolerance || row[0] > slide->upper + limitTolerance))
            return false;
        for (int link = 0; link < arm_.linkCount(); ++link)
            if (const std::optional<Interval> interval = limitOf(link))
                if (const double angle = joint(row, link);
                    angle < interval->lower - limitTolerance || angle > interval->upper + limitTolerance)
                    return false;
        return true;
    }

    /// Whether two rows are the same up to full turns of joints without limits.
    bool same(const Eigen::VectorXd &row, const Eigen::VectorXd &other, double tolerance) const
    {
        if (arm_.slide() && std::abs(row[0] - other[0]) > tolerance)
            return false;
        for (int link = 0; link < arm_.linkCount(); ++link)
        {
            const double difference = joint(row, link) - joint(other, link);
            if (std::abs(limitOf(link) ? difference : std::remainder(difference, 2.0 * pi)) > tolerance)
                return false;
        }
        return true;
    }

private:
    std::optional<Interval> limitOf(int link) const
    {
        return limits_.angles.empty() ? std::nullopt : limits_.angles[link];
    }

    double joint(const Eigen::VectorXd &row, int link) const
    {
        const int offset = arm_.slide() ? 1 : 0;
        const int parent = arm_.links()[link].parent;
        const bool relative = limits_.convention == AngleConvention::Relative && parent >= 0;
        return row[offset + link] - (relative ? row[offset + parent] : 0.0);
    }

    const PlanarArm &arm_;
    const JointLimits &limits_;
};

void requireConsistency(const PlanarModel &model, const PlanarTask &task, const VerifierOptions &options)
{
    const auto *goal = std::get_if<Eigen::VectorXd>(&task.goal);
    const auto *tip = std::get_if<TipGoal>(&task.goal);
    const int links = model.arm.linkCount();
    if (task.start.size() != model.arm.dimension() || (goal && goal->size() != model.arm.dimension()))
        throw std::invalid_argument("start and goal must have " + std::to_string(model.arm.dimension()) + " values");
    if (tip && (tip->link < 0 || tip->link >= links))
        throw std::invalid_argument("the goal's link must be one of the arm's " + std::to_string(links));
    if (!task.limits.angles.empty() && static_cast<int>(task.limits.angles.size()) != links)
        throw std::invalid_argument("joint limits must be given for none or all of the " + std::to_string(links) +
                                    " links");
    if (!(options.clearanceTolerance > 0.0))
        throw std::invalid_argument("clearanceTolerance must be positive");
}

bool reachesGoal(const PlanarArm &arm, const PlanarTask &task, const JointRules &rules, const Eigen::VectorXd &last,
                 double tolerance)
{
    if (const auto *goal = std::get_if<Eigen::VectorXd>(&task.goal))
        return rules.same(last, *goal, tolerance);
    const TipGoal &goal = std::get<TipGoal>(task.goal);
    ArmMotion motion(arm);
    motion.place(last, last, 0.0);
    return (motion.point(motion.tipOf(goal.link)) - goal.point).norm() <= goal.tolerance;
}
}  // namespace

Verdict verify(const PlanarModel &model, const PlanarTask &task, const std::vector<Eigen::VectorXd> &path,
               const VerifierOptions &options)
{
    requireConsistency(model, task, options);
    if (path.empty())
        return refusal("empty_path");
    for (std::size_t i = 0; i < path.size(); ++i)
        if (path[i].size() != model.arm.dimension())
            return refusal("dimension", static_cast<int>(i));
    for (std::size_t i = 0; i < path.size(); ++i)
        if (!path[i].allFinite() || !(path[i] - path[i == 0 ? 0 : i - 1]).allFinite())
            return refusal("not_finite", static_cast<int>(i));
    const JointRules rules(model.arm, task.limits);
    if (!rules.same(path.front(), task.start, options.startTolerance))
        return refusal("start", 0);
    if (!reachesGoal(model.arm, task, rules, path.back(), options.goalTolerance))
        return refusal("goal", static_cast<int>(path.size()) - 1);
    for (std::size_t i = 0; i < path.size(); ++i)
        if (!rules.within(path[i]))
            return refusal("limits", static_cast<int>(i));
    return PathProof(model, path, options.clearanceTolerance).run();
}
}  // namespace narrows
