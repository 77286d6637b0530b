// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ObstacleSections.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

namespace narrows
{
namespace
{
using CgalPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double parallel = 1e-9;  ///< directions this close, by sine, are one
constexpr int circleCorners = 48;

std::vector<Vector2d> hullOf(const std::vector<Vector3d> &points)
{
    std::vector<CgalPoint> projected, hull;
    for (const Vector3d &point : points)
        projected.emplace_back(point.y(), point.z());
    CGAL::convex_hull_2(projected.begin(), projected.end(), std::back_inserter(hull));
    std::vector<Vector2d> corners;
    for (const CgalPoint &point : hull)
        corners.emplace_back(point.x(), point.y());
    return corners;
}

Interval spanOf(const std::vector<Vector3d> &points, double radius)
{
    Interval span{points[0].x(), points[0].x()};
    for (const Vector3d &point : points)
        span = {std::min(span.lower, point.x()), std::max(span.upper, point.x())};
    return {span.lower - radius, span.upper + radius};
}

/// Projects shapes that are given in the world.
class Projector
{
public:
    Projector(const ChainGeometry &chain, ScalingProblem &problem)
      : origin_(chain.origin),
        axes_(slideAxes(chain)),
        reach_(problem.reach() + problem.radius),
        slide_(problem.slide),
        problem_(problem)
    {
    }

    void operator()(const Sphere &sphere) { addHull({local(sphere.center)}, sphere.radius); }

    void operator()(const Capsule &capsule)
    {
        const Vector3d from = local(capsule.from);
        const Vector3d to = local(capsule.to);
        if (!addCrossbar(from, to, capsule.radius))
            addHull({from, to}, capsule.radius);
    }

    void operator()(const Cylinder &cylinder)
    {
        const Vector3d center = local(cylinder.center);
        const Vector3d axis = axes_.transpose() * cylinder.axis;
        if (axis.tail<2>().norm() < parallel)
        {
            const Interval span{center.x() - cylinder.halfLength, center.x() + cylinder.halfLength};
            add(ConvexSection({center.tail<2>()}, cylinder.radius, span));
            return;
        }
        const Vector3d half = std::min(cylinder.halfLength, beyond(center)) * axis;
        if (!addCrossbar(center - half, center + half, cylinder.radius))
            addHull(ringed({center - half, center + half}, axis, cylinder.radius), 0.0);
    }

    void operator()(const Box &box)
    {
        std::vector<Vector3d> corners;
        for (int i = 0; i < 8; ++i)
        {
            const Vector3d signs(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
            corners.push_back(local(box.pose * signs.cwiseProduct(box.halfExtents)));
        }
        addHull(corners, 0.0);
    }

    void operator()(const Prism &prism)
    {
        const Vector3d axis = axes_.transpose() * prism.axis();
        std::vector<Vector3d> corners;
        for (const Vector2d &vertex : prism.vertices)
            corners.push_back(local(prism.pose * Vector3d(vertex.x(), vertex.y(), 0.0)));
        if (axis.tail<2>().norm() < parallel)
        {
            const Interval span = spanOf(corners, prism.halfLength);
            add(ConvexSection(hullOf(corners), 0.0, span));
            return;
        }
        std::vector<Vector3d> ends;
        for (const Vector3d &corner : corners)
            for (const double sign : {-1.0, 1.0})
                ends.push_back(corner + sign * std::min(prism.halfLength, beyond(corner)) * axis);
        addHull(ends, 0.0);
    }

    void operator()(const Mesh &mesh)
    {
        std::vector<Vector3d> points;
        for (const Vector3d &vertex : mesh.vertices)
            points.push_back(local(vertex));
        if (!points.empty())
            addHull(points, 0.0);
    }

private:
    Vector3d local(const Vector3d &point) const { return axes_.transpose() * (point - origin_); }

    /// How far an endless shape has to go on from a point to be out of everyone's reach.
    double beyond(const Vector3d &point) const
    {
        const double slide = std::max(std::abs(slide_.lower), std::abs(slide_.upper));
        return point.norm() + 2.0 * (reach_ + (std::isfinite(slide) ? slide : 0.0));
    }

    /// Points whose hull contains discs of that radius at right angles to the axis.
    static std::vector<Vector3d> ringed(const std::vector<Vector3d> &centers, const Vector3d &axis, double radius)
    {
        const Vector3d first = axis.unitOrthogonal();
        const Vector3d second = axis.cross(first);
        const double step = 2.0 * std::acos(-1.0) / circleCorners;
        const double outer = radius / std::cos(0.5 * step);
        std::vector<Vector3d> points;
        for (const Vector3d &center : centers)
            for (int i = 0; i < circleCorners; ++i)
                points.push_back(center + outer * (std::cos(i * step) * first + std::sin(i * step) * second));
        return points;
    }

    bool addCrossbar(const Vector3d &from, const Vector3d &to, double radius)
    {
        const Vector2d way = (to - from).tail<2>();
        if (std::abs(to.x() - from.x()) > parallel * way.norm() || way.norm() == 0.0)
            return false;
        const Vector2d along = way.normalized();
        // The ends must be where no tip can go round them.
        if (along.dot(from.tail<2>()) > -reach_ || along.dot(to.tail<2>()) < reach_)
            return false;
        const Vector2d across(along.y(), -along.x());
        if (isInReach({from.x() - radius, from.x() + radius}))
            problem_.crossbars.push_back({from.x(), across.dot(from.tail<2>()), across, radius});
        return true;
    }

    void addHull(const std::vector<Vector3d> &points, double radius)
    {
        add(ConvexSection(hullOf(points), radius, spanOf(points, radius)));
    }

    void add(ConvexSection section)
    {
        if (isInReach(section.span()) && section.distance(Vector2d::Zero()) < reach_)
            problem_.sections.push_back(std::move(section));
    }

    bool isInReach(const Interval &span) const
    {
        return span.lower < slide_.upper + reach_ && span.upper > slide_.lower - reach_;
    }

    Vector3d origin_;
    Eigen::Matrix3d axes_;
    double reach_;
    Interval slide_;
    ScalingProblem &problem_;
};
}  // namespace

void addObstacles(const std::vector<SpatialObstacle> &obstacles, const ChainGeometry &chain, ScalingProblem &problem)
{
    Projector project(chain, problem);
    for (const SpatialObstacle &obstacle : obstacles)
        std::visit(project, obstacle.shape);
}
}  // namespace narrows
