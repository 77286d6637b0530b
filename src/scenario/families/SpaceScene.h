// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "kernel/SpatialModel.h"
#include "scenario/families/ArmScene.h"

namespace narrows
{
/// An arm in space among boxes, and a task for it: what the families of arms that thread openings draw. Without slide;
/// the base is the origin.
struct SpaceScene
{
    /// An axis-parallel box.
    struct Wall
    {
        Eigen::Vector3d lower;
        Eigen::Vector3d upper;
    };
    /// Lengths of links on universal joints.
    using Chain = std::vector<double>;
    using Table = std::vector<DenavitHartenberg>;

    std::variant<Chain, Table> robot;
    double radius = 0.0;  ///< of links that have none of their own
    std::vector<Wall> walls;
    Eigen::VectorXd start;
    Eigen::VectorXd goal;
    std::vector<Eigen::VectorXd> witness;  ///< waypoints of a free path from start to goal
};

/// Walls at right angles to x, `halfThickness` to both sides of `x`, with a rectangular opening in the middle of a
/// large square. Where the opening is as wide as the square there are two walls instead of four.
void addOpening(SpaceScene &scene, const Eigen::Vector3d &middle, const Eigen::Vector2d &halfOpening,
                double halfThickness, double halfSquare);

SpatialModel modelOf(const SpaceScene &scene);

/// See ArmScene.h. Links that do not meet at a joint must not touch each other.
double clearance(const SpaceScene &scene, const Eigen::VectorXd &q);
Motion judgePath(const SpaceScene &scene, const std::vector<Eigen::VectorXd> &path);
Motion judgeMotion(const SpaceScene &scene, const Eigen::VectorXd &from, const Eigen::VectorXd &to);

/// The scenario file of the scene.
std::string toYaml(const SpaceScene &scene, const std::string &name, const std::string &source);
}  // namespace narrows
