// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/MeshGaps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "kernel/MeshGeometry.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// A place on a surface and where it looks.
struct Look
{
    Vector3d from;
    Vector3d direction;  ///< unit vector
};

struct Hit
{
    double distance;
    Vector3d normal;
};

constexpr double squareEnough = 0.7071;  ///< cosine of the angle at which what is hit may look back
constexpr double sameDirection = 0.866;  ///< cosine
constexpr double start = 1e-9;           ///< of the ray, before its own face

Vector3d normalOf(const Triangle &corners)
{
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

/// From the middle of every face, and from every corner; both ways from surfaces that enclose nothing.
std::vector<Look> looksOf(const Mesh &mesh)
{
    std::vector<Look> looks;
    std::vector<Vector3d> normals(mesh.vertices.size(), Vector3d::Zero());
    for (const auto &triangle : mesh.triangles)
    {
        const auto corner = [&](int i) -> const Vector3d &
        {
            return mesh.vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i)])];
        };
        const Vector3d normal = normalOf({corner(0), corner(1), corner(2)});
        looks.push_back({(corner(0) + corner(1) + corner(2)) / 3.0, normal.normalized()});
        for (const int vertex : triangle)
            normals[static_cast<std::size_t>(vertex)] += normal.normalized();
    }
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (normals[i].norm() > 0.0)
            looks.push_back({mesh.vertices[i], normals[i].normalized()});
    const std::size_t outwards = looks.size();
    for (std::size_t i = 0; !mesh.closed && i < outwards; ++i)
        looks.push_back({looks[i].from, -looks[i].direction});
    return looks;
}

/// Where the line of a look goes through a triangle.
std::optional<double> crossing(const Look &look, const Triangle &corners)
{
    constexpr double slack = 1e-9;  // rays to where triangles meet shall not slip between them
    const Vector3d one = corners[1] - corners[0], other = corners[2] - corners[0];
    const Vector3d aside = look.direction.cross(other);
    const double determinant = one.dot(aside);
    if (determinant == 0.0)
        return std::nullopt;
    const Vector3d apart = look.from - corners[0], turned = apart.cross(one);
    const double u = apart.dot(aside) / determinant, v = look.direction.dot(turned) / determinant;
    if (!(u >= -slack && v >= -slack && u + v <= 1.0 + slack))
        return std::nullopt;
    return other.dot(turned) / determinant;
}

class Surroundings
{
public:
    Surroundings(const std::vector<const Mesh *> &meshes, const std::vector<SpatialShape> &shapes, double range)
      : shapes_(shapes), range_(range)
    {
        for (const Mesh *mesh : meshes)
            meshes_.emplace_back(*mesh);
    }

    /// What a look meets first.
    std::optional<Hit> first(const Look &look) const
    {
        Hit hit{range_, Vector3d::Zero()};
        for (const MeshGeometry &mesh : meshes_)
            mesh.visitWithin(look.from, look.from + range_ * look.direction, 0.0,
                             [&](const Triangle &corners, const Nearness &)
                             {
                                 const std::optional<double> way = crossing(look, corners);
                                 if (way && *way > start * range_ && *way < hit.distance)
                                     hit = {*way, normalOf(corners).normalized()};
                                 return true;
                             });
        for (const SpatialShape &shape : shapes_)
            goInto(shape, look, hit);
        return hit.distance < range_ ? std::optional(hit) : std::nullopt;
    }

private:
    static void goInto(const SpatialShape &shape, const Look &look, Hit &hit)
    {
        // Every step leaves out what the distance says is free.
        constexpr int most = 60;
        double way = 0.0;
        for (int i = 0; i < most && way < hit.distance; ++i)
        {
            const Vector3d point = look.from + way * look.direction;
            const Nearness near = shape.nearest(point, point);
            way += std::max(near.distance, 0.0);
            if (near.distance > 1e-12)
                continue;
            if (way < hit.distance)
                hit = {way, near.normal};
            return;
        }
    }

    const std::vector<SpatialShape> &shapes_;
    double range_;
    std::vector<MeshGeometry> meshes_;
};
}  // namespace

void addMeshGaps(const std::vector<const Mesh *> &meshes, const std::vector<SpatialShape> &shapes, double thinnest,
                 double widest, std::vector<SpatialGap> &gaps)
{
    const Surroundings surroundings(meshes, shapes, 2.0 * (widest + thinnest));
    std::vector<SpatialGap> found;
    for (const Mesh *mesh : meshes)
        for (const Look &look : looksOf(*mesh))
        {
            const std::optional<Hit> hit = surroundings.first(look);
            if (!hit || 0.5 * hit->distance <= thinnest)
                continue;
            // A surface that encloses nothing has no outside to look from.
            const double back = -hit->normal.dot(look.direction);
            if ((mesh->closed ? back : std::abs(back)) > squareEnough)
                found.push_back({look.from + 0.5 * hit->distance * look.direction, look.direction, Vector3d::Zero(),
                                 0.0, 0.5 * hit->distance, 0.5 * hit->distance});
        }
    std::stable_sort(found.begin(), found.end(),
                     [](const SpatialGap &a, const SpatialGap &b) { return a.halfDistance < b.halfDistance; });
    const std::size_t others = gaps.size();
    for (const SpatialGap &gap : found)
        if (std::none_of(gaps.begin() + static_cast<std::ptrdiff_t>(others), gaps.end(),
                         [&](const SpatialGap &kept) {
                             return std::abs(kept.axis.dot(gap.axis)) > sameDirection &&
                                    (kept.middle - gap.middle).norm() < widest;
                         }))
            gaps.push_back(gap);
}
}  // namespace narrows
