// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "kernel/SpatialArm.h"

namespace narrows
{
/// A ball.
struct Sphere
{
    Eigen::Vector3d center;  ///< its middle
    double radius;           ///< > 0
};

/// All points within `radius` of the segment from `from` to `to`.
struct Capsule
{
    Eigen::Vector3d from;  ///< one end of the segment
    Eigen::Vector3d to;    ///< the other end
    double radius;         ///< > 0
};

/// A solid cylinder with flat ends, or without ends.
struct Cylinder
{
    Eigen::Vector3d center;  ///< its middle
    Eigen::Vector3d axis;    ///< unit vector
    double radius;           ///< > 0
    double halfLength;       ///< > 0, or infinity
};

/// A solid box, anyhow turned.
struct Box
{
    Eigen::Isometry3d pose;       ///< of its center
    Eigen::Vector3d halfExtents;  ///< all > 0
};

/// A convex polygon of the plane, extruded at right angles to it, with flat ends or without ends.
struct Prism
{
    std::vector<Eigen::Vector2d> vertices;  ///< counter-clockwise, convex, at least three, none twice
    Eigen::Isometry3d pose;                 ///< the section lies in its x and y, the extrusion goes along its z
    double halfLength;                      ///< of the extrusion, to both sides of the section; > 0, or infinity

    Eigen::Vector3d axis() const { return pose.linear().col(2); }  ///< unit vector
};

/// A surface of triangles. If it is closed, its inside belongs to the obstacle.
struct Mesh
{
    std::vector<Eigen::Vector3d> vertices;      ///< corners that triangles share
    std::vector<std::array<int, 3>> triangles;  ///< indices of vertices
    bool closed;                                ///< whether it encloses what is inside
};

/// A closed set that no link may touch.
struct SpatialObstacle
{
    std::string name;                                                 ///< unique in its scene
    std::variant<Sphere, Capsule, Cylinder, Box, Prism, Mesh> shape;  ///< what it occupies
};

/// Robot and obstacles in space: all that a white-box planner may see and a sampling planner may not.
struct SpatialModel
{
    SpatialArm arm;                          ///< the robot
    std::vector<SpatialObstacle> obstacles;  ///< closed sets, which may overlap
    bool selfCollision = false;              ///< links that are not neighbours must not touch each other
};

/// A goal that only fixes where the end (`to`) of one link shall be.
struct SpatialTipGoal
{
    int link;               ///< index of the link whose end is meant
    Eigen::Vector3d point;  ///< where it shall be
    double tolerance;       ///< > 0, a distance
};

/// A goal that fixes where the end (`to`) of one link shall be, one place after the other.
struct SpatialTipPath
{
    int link;                             ///< index of the link whose end is meant
    std::vector<Eigen::Vector3d> points;  ///< not empty; to be reached in this order
    double tolerance;                     ///< > 0, a distance; the same for all points
};

/// What is asked of the arm.
struct SpatialTask
{
    Eigen::VectorXd start;  ///< a configuration
    /// a configuration, or where a link's end shall be
    std::variant<Eigen::VectorXd, SpatialTipGoal, SpatialTipPath> goal;
};
}  // namespace narrows
