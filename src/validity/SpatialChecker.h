// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kernel/SpatialModel.h"
#include "validity/LinkChecker.h"

namespace narrows
{
using SpatialChecker = LinkChecker<3>;  ///< in space

/// Closed-form geometry and, for meshes, a tree of boxes; the default.
std::unique_ptr<SpatialChecker> makeAnalyticChecker(const SpatialModel &model);

/// Flexible Collision Library: capsules against its own shapes. It errs on the safe side, by 2e-6 length units (1e-5 in
/// clearance()), FCL's own resolution. Motions are examined to first order only. Whether a link is inside a closed mesh
/// is not asked of FCL, which knows surfaces only.
std::unique_ptr<SpatialChecker> makeFclChecker(const SpatialModel &model);
}  // namespace narrows
