// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

#include "kernel/PlanarModel.h"
#include "kernel/SpatialModel.h"

/// What the verifier asks about the values of joints.
namespace narrows::proof
{
/// Radians or lengths: a joint that rests at its limit may be beyond it by this after conversions.
constexpr double limitTolerance = 1e-9;

/// Joint values of an arm in the plane, in the convention of the limits.
class PlanarRules
{
public:
    PlanarRules(const PlanarArm &arm, const JointLimits &limits) : arm_(arm), limits_(limits) {}

    /// Whether every joint and the slide are where they may be. All permitted rows form a convex set.
    bool within(const Eigen::VectorXd &row) const;

    /// Whether two rows are the same up to full turns of joints without limits.
    bool same(const Eigen::VectorXd &row, const Eigen::VectorXd &other, double tolerance) const;

private:
    std::optional<Interval> limitOf(int link) const;
    double joint(const Eigen::VectorXd &row, int link) const;

    const PlanarArm &arm_;
    const JointLimits &limits_;
};

/// The same for an arm in space.
class SpatialRules
{
public:
    explicit SpatialRules(const SpatialArm &arm);

    bool within(const Eigen::VectorXd &row) const;
    bool same(const Eigen::VectorXd &row, const Eigen::VectorXd &other, double tolerance) const;

private:
    const SpatialArm &arm_;
    std::vector<bool> turnsFreely_;  ///< per joint
};
}  // namespace narrows::proof
