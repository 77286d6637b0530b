// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "kernel/SpatialModel.h"

namespace narrows
{
/// Signed distances of single points, from the definitions of the shapes: an oracle that shares nothing with the
/// kernel's distances of segments.
struct PointDistance
{
    Eigen::Vector3d point;

    double operator()(const Sphere &sphere) const { return (point - sphere.center).norm() - sphere.radius; }

    double operator()(const Capsule &capsule) const
    {
        double least = std::min((point - capsule.from).norm(), (point - capsule.to).norm());
        const Eigen::Vector3d along = (capsule.to - capsule.from).normalized();
        const double place = along.dot(point - capsule.from);
        if (place > 0.0 && place < (capsule.to - capsule.from).norm())
            least = std::min(least, along.cross(point - capsule.from).norm());
        return least - capsule.radius;
    }

    double operator()(const Cylinder &cylinder) const
    {
        const Eigen::Vector2d excess(cylinder.axis.cross(point - cylinder.center).norm() - cylinder.radius,
                                     std::abs(cylinder.axis.dot(point - cylinder.center)) - cylinder.halfLength);
        return excess.maxCoeff() <= 0.0 ? excess.maxCoeff() : excess.cwiseMax(0.0).norm();
    }

    double operator()(const Box &box) const
    {
        const Eigen::Vector3d excess = (box.pose.inverse() * point).cwiseAbs() - box.halfExtents;
        return excess.maxCoeff() <= 0.0 ? excess.maxCoeff() : excess.cwiseMax(0.0).norm();
    }

    double operator()(const Prism &prism) const
    {
        const Eigen::Vector3d local = prism.pose.inverse() * point;
        const Eigen::Vector2d excess(fromSection(prism.vertices, local.head<2>()),
                                     std::abs(local.z()) - prism.halfLength);
        return excess.maxCoeff() <= 0.0 ? excess.maxCoeff() : excess.cwiseMax(0.0).norm();
    }

private:
    /// Beyond all sides the nearest side or corner counts, within all of them the nearest side's line.
    static double fromSection(const std::vector<Eigen::Vector2d> &vertices, const Eigen::Vector2d &x)
    {
        double inside = -std::numeric_limits<double>::infinity(), outside = -inside;
        for (std::size_t i = 0; i < vertices.size(); ++i)
        {
            const Eigen::Vector2d &from = vertices[i], &to = vertices[(i + 1) % vertices.size()];
            const Eigen::Vector2d along = (to - from).normalized(), outward(along.y(), -along.x());
            inside = std::max(inside, outward.dot(x - from));
            outside = std::min(outside, (x - from).norm());
            if (along.dot(x - from) > 0.0 && along.dot(x - to) < 0.0)
                outside = std::min(outside, std::abs(outward.dot(x - from)));
        }
        return inside <= 0.0 ? inside : outside;
    }
};

/// The surface of a box as a closed mesh, each side cut into n x n squares of two triangles.
inline Mesh boxMesh(const Box &box, int n)
{
    Mesh mesh{{}, {}, true};
    const auto vertex = [&](const Eigen::Vector3d &corner)
    {
        const Eigen::Vector3d place =
            box.pose * Eigen::Vector3d(box.halfExtents.cwiseProduct(2.0 / n * corner - Eigen::Vector3d::Ones()));
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
            if ((mesh.vertices[i] - place).norm() < 1e-9)
                return static_cast<int>(i);
        mesh.vertices.push_back(place);
        return static_cast<int>(mesh.vertices.size()) - 1;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                {
                    const auto at = [&](int di, int dj)
                    {
                        Eigen::Vector3d corner;
                        corner[axis] = side;
                        corner[(axis + 1) % 3] = i + di;
                        corner[(axis + 2) % 3] = j + dj;
                        return vertex(corner);
                    };
                    std::array<int, 3> one{at(0, 0), at(1, 0), at(1, 1)}, other{at(0, 0), at(1, 1), at(0, 1)};
                    if (side == 0)
                    {
                        std::swap(one[1], one[2]);
                        std::swap(other[1], other[2]);
                    }
                    mesh.triangles.push_back(one);
                    mesh.triangles.push_back(other);
                }
    return mesh;
}

inline Eigen::Vector3d randomPoint(double range, std::mt19937 &generator)
{
    std::uniform_real_distribution<double> uniform(-range, range);
    return {uniform(generator), uniform(generator), uniform(generator)};
}

inline Box randomBox(std::mt19937 &generator)
{
    Eigen::Isometry3d pose(
        Eigen::AngleAxisd(randomPoint(3.0, generator).x(), randomPoint(1.0, generator).normalized()));
    pose.pretranslate(randomPoint(0.3, generator));
    return {pose, Eigen::Vector3d::Constant(0.05) + randomPoint(1.0, generator).cwiseAbs()};
}

inline Cylinder randomCylinder(bool infinite, std::mt19937 &generator)
{
    const Eigen::Vector3d sizes = Eigen::Vector3d::Constant(0.05) + randomPoint(1.0, generator).cwiseAbs();
    return {randomPoint(0.3, generator), randomPoint(1.0, generator).normalized(), sizes.x(),
            infinite ? std::numeric_limits<double>::infinity() : sizes.y()};
}

/// Three to eight corners on an ellipse, which the origin of the section need not be in.
inline Prism randomPrism(bool infinite, std::mt19937 &generator)
{
    const Box box = randomBox(generator);
    std::uniform_real_distribution<double> uniform(0.2, 1.0);
    std::vector<double> angles(3 + generator() % 6);
    double sum = 0.0;
    for (double &angle : angles)
        angle = sum += uniform(generator);
    const Eigen::Vector2d center = randomPoint(0.5, generator).head<2>();
    Prism prism{{}, box.pose, infinite ? std::numeric_limits<double>::infinity() : box.halfExtents.z()};
    for (const double angle : angles)
    {
        const double turn = 2.0 * std::acos(-1.0) * angle / sum;
        prism.vertices.push_back(
            center + box.halfExtents.head<2>().cwiseProduct(Eigen::Vector2d(std::cos(turn), std::sin(turn))));
    }
    return prism;
}
}  // namespace narrows
