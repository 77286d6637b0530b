// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "validity/SupportDistance.h"

namespace narrows::proof
{
/// A convex set that stands for an obstacle or for part of it, or a box around two other parts.
template <int Dim>
struct Part
{
    ConvexSet<Dim> set;
    int obstacle;          ///< its index in the model
    int firstInBox = -1;   ///< what a box is around; -1 if this is no box ...
    int secondInBox = -1;  ///< ... but belongs to the obstacle itself

    bool isBox() const { return firstInBox >= 0; }
};

/// The parts of all obstacles of a model.
template <int Dim>
struct Parts
{
    std::vector<Part<Dim>> all;
    std::vector<int> outermost;  ///< those that no box contains

    void add(ConvexSet<Dim> set, int obstacle)
    {
        outermost.push_back(static_cast<int>(all.size()));
        all.push_back({std::move(set), obstacle});
    }
};

/// An obstacle becomes itself or, if it is a polygon that is not convex, its edges. A link that keeps away from them
/// keeps away from the obstacle, provided that it is not enclosed.
Parts<2> partsOf(const std::vector<PlanarObstacle> &obstacles, double extent);

/// A mesh becomes its triangles, in boxes. \param extent no link gets further than this from the origin: what is
/// further away of endless cylinders and prisms is left out
/// \throws std::invalid_argument if a mesh is said to be closed and has an edge that does not join two triangles of the
/// same orientation
Parts<3> partsOf(const std::vector<SpatialObstacle> &obstacles, double extent);

/// Whether a polygon or a closed mesh has the point inside. Always false for other shapes; on the boundary, either
/// answer.
bool encloses(const PlanarObstacle &obstacle, const Eigen::Vector2d &point);
bool encloses(const SpatialObstacle &obstacle, const Eigen::Vector3d &point);
}  // namespace narrows::proof
