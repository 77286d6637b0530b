// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "validity/ConvexSets.h"

namespace narrows::proof
{
/// Whether every edge is run through equally often in both directions, so that the mesh has an inside.
bool isClosed(const Mesh &mesh);

/// How often a closed mesh goes around a point: 0 outside, 1 or -1 inside, more where it overlaps itself; any number
/// for points on it.
double turnsAround(const Mesh &mesh, const Eigen::Vector3d &point);

/// Adds the triangles of a mesh in a binary tree of boxes.
void addTriangles(const Mesh &mesh, int obstacle, Parts<3> &parts);
}  // namespace narrows::proof
