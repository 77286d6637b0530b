// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/config.h>
#include <ompl/geometric/PathSimplifier.h>

#include "spaces/Ompl.h"

namespace narrows
{
/// Is it OMPL 2? Some of its planners do what they did not do in 1.5.2.
inline constexpr bool isOmpl2 = OMPL_VERSION_VALUE >= 2000000;

/// What OMPL calls differently from version to version. Shortcuts between random points of a path.
inline bool shortcutRandomly(og::PathSimplifier &simplifier, og::PathGeometric &path)
{
#if OMPL_VERSION_VALUE >= 1007000
    return simplifier.partialShortcutPath(path);
#else
    return simplifier.shortcutPath(path);
#endif
}
}  // namespace narrows
