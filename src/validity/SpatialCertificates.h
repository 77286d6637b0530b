// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/MeshGeometry.h"
#include "validity/LinkChecker.h"

namespace narrows
{
/// What is certain of a link and one obstacle on a stretch of motion. `Clear` if they are further apart than the link
/// can reach, or if a plane keeps between them: one that rests, or, where the link passes the obstacle with its side,
/// one through the link that turns with it, kept parallel to the obstacle's edge if it is an edge that the link passes.
/// \param reach link.reach()
Finding examine(const LinkMotion<3> &link, double reach, const Sphere &sphere);
Finding examine(const LinkMotion<3> &link, double reach, const Capsule &capsule);
Finding examine(const LinkMotion<3> &link, double reach, const Cylinder &cylinder);
Finding examine(const LinkMotion<3> &link, double reach, const Box &box);
Finding examine(const LinkMotion<3> &link, double reach, const Prism &prism);
Finding examine(const LinkMotion<3> &link, double reach, const MeshGeometry &mesh);

/// The same of two links on one stretch.
/// \param reach sum of reach() of both
Finding examine(const LinkMotion<3> &link, const LinkMotion<3> &other, double reach);
}  // namespace narrows
