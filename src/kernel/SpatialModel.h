// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "kernel/SpatialArm.h"

namespace narrows
{
struct Sphere
{
    Eigen::Vector3d center;
    double radius;  ///< > 0
};

/// All points within `radius` of the segment from `from` to `to`.
struct Capsule
{
    Eigen::Vector3d from;
    Eigen::Vector3d to;
    double radius;  ///< > 0
};

/// A solid cylinder with flat ends, or without ends.
struct Cylinder
{
    Eigen::Vector3d center;
    Eigen::Vector3d axis;  ///< unit vector
    double radius;         ///< > 0
    double halfLength;     ///< > 0, or infinity
};

struct Box
{
    Eigen::Isometry3d pose;       ///< of its center
    Eigen::Vector3d halfExtents;  ///< all > 0
};

/// A surface of triangles. If it is closed, its inside belongs to the obstacle.
struct Mesh
{
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<int, 3>> triangles;
    bool closed;
};

/// A closed set that no link may touch.
struct SpatialObstacle
{
    std::string name;  ///< unique in its scene
    std::variant<Sphere, Capsule, Cylinder, Box, Mesh> shape;
};

struct SpatialModel
{
    SpatialArm arm;
    std::vector<SpatialObstacle> obstacles;
    bool selfCollision = false;  ///< links that are not neighbours must not touch each other
};

/// A goal that only fixes where the end (`to`) of one link shall be.
struct SpatialTipGoal
{
    int link;
    Eigen::Vector3d point;
    double tolerance;  ///< > 0, a distance
};

struct SpatialTask
{
    Eigen::VectorXd start;
    std::variant<Eigen::VectorXd, SpatialTipGoal> goal;
};
}  // namespace narrows
