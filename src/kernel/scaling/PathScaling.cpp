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

/// Steps 5 and 6 for one tip after another.
ScalingResult scaleOneByOne(const ScalingProblem &problem, const std::vector<Vector3d> &tips,
                            const ScalingOptions &options)
{
    const PoseRules rules(problem);
    const std::unique_ptr<SectionScaling> scaling = makeScaling(problem, options);
    ScalingResult result;
    result.stride = problem.links() + 1;
    result.centres.resize(tips.size() * result.stride);
    SectionChain chain, former;
    std::size_t done = 0;
    for (; done < tips.size() && (done % patience != 0 || !options.isInterrupted()); ++done)
    {
        Vector3d *const centres = result.centres.data() + done * result.stride;
        result.fault = scaling->place(tips[done].tail<2>(), chain);
        if (!result.fault)
            result.fault = rules.lift(chain, tips[done].x(), centres);
        if (!result.fault)
            result.fault = rules.check(centres);
        if (!result.fault)
            result.fault = jump(former, chain, options.maxJump);
        if (result.fault)
            break;
        former = chain;
    }
    result.centres.resize(done * result.stride);
    return result;
}

/// Step 1 for one tip: what no mode can reach, as psi_1 alone would have to turn a straight arm there.
bool isInReach(const ScalingProblem &problem, const Vector3d &tip)
{
    const double half = std::acos(0.0);
    const double radius = problem.reach() * std::sin(std::min(problem.maxAngle, half));
    return tip.tail<2>().norm() <= radius;
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
    const auto reached =
        std::find_if(tips.begin(), tips.end(), [&](const Vector3d &tip) { return !isInReach(problem, tip); });
    if (reached != tips.end())
    {
        const std::vector<Vector3d> before(tips.begin(), reached);
        ScalingResult result = before.empty() ? ScalingResult{} : scalePath(problem, before, options);
        result.stride = problem.links() + 1;
        if (!result.fault)
            result.fault = {ScalingFailure::Reach, static_cast<int>(problem.links()) - 1};
        return result;
    }
    if (const ScalingFault fault = baseFault(problem, options))
        return {{}, problem.links() + 1, fault};
    if (!problem.crossbars.empty())
        return TopViewScaling(problem, options).run(tips);
    if (options.mode == ScalingMode::Branch)
        return BranchScaling(problem, options).run(tips);
    return scaleOneByOne(problem, tips, options);
}
}  // namespace narrows
