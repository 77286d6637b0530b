// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/PathScaling.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "kernel/scaling/BranchScaling.h"
#include "kernel/scaling/PlainScaling.h"
#include "kernel/scaling/PoseRules.h"
#include "kernel/scaling/TautScaling.h"
#include "kernel/scaling/TopViewScaling.h"

namespace narrows
{
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
/// Tips between two questions whether to go on.
constexpr std::size_t patience = 64;

void require(bool condition, const char *what)
{
    if (!condition)
        throw std::invalid_argument(what);
}

void examine(const ScalingProblem &problem, const ScalingOptions &options)
{
    require(!problem.lengths.empty(), "a chain needs a link");
    for (const double length : problem.lengths)
        require(length > 0.0 && std::isfinite(length), "links need a length above 0");
    require(problem.radius >= 0.0 && std::isfinite(problem.radius), "a radius must not be negative");
    require(problem.maxAngle >= 0.0, "the largest link angle must not be negative");
    require(options.margins.empty() || options.margins.size() == problem.sections.size(),
            "every section needs a margin");
    require(options.behind.empty() || options.behind.size() == problem.sections.size(),
            "of every section it must be said whether it is behind");
    require(options.margin >= problem.radius && std::isfinite(options.margin) &&
                std::all_of(options.margins.begin(), options.margins.end(),
                            [&](double margin) { return margin >= problem.radius && std::isfinite(margin); }),
            "margins must not be less than the radius");
    require(options.maxJump > 0.0, "joints must be allowed to move");
}

std::unique_ptr<SectionScaling> makeScaling(const ScalingProblem &problem, const ScalingOptions &options)
{
    if (options.mode == ScalingMode::Taut)
        return std::make_unique<TautScaling>(problem, options);
    return std::make_unique<PlainScaling>(problem, options);
}

ScalingFault jump(const SectionChain &former, const SectionChain &chain, double maxJump)
{
    for (std::size_t i = 0; i < former.size(); ++i)
        if ((chain[i] - former[i]).squaredNorm() > maxJump * maxJump)
            return {ScalingFailure::Jump, static_cast<int>(i)};
    return {};
}

/// Step 1: how far from the slide a tip can be; beyond that psi_1 alone would have to turn a straight arm too far.
double reachOf(const ScalingProblem &problem)
{
    const double half = std::acos(0.0);
    return problem.reach() * std::sin(std::min(problem.maxAngle, half));
}

ScalingFault reachFault(const ScalingProblem &problem)
{
    return {ScalingFailure::Reach, static_cast<int>(problem.links()) - 1};
}

/// Steps 5 and 6 for one tip after another.
ScalingResult scaleOneByOne(const ScalingProblem &problem, const std::vector<Vector3d> &tips,
                            const ScalingOptions &options)
{
    const PoseRules rules(problem);
    const double reach = reachOf(problem);
    const std::unique_ptr<SectionScaling> scaling = makeScaling(problem, options);
    ScalingResult result;
    result.stride = problem.links() + 1;
    result.centres.resize(tips.size() * result.stride);
    SectionChain chain, former;
    std::size_t done = 0;
    for (std::size_t t = 0; t < tips.size() && (t % patience != 0 || !options.isInterrupted()); ++t)
    {
        Vector3d *const centres = result.centres.data() + done * result.stride;
        result.fault = tips[t].tail<2>().norm() <= reach ? ScalingFault{} : reachFault(problem);
        if (!result.fault || options.lateStart)  // the string has to go all the way
        {
            const ScalingFault fault = scaling->place(tips[t].tail<2>(), chain);
            result.fault = result.fault ? result.fault : fault;
        }
        if (!result.fault)
            result.fault = rules.lift(chain, tips[t].x(), centres);
        if (!result.fault)
            result.fault = rules.check(centres);
        if (!result.fault)
            result.fault = jump(former, chain, options.maxJump);
        if (result.fault && done == 0 && options.lateStart)
        {
            result.first = t + 1;
            continue;
        }
        if (result.fault)
            break;
        former = chain;
        ++done;
    }
    result.centres.resize(done * result.stride);
    return result;
}

ScalingFault baseFault(const ScalingProblem &problem, const ScalingOptions &options)
{
    for (std::size_t s = 0; s < problem.sections.size(); ++s)
        if (problem.sections[s].isCloser(Vector2d::Zero(), Vector2d::Zero(), options.marginOf(s)))
            return {ScalingFailure::BaseBlocked, -1, static_cast<int>(s)};
    return {};
}
}  // namespace

ScalingResult scalePath(const ScalingProblem &problem, const std::vector<Vector3d> &tips, const ScalingOptions &options)
{
    examine(problem, options);
    ScalingResult result;
    result.stride = problem.links() + 1;
    result.fault = baseFault(problem, options);
    if (result.fault)
        return result;
    if (problem.crossbars.empty() && options.mode != ScalingMode::Branch)
        return scaleOneByOne(problem, tips, options);
    const auto beyond =
        std::find_if(tips.begin(), tips.end(),
                     [reach = reachOf(problem)](const Vector3d &tip) { return tip.tail<2>().norm() > reach; });
    const std::vector<Vector3d> before(tips.begin(), beyond);
    result = problem.crossbars.empty() ? BranchScaling(problem, options).run(before)
                                       : TopViewScaling(problem, options).run(before);
    if (!result.fault && result.poses() == before.size() && beyond != tips.end())
        result.fault = reachFault(problem);
    return result;
}
}  // namespace narrows
