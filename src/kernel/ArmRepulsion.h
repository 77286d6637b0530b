// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// The paper's singular projections: W(w) = sum over obstacles, links and points of P / C (HPPM-PRA, Eq. 23), where C
/// is the obstacle function at a point of a link: |p - c|^2 - r^2 for circles, |x/a|^e + |y/b|^e - 1 for superellipses.
/// Obstacles grow by the link radius. Immutable and thread-safe; callers keep the Sample.
class ArmRepulsion
{
public:
    /// W and all that the trackers ask about it at one configuration.
    struct Sample
    {
        double value = 0.0;
        Eigen::VectorXd gradient;   ///< dW/dq, one entry per joint
        std::vector<double> poles;  ///< C per obstacle, link and point, in that nesting; positive outside

        // Workspace: tips of the links and what hangs on them; singular points with their sums of P / C and its
        // derivatives.
        std::vector<Eigen::Vector2d> tips, carried;
        std::vector<double> x, y, values, forceX, forceY;
    };

    /// \param strengths P per obstacle and point, in the order of the obstacles; any sign
    /// \param pointsPerLink n >= 1; the points lie at 1/n, 2/n, ..., 1 of each link (Eq. 20)
    /// \throws std::invalid_argument for a wrong count, a strength that is not finite, or an obstacle for which the
    /// paper has no function (polygons).
    ArmRepulsion(const PlanarModel &model, const std::vector<double> &strengths, int pointsPerLink);

    /// Whether the paper has a function for every obstacle of the model.
    static bool supports(const PlanarModel &model);

    int dimension() const { return arm_.dimension(); }

    void evaluate(ConfigurationRef q, Sample &sample) const;

    /// W alone.
    double value(ConfigurationRef q) const;

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

    void spreadPoints(Sample &sample) const;
    void addPoles(Sample &sample) const;
    void gatherGradient(Sample &sample) const;

    PlanarArm arm_;
    std::vector<Pole> poles_;
    int pointsPerLink_;
    std::vector<double> fractions_;  ///< k / n
};
}  // namespace narrows
