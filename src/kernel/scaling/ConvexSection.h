// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// What an obstacle covers of the section plane, which is at right angles to the slide of an arm: all points within
/// `radius` of the convex hull of some corners (one corner: a disc; two: a stadium), extruded along the slide over
/// `span`. Its DANGER REGION for a margin are the points closer than that.
class ConvexSection
{
public:
    /// Where a segment is nearest to a section.
    struct Contact
    {
        double distance;       ///< 0 if they meet
        double fraction;       ///< of the nearest point on the segment, in [0, 1]
        Eigen::Vector2d away;  ///< unit vector in which the segment leaves the section fastest, roughly if they meet
    };

    /// \param corners counter-clockwise and strictly convex if there are more than two
    /// \throws std::invalid_argument without a corner, for a negative radius, a span out of order, or what is not
    /// finite (the span may be infinite)
    ConvexSection(std::vector<Eigen::Vector2d> corners, double radius, Interval span = everywhere());

    /// The span without ends.
    static Interval everywhere()
    {
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }

    const std::vector<Eigen::Vector2d> &corners() const { return corners_; }  ///< counter-clockwise
    double radius() const { return radius_; }                                 ///< by which the corners' hull is thicker
    const Interval &span() const { return span_; }  ///< along the slide: where the section counts
    /// Centre of the corners' bounding box, a point of the section.
    const Eigen::Vector2d &center() const { return center_; }

    /// Distance of a point, 0 inside.
    double distance(const Eigen::Vector2d &point) const { return distance(point, point); }
    /// Distance of the segment ab, 0 if they meet.
    double distance(const Eigen::Vector2d &a, const Eigen::Vector2d &b) const;
    /// Where the segment ab is nearest.
    Contact contact(const Eigen::Vector2d &a, const Eigen::Vector2d &b) const;
    /// Is the segment ab closer than `gap` > 0? Cheap where it is far.
    bool isCloser(const Eigen::Vector2d &a, const Eigen::Vector2d &b, double gap) const;

    /// Where the line along the coordinate `axis` (0 or 1) on which the other coordinate is `height` crosses the danger
    /// region: the two values of the coordinate on its boundary. Nothing if the line misses it.
    std::optional<Interval> crossing(int axis, double height, double margin) const;

    /// A polygon inscribed in the danger region, counter-clockwise: every corner at the distance `margin`. Arcs become
    /// chords, 64 for a full turn.
    std::vector<Eigen::Vector2d> dangerPolygon(double margin) const;

private:
    double coreDistance(const Eigen::Vector2d &a, const Eigen::Vector2d &b) const;
    std::size_t next(std::size_t corner) const { return corner + 1 == corners_.size() ? 0 : corner + 1; }

    std::vector<Eigen::Vector2d> corners_;
    double radius_;
    Interval span_;
    Eigen::Vector2d center_;
    double bound_;  ///< radius of a circle about the centre that contains the section
};

/// Convex hull of points, counter-clockwise, without corners of 180 degrees.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);
}  // namespace narrows
