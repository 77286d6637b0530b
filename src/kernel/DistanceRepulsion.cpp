// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/DistanceRepulsion.h"

namespace narrows
{
struct DistanceRepulsion::Workspace
{
    std::vector<Eigen::Vector2d> points, carried;
    std::vector<Segment> links;
    std::vector<LinkForce> forces;
};

DistanceRepulsion::DistanceRepulsion(std::shared_ptr<const PlanarPoles> poles, const std::vector<double> &strengths)
  : poles_(std::move(poles))
{
    requireStrengths(strengths, poles_->groups().size(), "group of poles");
    poleCount_ = 0;
    for (std::size_t i = 0; i < poles_->obstacles().size(); ++i)
    {
        if (strengths[i] == 0.0)
            continue;
        const LinkObstacle *shape = poles_->obstacles()[i].get();
        if (const auto *circle = dynamic_cast<const CircleObstacle *>(shape))
            circles_.push_back({*circle, strengths[i], poleCount_});
        else
            shapes_.push_back({shape, strengths[i], poleCount_});
        poleCount_ += poles_->arm().links().size();
    }
    limitOffset_ = poleCount_;
    if (poles_->limitGroup() >= 0)
        limitStrength_ = strengths[poles_->limitGroup()];
    if (limitStrength_ != 0.0)
        poleCount_ += poles_->limits().size();
    pairOffset_ = poleCount_;
    if (poles_->selfGroup() >= 0)
        pairStrength_ = strengths[poles_->selfGroup()];
    if (pairStrength_ != 0.0)
        poleCount_ += poles_->pairs().size();
}

void DistanceRepulsion::evaluate(ConfigurationRef q, Sample &sample) const
{
    static thread_local Workspace work;
    poles_->arm().place(q, work.points);
    poles_->segments(work.points, work.links);
    work.forces.assign(work.links.size(), {});
    sample.poles.resize(poleCount_);
    addObstacles(work, sample);
    if (pairStrength_ != 0.0)
        addPairs(work, sample);
    gatherGradient(poles_->arm(), work.points, work.forces, work.carried, sample.gradient);
    if (limitStrength_ != 0.0)
        addLimits(q, sample);
}

void DistanceRepulsion::addObstacles(Workspace &work, Sample &sample) const
{
    const std::size_t count = work.links.size();
    const Segment *links = work.links.data();
    LinkForce *forces = work.forces.data();
    double sum = 0.0;
    for (const Circles &circle : circles_)
    {
        double *poles = &sample.poles[circle.offset];
        for (std::size_t t = 0; t < count; ++t)
            poles[t] = circle.shape.addPole(links[t], circle.strength, sum, forces[t]);
    }
    for (const Shapes &shape : shapes_)
        for (std::size_t t = 0; t < count; ++t)
        {
            const LinkTerm term = shape.shape->pole(links[t]);
            const double share = shape.strength / term.value;
            sum += share;
            forces[t].add(-share / term.value, term.slope);
            sample.poles[shape.offset + t] = term.value;
        }
    sample.value = sum;
}

void DistanceRepulsion::addPairs(Workspace &work, Sample &sample) const
{
    const double radius = 2.0 * poles_->arm().radius();
    for (std::size_t i = 0; i < poles_->pairs().size(); ++i)
    {
        const SelfPair &pair = poles_->pairs()[i];
        const PairTerm term = pairPole(work.links[pair.first], work.links[pair.second], radius, poles_->pairSize());
        const double share = pairStrength_ / term.value;
        sample.value += share;
        work.forces[pair.first].add(-share / term.value, term.first);
        work.forces[pair.second].add(-share / term.value, term.second);
        sample.poles[pairOffset_ + i] = term.value;
    }
}

void DistanceRepulsion::addLimits(ConfigurationRef q, Sample &sample) const
{
    for (std::size_t i = 0; i < poles_->limits().size(); ++i)
    {
        const LimitPole &limit = poles_->limits()[i];
        const double room = limit.value(q);
        const double share = limitStrength_ / room;
        const double slope = -limit.sign * share / room;
        sample.value += share;
        sample.gradient[limit.joint] += slope;
        if (limit.parent >= 0)
            sample.gradient[limit.parent] -= slope;
        sample.poles[limitOffset_ + i] = room;
    }
}

double DistanceRepulsion::value(ConfigurationRef q) const
{
    static thread_local Sample sample;
    evaluate(q, sample);
    return sample.value;
}
}  // namespace narrows
