// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/ArmRepulsion.h"

#include <cmath>
#include <stdexcept>

#include "kernel/PoleArrays.h"

namespace narrows
{
using Eigen::Vector2d;

bool ArmRepulsion::supports(const PlanarModel &model)
{
    for (const PlanarObstacle &obstacle : model.obstacles)
        if (std::holds_alternative<Polygon>(obstacle.shape))
            return false;
    return true;
}

ArmRepulsion::ArmRepulsion(const PlanarModel &model, const std::vector<double> &strengths, int pointsPerLink)
  : arm_(model.arm), pointsPerLink_(pointsPerLink)
{
    if (pointsPerLink < 1)
        throw std::invalid_argument("there must be at least one singular point per link");
    if (strengths.size() != model.obstacles.size())
        throw std::invalid_argument("there must be one repulsion per obstacle");
    if (!supports(model))
        throw std::invalid_argument("the paper has no obstacle function for polygons");
    for (int k = 1; k <= pointsPerLink; ++k)
        fractions_.push_back(static_cast<double>(k) / pointsPerLink);
    const double radius = model.arm.radius();
    for (std::size_t i = 0; i < strengths.size(); ++i)
    {
        if (!std::isfinite(strengths[i]))
            throw std::invalid_argument("a repulsion must be finite");
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

void ArmRepulsion::evaluate(ConfigurationRef q, Sample &sample) const
{
    arm_.place(q, sample.tips);
    spreadPoints(sample);
    addPoles(sample);
    sample.value = 0.0;
    for (const double value : sample.values)
        sample.value += value;
    gatherGradient(sample);
}

/// The singular points of all links, link by link.
void ArmRepulsion::spreadPoints(Sample &sample) const
{
    const std::size_t count = static_cast<std::size_t>(arm_.linkCount()) * pointsPerLink_;
    sample.x.resize(count);
    sample.y.resize(count);
    std::size_t i = 0;
    for (int t = 0; t < arm_.linkCount(); ++t)
    {
        const Vector2d base = sample.tips[arm_.links()[t].parent + 1];
        const Vector2d along = sample.tips[t + 1] - base;
        for (const double fraction : fractions_)
        {
            sample.x[i] = base.x() + fraction * along.x();
            sample.y[i] = base.y() + fraction * along.y();
            ++i;
        }
    }
}

void ArmRepulsion::addPoles(Sample &sample) const
{
    const std::size_t count = sample.x.size();
    sample.values.assign(count, 0.0);
    sample.forceX.assign(count, 0.0);
    sample.forceY.assign(count, 0.0);
    sample.poles.resize(count * poles_.size());
    const PoleArrays points{
        count, sample.x.data(), sample.y.data(), sample.values.data(), sample.forceX.data(), sample.forceY.data()};
    double *c = sample.poles.data();
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

/// A link's angle moves its own points and everything that hangs on its tip: forces are passed down the tree.
void ArmRepulsion::gatherGradient(Sample &sample) const
{
    const int first = arm_.firstAngle();
    sample.gradient.resize(arm_.dimension());
    sample.carried.assign(sample.tips.size(), Vector2d::Zero());
    for (int t = arm_.linkCount() - 1; t >= 0; --t)
    {
        const int parent = arm_.links()[t].parent + 1;
        const Vector2d along = sample.tips[t + 1] - sample.tips[parent];
        Vector2d force = sample.carried[t + 1];
        Vector2d lever = force;  // forces weighted by how far out on the link they act
        const std::size_t begin = static_cast<std::size_t>(t) * pointsPerLink_;
        for (std::size_t k = 0; k < fractions_.size(); ++k)
        {
            const Vector2d own(sample.forceX[begin + k], sample.forceY[begin + k]);
            force += own;
            lever += fractions_[k] * own;
        }
        sample.gradient[first + t] = along.x() * lever.y() - along.y() * lever.x();
        sample.carried[parent] += force;
    }
    if (arm_.slide())
        sample.gradient[0] = arm_.slide()->axis.dot(sample.carried[0]);
}

double ArmRepulsion::value(ConfigurationRef q) const
{
    Sample sample;
    evaluate(q, sample);
    return sample.value;
}
}  // namespace narrows
