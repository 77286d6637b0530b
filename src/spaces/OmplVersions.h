// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/config.h>
#include <ompl/geometric/PathSimplifier.h>

#include "spaces/Ompl.h"

namespace narrows
{
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
