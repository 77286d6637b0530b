// SPDX-License-Identifier: BSD-3-Clause
// From scaled poses to motions that the validator accepts.
#include <algorithm>
#include <limits>

#include "kernel/scaling/PoseRules.h"
#include "planners/PoseTranslator.h"
#include "planners/VDSM.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// Poses that one motion may pass over where only the last one matters.
constexpr std::size_t longestStride = 64;
/// Poses whose values differ by less are one pose, computed twice.
constexpr double rounding = 1e-12;
constexpr double muchLess = 0.8;
/// Motions in which a pose is bent into another one.
constexpr int bends = 16;

/// Length of the tip's way from one of its points on; infinity if there is no way.
double restFrom(const std::vector<Vector3d> &tips, std::size_t first)
{
    double rest = tips.empty() ? std::numeric_limits<double>::infinity() : 0.0;
    for (std::size_t i = first + 1; i < tips.size(); ++i)
        rest += (tips[i] - tips[i - 1]).norm();
    return rest;
}
}  // namespace

/// Turns a scaled way into motions that the validator accepts, as far as it does.
VDSM::Attempt VDSM::follow(const ScaledWay &way, const Search &search, const ob::PlannerTerminationCondition &ptc) const
{
    Attempt attempt{{start_}, toText(way.fault.failure), restFrom(way.tips, 0)};
    const std::size_t poses = way.scaled.poses();
    PoseTranslator translator(*chain_);
    Eigen::VectorXd values;
    // A part of the way is worth checking only if it may be much longer than the longest so far.
    const bool promising =
        !way.fault || (!search.coarse && poses > 0 &&
                       (!best_ || restFrom(way.tips, way.scaled.first + poses - 1) < muchLess * best_->rest));
    if (!promising || poses == 0 || !translator.toValues(way.scaled.pose(0), values))
        return attempt;
    const bool same = (values - start_).lpNorm<Eigen::Infinity>() <= rounding;
    if (!same && !join(start_, values, attempt))
    {
        attempt.reason = "start_motion";
        return attempt;
    }
    std::size_t at = 0;
    for (std::size_t stride = 1; at + 1 < poses;)
    {
        const std::size_t to = std::min(at + (search.followsPath ? 1 : stride), poses - 1);
        if (ptc || !translator.toValues(way.scaled.pose(to), values))
            break;
        if (isFree(attempt.states.back(), values))
        {
            attempt.states.push_back(values);
            at = to;
            stride = std::min(2 * stride, longestStride);
            continue;
        }
        if (to == at + 1)
        {
            attempt.reason = "motion";
            break;
        }
        stride = std::max<std::size_t>((to - at) / 2, 1);
    }
    attempt.rest = restFrom(way.tips, way.scaled.first + at);
    if (way.scaled.first + at + 1 < way.tips.size())
    {
        if (attempt.reason.empty())
            attempt.reason = "timeout";
        return attempt;
    }
    if (attempt.reason.empty() && search.target && !join(attempt.states.back(), *search.target, attempt))
        attempt.reason = "goal_motion";
    return attempt;
}

/// Appends motions from one pose to another one whose tip is the same, or near: the straight one or, if that is not
/// free, a bend of the one into the other in the section plane.
bool VDSM::join(const Eigen::VectorXd &from, const Eigen::VectorXd &to, Attempt &attempt) const
{
    if (isFree(from, to))
    {
        attempt.states.push_back(to);
        return true;
    }
    const ScalingProblem problem = scalingProblem(*chain_);
    const PoseRules rules(problem);
    PoseTranslator translator(*chain_);
    std::vector<Vector3d> first, last;
    translator.toCentres(model_->arm, from, first);
    translator.toCentres(model_->arm, to, last);
    SectionChain chain(first.size());
    std::vector<Vector3d> centres(first.size());
    std::vector<Eigen::VectorXd> states;
    for (int k = 1; k <= bends; ++k)
    {
        const double share = static_cast<double>(k) / bends;
        for (std::size_t i = 0; i < chain.size(); ++i)
            chain[i] = (1.0 - share) * first[i].tail<2>() + share * last[i].tail<2>();
        Eigen::VectorXd values = to;
        if (k < bends &&
            (rules.lift(chain, (1.0 - share) * first.back().x() + share * last.back().x(), centres.data()) ||
             !translator.toValues(centres.data(), values)))
            return false;
        if (!isFree(states.empty() ? from : states.back(), values))
            return false;
        states.push_back(std::move(values));
    }
    attempt.states.insert(attempt.states.end(), states.begin(), states.end());
    return true;
}

bool VDSM::isFree(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const
{
    ob::ScopedState<> a(si_), b(si_);
    space_->fromConfiguration(from, a.get());
    space_->fromConfiguration(to, b.get());
    return si_->checkMotion(a.get(), b.get());
}
}  // namespace narrows
