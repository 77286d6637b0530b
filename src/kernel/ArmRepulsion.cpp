// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/ArmRepulsion.h"

#include <cmath>
#include <stdexcept>

namespace narrows
{
using Eigen::Vector2d;

namespace
{
/// C and its gradient at a point. A template only to name a private type; inlined into the one loop that matters.
template <typename Pole>
inline double obstacleFunction(const Pole &pole, const Vector2d &point, Vector2d &slope)
{
    const double x = point.x() - pole.center.x();
    const double y = point.y() - pole.center.y();
    if (pole.circle)
    {
        slope = Vector2d(2.0 * x, 2.0 * y);
        return x * x + y * y - pole.squaredRadius;
    }
    const double u = x * pole.inverseExtents.x();
    const double v = y * pole.inverseExtents.y();
    if (pole.exponent == 4.0)
    {
        const double uCubed = u * u * u;
        const double vCubed = v * v * v;
        slope = Vector2d(4.0 * uCubed * pole.inverseExtents.x(), 4.0 * vCubed * pole.inverseExtents.y());
        return uCubed * u + vCubed * v - 1.0;
    }
    const double uPower = std::pow(std::abs(u), pole.exponent - 1.0);
    const double vPower = std::pow(std::abs(v), pole.exponent - 1.0);
    slope = Vector2d(pole.exponent * std::copysign(uPower, u) * pole.inverseExtents.x(),
                     pole.exponent * std::copysign(vPower, v) * pole.inverseExtents.y());
    return uPower * std::abs(u) + vPower * std::abs(v) - 1.0;
}
}  // namespace

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
    const int links = arm_.linkCount();
    const int first = arm_.firstAngle();
    double value = 0.0;
    sample.gradient.setZero(arm_.dimension());
    sample.poles.resize(static_cast<std::size_t>(links) * pointsPerLink_ * poles_.size());
    sample.forces.assign(links + 1, Vector2d::Zero());
    arm_.place(q, sample.points);

    double *pole = sample.poles.data();
    for (int t = 0; t < links; ++t)
    {
        const Vector2d base = sample.points[arm_.links()[t].parent + 1];
        const Vector2d along = sample.points[t + 1] - base;
        const Vector2d across(-along.y(), along.x());  // derivative of `along` over the link's angle
        Vector2d force = Vector2d::Zero();
        double torque = 0.0;
        for (int k = 1; k <= pointsPerLink_; ++k)
        {
            const double fraction = static_cast<double>(k) / pointsPerLink_;
            const Vector2d point = base + fraction * along;
            Vector2d pull = Vector2d::Zero();
            for (const Pole &obstacle : poles_)
            {
                Vector2d slope;
                const double c = obstacleFunction(obstacle, point, slope);
                *pole++ = c;
                const double inverse = 1.0 / c;
                const double term = obstacle.strength * inverse;
                value += term;
                pull -= (term * inverse) * slope;
            }
            force += pull;
            torque += fraction * pull.dot(across);
        }
        sample.gradient[first + t] = torque;
        sample.forces[t + 1] = force;
    }

    sample.value = value;

    // A link's angle also moves everything that hangs on its tip: pass the forces down the tree.
    for (int t = links - 1; t >= 0; --t)
    {
        const int parent = arm_.links()[t].parent + 1;
        if (parent > 0)
        {
            const int grand = arm_.links()[parent - 1].parent + 1;
            const Vector2d along = sample.points[parent] - sample.points[grand];
            sample.gradient[first + parent - 1] +=
                along.x() * sample.forces[t + 1].y() - along.y() * sample.forces[t + 1].x();
        }
        sample.forces[parent] += sample.forces[t + 1];
    }
    if (arm_.slide())
        sample.gradient[0] = arm_.slide()->axis.dot(sample.forces[0]);
}

double ArmRepulsion::value(ConfigurationRef q) const
{
    Sample sample;
    evaluate(q, sample);
    return sample.value;
}
}  // namespace narrows
