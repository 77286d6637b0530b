// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenario/families/RandomNumbers.h"
#include "scenario/families/RoomWalls.h"

namespace narrows
{
/// Ducts of scenes in space are square, this wide.
constexpr double ductWidth = 40.0;

/// The rooms of a duct along a line of axis-parallel pieces, each with half a width beyond its ends.
std::vector<AxisBox<3>> ductAlong(const std::vector<Eigen::Vector3d> &line);

double lengthOfLine(const std::vector<Eigen::Vector3d> &line);

/// The point of a line so far from its beginning; its end if it is shorter.
Eigen::Vector3d pointOfLine(const std::vector<Eigen::Vector3d> &line, double way);

/// Where a random duct may go: through the points of a lattice between these indices, both included. The lattice is so
/// wide that walls half a duct thick remain between parallel pieces.
struct DuctLattice
{
    static constexpr double pitch = 1.5 * ductWidth;

    Eigen::Vector3d origin;
    Eigen::Vector3i lowest;
    Eigen::Vector3i highest;

    Eigen::Vector3d at(const Eigen::Vector3i &index) const { return origin + pitch * index.cast<double>(); }
};

/// The middle of a duct with so many right-angle bends, each to a random side. It begins at the lattice's index 0 with
/// a piece along x; all pieces are 2 to 4 pitches long, and it does not meet itself. \throws std::invalid_argument if
/// no such line was found in many draws
std::vector<Eigen::Vector3d> drawDuct(RandomNumbers &random, int bends, const DuctLattice &lattice);
}  // namespace narrows
