// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/TriangleDistance.h"
#include "validity/LinkChecker.h"

namespace narrows
{
/// Whether a plane through a link keeps between it and a shape on a stretch of motion. The plane turns with the link;
/// where the link passes an edge, or something round, it stays parallel to that.
/// \param near how the link lies to the shape in the middle of the stretch, with its inside
bool passes(const LinkMotion<3> &link, const Nearness &near, const Sphere &sphere);
bool passes(const LinkMotion<3> &link, const Nearness &near, const Capsule &capsule);
bool passes(const LinkMotion<3> &link, const Nearness &near, const Cylinder &cylinder);
bool passes(const LinkMotion<3> &link, const Nearness &near, const Box &box);
bool passes(const LinkMotion<3> &link, const Nearness &near, const Prism &prism);
bool passes(const LinkMotion<3> &link, const Nearness &near, const Triangle &triangle);
}  // namespace narrows
