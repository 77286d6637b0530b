// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarModel.h"
#include "kernel/Repulsion.h"

namespace narrows
{
/// The paper's singular projections: W(w) = sum over obstacles, links and points of P / C (HPPM-PRA, Eq. 23), where C
/// is the obstacle function at a point of a link: |p - c|^2 - r^2 for circles, |x/a|^e + |y/b|^e - 1 for superellipses.
/// Obstacles grow by the link radius. Poles are C per obstacle, link and point, in that nesting.
class PointRepulsion : public Repulsion
{
public:
    /// \param strengths P per obstacle and point, in the order of the obstacles; any sign
    /// \param pointsPerLink n >= 1; the points lie at 1/n, 2/n, ..., 1 of each link (Eq. 20)
    /// \throws std::invalid_argument for a wrong count, a strength that is not finite, or an obstacle for which the
    /// paper has no function (polygons).
    PointRepulsion(const PlanarModel &model, const std::vector<double> &strengths, int pointsPerLink);

    /// Whether the paper has a function for every obstacle of the model.
    static bool supports(const PlanarModel &model);

    int dimension() const override { return arm_.dimension(); }
    /// W and its derivative, and the poles.
    void evaluate(ConfigurationRef q, Sample &sample) const override;
    /// W alone.
    double value(ConfigurationRef q) const override;

private:
    struct Pole
    {
        bool circle;
        Eigen::Vector2d center;
        Eigen::Vector2d inverseExtents;  ///< superellipse
        double squaredRadius;            ///< circle
        double exponent;                 ///< superellipse
        double strength;
    };
    struct Workspace;

    void spreadPoints(Workspace &work) const;
    void addPoles(Workspace &work, std::vector<double> &poles) const;
    void gatherForces(Workspace &work) const;

    PlanarArm arm_;
    std::vector<Pole> poles_;
    int pointsPerLink_;
    std::vector<double> fractions_;  ///< k / n
};
}  // namespace narrows
