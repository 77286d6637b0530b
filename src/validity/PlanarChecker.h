// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kernel/PlanarModel.h"
#include "validity/LinkChecker.h"

namespace narrows
{
using PlanarChecker = LinkChecker<2>;  ///< in the plane

/// Closed-form geometry; the default.
std::unique_ptr<PlanarChecker> makeAnalyticChecker(const PlanarModel &model);

/// Flexible Collision Library: capsules against balls (circles), boxes and convex extrusions. It errs on the safe side:
/// by 2e-6 length units everywhere (1e-5 in clearance()), FCL's own resolution, and by less than 1e-3 of the smaller
/// half extent at superellipses, which circumscribed polygons stand for. Motions are examined to first order only: a
/// library that answers yes or no has no line to show. \throws std::invalid_argument if a polygon crosses itself.
std::unique_ptr<PlanarChecker> makeFclChecker(const PlanarModel &model);
}  // namespace narrows
