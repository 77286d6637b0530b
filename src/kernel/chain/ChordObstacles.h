// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <type_traits>
#include <vector>

#include "kernel/LinkObstacle.h"
#include "kernel/MeshGeometry.h"
#include "kernel/SpatialModel.h"

namespace narrows
{
/// How an obstacle lies to a segment.
template <int D>
struct ChordContact
{
    double distance;  ///< of the segment from the obstacle; negative where they meet, by about the least way apart
    double fraction;  ///< where on the segment, 0 at its first end, 1 at its second
    Eigen::Matrix<double, D, 1> normal;  ///< unit vector: how `distance` changes with that point
    bool convex;  ///< the obstacle is: outside of it, it lies beyond the plane across `normal` at that distance
};

/// One obstacle as segments see it.
template <int D>
class ChordShape;

/// The obstacles of a scene, prepared for exact distances from many segments (links of a chain): a tree of boxes, so
/// that only what is near is looked at. Immutable and thread-safe.
template <int D>
class ChordObstacles
{
public:
    using Point = Eigen::Matrix<double, D, 1>;                                     ///< in the plane or in space
    using Obstacle = std::conditional_t<D == 2, PlanarObstacle, SpatialObstacle>;  ///< of that dimension

    /// \throws std::invalid_argument for a mesh that MeshGeometry refuses
    explicit ChordObstacles(std::vector<Obstacle> obstacles);
    ~ChordObstacles();
    /// Leaves the other without obstacles.
    ChordObstacles(ChordObstacles &&) noexcept;
    /// Leaves the other without obstacles.
    ChordObstacles &operator=(ChordObstacles &&) noexcept;

    const std::vector<Obstacle> &obstacles() const { return obstacles_; }  ///< as they were given

    /// Adds the contact of every obstacle that is less than `room` (>= 0) from the segment ab, a != b.
    void contacts(const Point &a, const Point &b, double room, std::vector<ChordContact<D>> &found) const;

    /// The least distance of the segment ab, a != b, from any obstacle, or `atMost` if that is less; negative where
    /// they meet.
    double clearance(const Point &a, const Point &b, double atMost) const;

    /// The same of a point: at most 1e-9 less than its distance.
    double clearance(const Point &point, double atMost) const
    {
        return clearance(point, point + 1e-9 * Point::UnitX(), atMost);
    }

    /// Box around all obstacles; sides may be infinitely far away. Empty (lower above upper) if there are none.
    const Point &lower() const { return lower_; }
    const Point &upper() const { return upper_; }  ///< the other corner

private:
    /// A leaf has one obstacle; an inner node has the next node and node `second` as its children.
    struct Node
    {
        Point lower;
        Point upper;
        int obstacle;  ///< -1 for inner nodes
        int second;
    };

    int build(std::vector<int> &order, int begin, int end);
    template <class Visit>
    void descend(const Point &a, const Point &b, const double &room, const Visit &visit) const;

    std::vector<Obstacle> obstacles_;
    std::vector<ChordShape<D>> shapes_;
    std::vector<Node> nodes_;
    Point lower_;
    Point upper_;
};

extern template class ChordObstacles<2>;
extern template class ChordObstacles<3>;
}  // namespace narrows
