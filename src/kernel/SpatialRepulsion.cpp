// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialRepulsion.h"

#include <cmath>

#include "kernel/LinkTerm.h"

namespace narrows
{
struct SpatialRepulsion::Workspace
{
    SpatialArm::Placement placement;
    std::vector<EndForces> forces;
    std::vector<int> guesses;  ///< per obstacle and link, from the last evaluation of whatever repulsion
};

SpatialRepulsion::SpatialRepulsion(std::shared_ptr<const SpatialPoles> poles, const std::vector<double> &strengths)
  : poles_(std::move(poles))
{
    requireStrengths(strengths, poles_->groups().size(), "group of poles");
    for (std::size_t i = 0; i < poles_->obstacles().size(); ++i)
        if (strengths[i] != 0.0)
            sources_.push_back({&poles_->obstacles()[i], strengths[i]});
    if (poles_->limitGroup() >= 0)
        limitStrength_ = strengths[poles_->limitGroup()];
    if (poles_->selfGroup() >= 0)
        pairStrength_ = strengths[poles_->selfGroup()];
}

void SpatialRepulsion::evaluate(const Eigen::Ref<const Eigen::VectorXd> &q, Sample &sample) const
{
    static thread_local Workspace work;
    poles_->arm().place(q, work.placement);
    work.forces.assign(poles_->arm().links().size(), {});
    sample.value = 0.0;
    sample.poles.clear();
    addObstacles(work, sample);
    if (pairStrength_ != 0.0)
        addPairs(work, sample);
    gatherGradient(poles_->arm(), work.placement, work.forces, sample.gradient);
    if (limitStrength_ != 0.0)
        addLimits(q, sample);
}

void SpatialRepulsion::addObstacles(Workspace &work, Sample &sample) const
{
    const std::vector<SpatialLink> &links = poles_->arm().links();
    work.guesses.resize(sources_.size() * links.size(), -1);
    auto guess = work.guesses.begin();
    for (const Source &source : sources_)
        for (std::size_t i = 0; i < links.size(); ++i)
        {
            const double radius = links[i].radius;
            const double size = source.pole->size + 2.0 * radius;
            const SpatialTerm clearance = source.pole->smoothClearance(
                work.placement.points[2 * i], work.placement.points[2 * i + 1], radius, *guess++);
            const double pole = poleOf(clearance.value, size);
            const double share = source.strength / pole;
            sample.value += share;
            work.forces[i].add(-share / pole * poleSlope(clearance.value, size), clearance.slope);
            sample.poles.push_back(pole);
        }
}

void SpatialRepulsion::addPairs(Workspace &work, Sample &sample) const
{
    const std::vector<SpatialLink> &links = poles_->arm().links();
    for (const auto &[first, second] : poles_->pairs())
    {
        const SpatialPairTerm clearance = pairClearance(poles_->arm(), work.placement, first, second);
        const double size = poles_->pairSize() + 2.0 * (links[first].radius + links[second].radius);
        const double pole = poleOf(clearance.value, size);
        const double share = pairStrength_ / pole;
        const double slope = -share / pole * poleSlope(clearance.value, size);
        sample.value += share;
        work.forces[first].add(slope, clearance.first);
        work.forces[second].add(slope, clearance.second);
        sample.poles.push_back(pole);
    }
}

void SpatialRepulsion::addLimits(const Eigen::Ref<const Eigen::VectorXd> &q, Sample &sample) const
{
    const auto add = [&](double pole)
    {
        const double share = limitStrength_ / pole;
        sample.value += share;
        sample.poles.push_back(pole);
        return -share / pole;
    };
    for (const SpatialLimitPole &limit : poles_->limits())
        sample.gradient[limit.joint] += limit.sign * add(limit.sign * (q[limit.joint] - limit.bound));
    for (const UniversalLimit &limit : poles_->arm().universalLimits())
    {
        const double first = q[limit.first], second = q[limit.second];
        const double slope = add(std::cos(first) * std::cos(second) - std::cos(limit.maxAngle));
        sample.gradient[limit.first] -= slope * std::sin(first) * std::cos(second);
        sample.gradient[limit.second] -= slope * std::cos(first) * std::sin(second);
    }
}

double SpatialRepulsion::value(const Eigen::Ref<const Eigen::VectorXd> &q) const
{
    static thread_local Sample sample;
    evaluate(q, sample);
    return sample.value;
}
}  // namespace narrows
