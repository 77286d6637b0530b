// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "kernel/SpatialModel.h"

namespace narrows
{
/// The arm of the VDSM paper (Jia et al. 2022; lengths in mm) among endless pipes and prisms along x, the direction of
/// its slide. It starts straight, with its tip over the origin of their section, the plane of y and z.
struct PipeScene
{
    using Section = std::variant<Cylinder, Prism>;  ///< both without ends, along x

    static constexpr double armRadius = 61.5;
    static constexpr double armLength = 3126.0;

    std::vector<Section> sections;
    std::vector<Eigen::Vector2d> tips;  ///< (y, z): where the tip shall go, one place after the other, at x = armLength
};

/// A pipe around (y, z).
PipeScene::Section pipeAround(const Eigen::Vector2d &center, double radius);

/// A prism over a section of (y, z). \param vertices convex, counter-clockwise with y to the right and z up
PipeScene::Section prismOver(std::vector<Eigen::Vector2d> vertices);

/// Between a section and a point (y, z), and between two sections; not positive where they meet.
double distance(const PipeScene::Section &section, const Eigen::Vector2d &point);
double distance(const PipeScene::Section &one, const PipeScene::Section &other);

/// The scenario file of the scene.
std::string toYaml(const PipeScene &scene, const std::string &name, const std::string &source);
}  // namespace narrows
