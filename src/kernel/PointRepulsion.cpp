// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PointRepulsion.h"

#include <stdexcept>

#include "kernel/LinkTerm.h"
#include "kernel/PoleArrays.h"

namespace narrows
{
using Eigen::Vector2d;

/// Tips of the links and what hangs on them; singular points with their sums of P / C and its derivatives.
struct PointRepulsion::Workspace
{
    std::vector<Vector2d> tips, carried;
    std::vector<double> x, y, values, forceX, forceY;
    std::vector<LinkForce> forces;
};

bool PointRepulsion::supports(const PlanarModel &model)
{
    for (const PlanarObstacle &obstacle : model.obstacles)
        if (std::holds_alternative<Polygon>(obstacle.shape))
            return false;
    return true;
}

PointRepulsion::PointRepulsion(const PlanarModel &model, const std::vector<double> &strengths, int pointsPerLink)
  : arm_(model.arm), pointsPerLink_(pointsPerLink)
{
    if (pointsPerLink < 1)
        throw std::invalid_argument("there must be at least one singular point per link");
    requireStrengths(strengths, model.obstacles.size(), "obstacle");
    if (!supports(model))
        throw std::invalid_argument("the paper has no obstacle function for polygons");
    for (int k = 1; k <= pointsPerLink; ++k)
        fractions_.push_back(static_cast<double>(k) / pointsPerLink);
    const double radius = model.arm.radius();
    for (std::size_t i = 0; i < strengths.size(); ++i)
    {
        if (const auto *circle = std::get_if<Circle>(&model.obstacles[i].shape))
        {
            const double grown = circle->radius + radius;
            poles_.push_back({true, circle->center, Vector2d::Zero(), grown * grown, 2.0, strengths[i]});
        }
        else
        {
            const auto &shape = std::get<Superellipse>(model.obstacles[i].shape);
            const Vector2d grown = shape.halfExtents + Vector2d::Constant(radius);
            poles_.push_back({false, shape.center, grown.cwiseInverse(), 0.0, shape.exponent, strengths[i]});
        }
    }
}

void PointRepulsion::evaluate(ConfigurationRef q, Sample &sample) const
{
    static thread_local Workspace work;
    arm_.place(q, work.tips);
    spreadPoints(work);
    addPoles(work, sample.poles);
    sample.value = 0.0;
    for (const double value : work.values)
        sample.value += value;
    gatherForces(work);
    gatherGradient(arm_, work.tips, work.forces, work.carried, sample.gradient);
}

/// The singular points of all links, link by link.
void PointRepulsion::spreadPoints(Workspace &work) const
{
    const std::size_t count = static_cast<std::size_t>(arm_.linkCount()) * pointsPerLink_;
    work.x.resize(count);
    work.y.resize(count);
    std::size_t i = 0;
    for (int t = 0; t < arm_.linkCount(); ++t)
    {
        const Vector2d base = work.tips[arm_.links()[t].parent + 1];
        const Vector2d along = work.tips[t + 1] - base;
        for (const double fraction : fractions_)
        {
            work.x[i] = base.x() + fraction * along.x();
            work.y[i] = base.y() + fraction * along.y();
            ++i;
        }
    }
}

void PointRepulsion::addPoles(Workspace &work, std::vector<double> &poles) const
{
    const std::size_t count = work.x.size();
    work.values.assign(count, 0.0);
    work.forceX.assign(count, 0.0);
    work.forceY.assign(count, 0.0);
    poles.resize(count * poles_.size());
    const PoleArrays points{
        count, work.x.data(), work.y.data(), work.values.data(), work.forceX.data(), work.forceY.data()};
    double *c = poles.data();
    for (const Pole &pole : poles_)
    {
        const Vector2d &center = pole.center;
        const Vector2d &inverse = pole.inverseExtents;
        if (pole.circle)
            addCirclePole(points, center.x(), center.y(), pole.squaredRadius, pole.strength, c);
        else if (pole.exponent == 4.0)
            addQuarticPole(points, center.x(), center.y(), inverse.x(), inverse.y(), pole.strength, c);
        else
            addPowerPole(points, center.x(), center.y(), inverse.x(), inverse.y(), pole.exponent, pole.strength, c);
        c += count;
    }
}

/// Sums up what acts on the points of every link.
void PointRepulsion::gatherForces(Workspace &work) const
{
    work.forces.assign(arm_.links().size(), {});
    std::size_t i = 0;
    for (LinkForce &sum : work.forces)
        for (const double fraction : fractions_)
        {
            sum.push(fraction, {work.forceX[i], work.forceY[i]});
            ++i;
        }
}

double PointRepulsion::value(ConfigurationRef q) const
{
    static thread_local Sample sample;
    evaluate(q, sample);
    return sample.value;
}
}  // namespace narrows
