// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/BranchScaling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace narrows
{
using Eigen::Vector2d;
using Eigen::Vector3d;

BranchScaling::BranchScaling(const ScalingProblem &problem, const ScalingOptions &options)
  : problem_(problem),
    options_(options),
    rules_(problem),
    lines_(problem, options),
    fractions_(problem.fractions()),
    chain_(problem.links() + 1, Vector2d::Zero()),
    centres_(problem.links() + 1)
{
}

ScalingResult BranchScaling::run(const std::vector<Vector3d> &tips)
{
    ScalingResult result;
    result.stride = problem_.links() + 1;
    for (const Vector3d &tip : tips)
    {
        if (options_.isInterrupted())
            break;
        found_.clear();
        fault_ = {};
        chain_.back() = tip.tail<2>();
        centres_.back() = tip;
        extend(problem_.links());
        Layer layer;
        layer.chains = std::move(found_);
        const bool any = !layer.chains.empty();
        if (!any || !connect(layer))
        {
            result.fault = any ? ScalingFault{ScalingFailure::Jump} : fault_;
            break;
        }
        layers_.push_back(std::move(layer));
    }
    append(layers_.size(), tips, result);
    return result;
}

/// Places joint - 1, given the joints from `joint` on (counted from 0), in all ways.
void BranchScaling::extend(std::size_t joint)
{
    if (joint == 1)
    {
        place(0, Vector2d::Zero());
        return;
    }
    std::vector<Vector2d> points;
    std::size_t alongY = 0;
    lines_.candidates(fractions_[joint - 1] / fractions_[joint] * chain_[joint], points, alongY);
    if (points.empty())
        fail(ScalingFailure::NoCandidate, joint - 1);
    for (const Vector2d &point : points)
        place(joint - 1, point);
}

void BranchScaling::place(std::size_t joint, const Vector2d &point)
{
    if (found_.size() >= mostChains)
        return;
    const double length = problem_.lengths[joint];
    const double rest = length * length - (chain_[joint + 1] - point).squaredNorm();
    if (!(rest > 0.0))
        return fail(ScalingFailure::Span, joint);
    chain_[joint] = point;
    centres_[joint] = Vector3d(centres_[joint + 1].x() - std::sqrt(rest), point.x(), point.y());
    const Vector3d link = centres_[joint + 1] - centres_[joint];
    if (joint + 1 < problem_.links() &&
        rules_.isBent(link, centres_[joint + 2] - centres_[joint + 1], length * problem_.lengths[joint + 1]))
        return fail(ScalingFailure::LinkAngle, joint + 1);
    const int section = rules_.blockingSection(centres_[joint], centres_[joint + 1]);
    if (section >= 0)
        return fail(ScalingFailure::LinkClearance, joint, section);
    if (joint > 0)
        return extend(joint);
    if (const ScalingFault fault = rules_.check(centres_.data()))
        return fail(fault.failure, 0, fault.section);
    found_.push_back(chain_);
}

void BranchScaling::fail(ScalingFailure failure, std::size_t link, int section)
{
    if (!fault_ || static_cast<int>(link) < fault_.link)
        fault_ = {failure, static_cast<int>(link), section};
}

/// Leaves the chains that can be reached from the layer before, with the cheapest way. False if there are none.
bool BranchScaling::connect(Layer &layer)
{
    if (layers_.empty())
    {
        layer.parents.assign(layer.chains.size(), 0);
        layer.costs.assign(layer.chains.size(), 0.0);
        return true;
    }
    const Layer &former = layers_.back();
    Layer reached;
    for (SectionChain &chain : layer.chains)
    {
        double best = std::numeric_limits<double>::infinity();
        std::size_t parent = 0;
        for (std::size_t p = 0; p < former.chains.size(); ++p)
        {
            double cost = former.costs[p];
            double jump = 0.0;
            for (std::size_t i = 0; i < chain.size(); ++i)
            {
                const double way = (chain[i] - former.chains[p][i]).norm();
                cost += way;
                jump = std::max(jump, way);
            }
            if (jump <= options_.maxJump && cost < best)
            {
                best = cost;
                parent = p;
            }
        }
        if (best == std::numeric_limits<double>::infinity())
            continue;
        reached.chains.push_back(std::move(chain));
        reached.parents.push_back(parent);
        reached.costs.push_back(best);
    }
    layer = std::move(reached);
    return !layer.chains.empty();
}

/// Traces the cheapest way back from the last layer and lifts it.
void BranchScaling::append(std::size_t tipCount, const std::vector<Vector3d> &tips, ScalingResult &result) const
{
    if (tipCount == 0)
        return;
    result.centres.resize(tipCount * result.stride);
    const std::vector<double> &costs = layers_.back().costs;
    std::size_t index = static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
    for (std::size_t t = tipCount; t-- > 0;)
    {
        rules_.lift(layers_[t].chains[index], tips[t].x(), result.centres.data() + t * result.stride);
        index = layers_[t].parents[index];
    }
}
}  // namespace narrows
