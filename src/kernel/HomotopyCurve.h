// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// A point of (or near) a homotopy curve. `evaluate` fills everything but z from z.
struct CurvePoint
{
    Eigen::VectorXd z;          ///< n + 1 unknowns; the last is lambda * lambdaScale()
    Eigen::VectorXd residual;   ///< H(z), n equations
    Eigen::MatrixXd jacobian;   ///< dH/dz, n x (n + 1)
    std::vector<double> poles;  ///< see Repulsion::Sample
    Eigen::VectorXd w;          ///< the robot's configuration at z
};

/// n equations H(z) = 0 in n + 1 unknowns, whose solutions are curves; one of them leads through the start (lambda =
/// 0). Knows no robot and no planner. Immutable.
class HomotopyCurve
{
public:
    virtual ~HomotopyCurve() = default;

    virtual int equations() const = 0;  ///< n, one less than the unknowns
    /// What one unit of lambda counts for in the length of a step.
    virtual double lambdaScale() const = 0;
    virtual Eigen::VectorXd startPoint() const = 0;  ///< z, with lambda = 0
    virtual Eigen::VectorXd goalPoint() const = 0;   ///< z, with lambda = 1
    /// H, its Jacobian and the poles at point.z.
    virtual void evaluate(CurvePoint &point) const = 0;
    /// The robot's configuration at z.
    virtual void configuration(const Eigen::VectorXd &z, Eigen::VectorXd &w) const = 0;
};
}  // namespace narrows
