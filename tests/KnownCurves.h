// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kernel/HomotopyCurve.h"

namespace narrows
{
/// A curve known in closed form: the unknowns are the configuration, the last of them is lambda.
class KnownCurve : public HomotopyCurve
{
public:
    /// Fills residual and jacobian (of the right sizes) and poles (empty) from z.
    using System = std::function<void(CurvePoint &)>;

    KnownCurve(const Eigen::VectorXd &start, const Eigen::VectorXd &goal, System system)
      : start_(start), goal_(goal), system_(std::move(system))
    {
    }

    int equations() const override { return static_cast<int>(start_.size()) - 1; }
    double lambdaScale() const override { return 1.0; }
    Eigen::VectorXd startPoint() const override { return start_; }
    Eigen::VectorXd goalPoint() const override { return goal_; }
    void configuration(const Eigen::VectorXd &z, Eigen::VectorXd &w) const override { w = z; }
    void evaluate(CurvePoint &point) const override
    {
        point.w = point.z;
        point.residual.resize(equations());
        point.jacobian.resize(equations(), equations() + 1);
        point.poles.clear();
        system_(point);
    }

private:
    Eigen::VectorXd start_, goal_;
    System system_;
};

/// Phi(s, lambda) and its two derivatives.
struct Level
{
    double value, bys, byLambda;
};

/// The level line Phi(s, lambda) = 0 in the plane z = (s, lambda).
inline KnownCurve levelLine(double startS, double goalS, const std::function<Level(double, double)> &phi)
{
    return KnownCurve(Eigen::Vector2d(startS, 0.0), Eigen::Vector2d(goalS, 1.0),
                      [phi](CurvePoint &point)
                      {
                          const Level level = phi(point.z[0], point.z[1]);
                          point.residual[0] = level.value;
                          point.jacobian << level.bys, level.byLambda;
                      });
}

/// The graph lambda = p(s) over s, from s = 0 with p(0) = 0 to a goal where p = 1.
/// \param derivative p'
inline KnownCurve graph(double goalS, const std::function<double(double)> &p,
                        const std::function<double(double)> &derivative)
{
    return levelLine(0.0, goalS,
                     [p, derivative](double s, double lambda) {
                         return Level{p(s) - lambda, derivative(s), -1.0};
                     });
}
}  // namespace narrows
