// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "kernel/TriangleDistance.h"

namespace narrows
{
/// A mesh prepared for distances: a tree of boxes over its triangles. Immutable and thread-safe.
class MeshGeometry
{
public:
    /// \throws std::invalid_argument if there are no triangles, a vertex does not exist or is not finite, or the mesh
    /// is said to be closed and some edge does not belong to exactly two triangles, once in each direction.
    explicit MeshGeometry(const Mesh &mesh);

    /// Corner of the box around it with the least coordinates.
    const Eigen::Vector3d &lower() const { return nodes_[0].lower; }
    const Eigen::Vector3d &upper() const { return nodes_[0].upper; }  ///< the one with the greatest

    /// Whether the surface winds around the point, which is not on it. Always false for open meshes.
    bool contains(const Eigen::Vector3d &point) const;

    /// How a segment lies to the mesh. Inside a closed mesh, or through a surface, the distance is negative, but its
    /// size only means that contact is near where it is small.
    /// \param guess a triangle that may be the nearest one (any number will do); becomes the nearest one. Who asks
    /// about one place after the other gets answers sooner with the last guess; they are the same.
    Nearness nearest(const Eigen::Vector3d &a, const Eigen::Vector3d &b, int *guess = nullptr) const;

    /// Whether nothing of the mesh is within `room` (>= 0) of the segment.
    bool keepsAway(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double room) const;

    /// Calls visit(triangle, nearness) for all triangles that can be within `room` of the segment, while it says true.
    /// \return whether it always did
    template <class Visit>
    bool visitWithin(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double room, const Visit &visit) const
    {
        const SegmentView segment(a, b);
        return descend([&](const Node &node) { return segment.leastDistance(node); }, room,
                       [&](const Face &face)
                       { return segment.isBeyond(face, room) || visit(face.corners, nearness(a, b, face.corners)); });
    }

private:
    /// A triangle and a ball around it.
    struct Face
    {
        Face(const Triangle &triangle, unsigned ownEdges);

        Triangle corners;
        unsigned edges;  ///< of those that two triangles share, one has each; as for nearness()
        Eigen::Vector3d center;
        double radius;
    };

    /// A leaf has triangles; an inner node has the next node and node `second` as its children.
    struct Node
    {
        Eigen::Vector3d lower;
        Eigen::Vector3d upper;
        double radius;  ///< half the diagonal
        int begin;
        int end;  ///< == begin for inner nodes
        int second;
    };

    /// A segment, prepared for quick looks at many boxes.
    class SegmentView
    {
    public:
        SegmentView(const Eigen::Vector3d &a, const Eigen::Vector3d &b);

        /// A lower bound of the distance from all in a node's box.
        double leastDistance(const Node &node) const;
        /// Whether a triangle is certainly further away than `limit`.
        bool isBeyond(const Face &face, double limit) const
        {
            return squaredDistance(face.center) > (limit + face.radius) * (limit + face.radius);
        }

    private:
        double squaredDistance(const Eigen::Vector3d &point) const
        {
            const Eigen::Vector3d apart = point - from_;
            const double fraction = std::min(std::max(along_.dot(apart) * inverseSquare_, 0.0), 1.0);
            return (apart - fraction * along_).squaredNorm();
        }

        Eigen::Vector3d from_, along_, lower_, upper_;
        double inverseSquare_;
    };

    int build(int begin, int end);

    /// Goes through all nodes whose bound(node) is at most `limit`, which may shrink on the way, the smaller bound
    /// first, and calls visit(face) in their leaves while it says true.
    template <class Bound, class Visit>
    bool descend(const Bound &bound, const double &limit, const Visit &visit) const
    {
        struct Pending
        {
            int node;
            double bound;
        };
        std::array<Pending, 64> pending;  // the tree is balanced
        int count = 0;
        pending[count++] = {0, bound(nodes_[0])};
        while (count > 0)
        {
            const Pending next = pending[--count];
            if (next.bound > limit)
                continue;
            const Node &node = nodes_[next.node];
            for (int i = node.begin; i < node.end; ++i)
                if (!visit(faces_[i]))
                    return false;
            if (node.begin < node.end)
                continue;
            Pending near{next.node + 1, bound(nodes_[next.node + 1])}, far{node.second, bound(nodes_[node.second])};
            if (far.bound < near.bound)
                std::swap(near, far);
            pending[count++] = far;
            pending[count++] = near;
        }
        return true;
    }

    std::vector<Face> faces_;
    std::vector<Node> nodes_;
    bool closed_;
};
}  // namespace narrows
