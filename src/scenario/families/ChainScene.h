// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenario/families/RoomWalls.h"

namespace narrows
{
/// A chain of equal links on a slide that is fed through an entrance into rooms (tight maneuvering), and what its tip
/// shall reach. At the start it lies straight behind its tip, on the slide's line: upwards (y) in the plane, along x in
/// space.
template <int D>
struct ChainScene
{
    using Point = typename AxisBox<D>::Point;

    int links;
    double length;                   ///< of a link
    double radius;                   ///< half-width of a link
    std::optional<double> maxAngle;  ///< between neighbouring links, in degrees
    std::vector<AxisBox<D>> walls;
    Point entrance;  ///< where the tip is at the start
    double depth;    ///< > 0, how far beyond it the slide may take the base
    Point goal;
    double tolerance;  ///< of the goal, a distance

    double reach() const { return links * length; }
};

/// The longest link that a right-angle bend lets through, between corridors of one width (w) and for links of
/// half-width r: sqrt(2) (2 (w - r) - sqrt(2) r). The link then lies at 45 degrees, touches the inner corner and both
/// outer walls.
double longestLinkAtBend(double width, double radius);

/// The scenario file of the scene.
std::string toYaml(const ChainScene<2> &scene, const std::string &name, const std::string &source);
std::string toYaml(const ChainScene<3> &scene, const std::string &name, const std::string &source);
}  // namespace narrows
