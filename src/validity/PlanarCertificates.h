// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/SuperellipseGeometry.h"
#include "validity/LinkChecker.h"

namespace narrows
{
/// What is certain of a link and one obstacle on a stretch of motion. `Clear` if they are further apart than the link
/// can reach, or if a line keeps between them: one that rests, or, where the link passes the obstacle with its side,
/// one that turns with the link. \param reach link.reach()
Finding examine(const LinkMotion<2> &link, double reach, const Circle &circle);
Finding examine(const LinkMotion<2> &link, double reach, const SuperellipseGeometry &shape);

/// The same of two links on one stretch. An edge of a polygon is a link without radius that rests.
/// \param reach sum of reach() of both
Finding examine(const LinkMotion<2> &link, const LinkMotion<2> &other, double reach);
}  // namespace narrows
