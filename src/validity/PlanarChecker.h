// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// Answers, for one link at a time, whether it keeps away from all obstacles. Everything that says "free" in this
/// project (states and motions, for every planner) goes through this interface. Immutable, so that threads may share
/// one.
class PlanarChecker
{
public:
    virtual ~PlanarChecker() = default;

    /// True iff no obstacle comes within (link radius + margin) of the segment ab. Touching counts as a collision.
    /// \param margin >= 0
    virtual bool linkClears(const Eigen::Vector2d &a, const Eigen::Vector2d &b, double margin) const = 0;

    /// Distance from the link to the nearest obstacle: negative or zero iff they touch (then its size means nothing),
    /// +infinity without obstacles.
    virtual double linkClearance(const Eigen::Vector2d &a, const Eigen::Vector2d &b) const = 0;
};

/// Do all links of an arm clear the obstacles? `points` as from `PlanarArm::place`.
bool armClears(const PlanarChecker &checker, const PlanarArm &arm, const std::vector<Eigen::Vector2d> &points);

/// The least linkClearance over all links of an arm.
double armClearance(const PlanarChecker &checker, const PlanarArm &arm, const std::vector<Eigen::Vector2d> &points);

/// Closed-form geometry; the default.
std::unique_ptr<PlanarChecker> makeAnalyticChecker(const PlanarModel &model);

/// Flexible Collision Library: capsules against balls (circles), boxes and convex extrusions. It errs on the safe side:
/// by 2e-6 length units everywhere (1e-5 in linkClearance()), FCL's own resolution, and by less than 1e-3 of the
/// smaller half extent at superellipses, which circumscribed polygons stand for. \throws std::invalid_argument if a
/// polygon crosses itself.
std::unique_ptr<PlanarChecker> makeFclChecker(const PlanarModel &model);

/// Makes a checker by its name, "analytic" or "fcl".
/// \throws std::invalid_argument for any other name.
std::unique_ptr<PlanarChecker> makeChecker(const std::string &name, const PlanarModel &model);
}  // namespace narrows
