// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/ChordObstacles.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "kernel/ConvexParts.h"
#include "kernel/SpatialBounds.h"
#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

Bounds boundsOf(const PlanarObstacle &obstacle)
{
    return bounds(obstacle);
}

SpatialBounds boundsOf(const SpatialObstacle &obstacle)
{
    return spatialBounds(obstacle);
}

/// Middle of an interval for sorting only; sides at infinity count as very far.
double middle(double lower, double upper)
{
    constexpr double far = 1e30;
    return std::max(lower, -far) + std::min(upper, far);
}
}  // namespace

template <>
class ChordShape<2>
{
public:
    using Point = Eigen::Vector2d;

    explicit ChordShape(const PlanarObstacle &obstacle)
    {
        // The size only matters to poles.
        view_ = makeLinkObstacle(obstacle, 0.0, 1.0);
        const auto *polygon = std::get_if<Polygon>(&obstacle.shape);
        convex_ = polygon == nullptr || convexParts(*polygon).size() == 1;
    }

    ChordContact<2> contact(const Point &a, const Point &b) const
    {
        const LinkTerm term = view_->clearance(Segment::between(a, b));
        const Point &normal = term.slope.force;
        return {term.value, term.slope.lever.dot(normal) / normal.squaredNorm(), normal.normalized(), convex_};
    }

private:
    std::unique_ptr<const LinkObstacle> view_;
    bool convex_;
};

template <>
class ChordShape<3>
{
public:
    using Point = Eigen::Vector3d;

    explicit ChordShape(const SpatialObstacle &obstacle) : shape_(&obstacle.shape)
    {
        if (const auto *mesh = std::get_if<Mesh>(shape_))
            mesh_.emplace(*mesh);
    }

    ChordContact<3> contact(const Point &a, const Point &b) const
    {
        const Nearness near = mesh_ ? mesh_->nearest(a, b) : std::visit(Nearest{a, b}, *shape_);
        return {near.distance, near.fraction, near.normal, !mesh_};
    }

private:
    struct Nearest
    {
        template <class Solid>
        Nearness operator()(const Solid &solid) const
        {
            return nearness(a, b, solid);
        }
        Nearness operator()(const Mesh &) const { return {}; }  // has its own geometry

        const Point &a;
        const Point &b;
    };

    const decltype(SpatialObstacle::shape) *shape_;
    std::optional<MeshGeometry> mesh_;
};

template <int D>
ChordObstacles<D>::ChordObstacles(std::vector<Obstacle> obstacles)
  : obstacles_(std::move(obstacles)), lower_(Point::Constant(infinity)), upper_(Point::Constant(-infinity))
{
    shapes_.reserve(obstacles_.size());
    std::vector<int> order;
    for (const Obstacle &obstacle : obstacles_)
    {
        order.push_back(static_cast<int>(order.size()));
        shapes_.emplace_back(obstacle);
    }
    if (order.empty())
        return;
    build(order, 0, static_cast<int>(order.size()));
    lower_ = nodes_[0].lower;
    upper_ = nodes_[0].upper;
}

template <int D>
ChordObstacles<D>::~ChordObstacles() = default;
template <int D>
ChordObstacles<D>::ChordObstacles(ChordObstacles &&) noexcept = default;
template <int D>
ChordObstacles<D> &ChordObstacles<D>::operator=(ChordObstacles &&) noexcept = default;

template <int D>
int ChordObstacles<D>::build(std::vector<int> &order, int begin, int end)
{
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({Point::Constant(infinity), Point::Constant(-infinity), -1, -1});
    for (int i = begin; i < end; ++i)
    {
        const auto box = boundsOf(obstacles_[order[i]]);
        nodes_[index].lower = nodes_[index].lower.cwiseMin(box.lower);
        nodes_[index].upper = nodes_[index].upper.cwiseMax(box.upper);
    }
    if (end - begin == 1)
    {
        nodes_[index].obstacle = order[begin];
        return index;
    }
    int axis = 0;
    const Point width = nodes_[index].upper.cwiseMin(1e30) - nodes_[index].lower.cwiseMax(-1e30);
    width.maxCoeff(&axis);
    const int half = (begin + end) / 2;
    std::nth_element(order.begin() + begin, order.begin() + half, order.begin() + end,
                     [&](int i, int j)
                     {
                         const auto a = boundsOf(obstacles_[i]);
                         const auto b = boundsOf(obstacles_[j]);
                         return middle(a.lower[axis], a.upper[axis]) < middle(b.lower[axis], b.upper[axis]);
                     });
    build(order, begin, half);
    const int second = build(order, half, end);
    nodes_[index].second = second;
    return index;
}

/// Visits the obstacles whose boxes come within `room` of the box around a segment; `room` may shrink on the way.
template <int D>
template <class Visit>
void ChordObstacles<D>::descend(const Point &a, const Point &b, const double &room, const Visit &visit) const
{
    if (nodes_.empty())
        return;
    const Point lower = a.cwiseMin(b), upper = a.cwiseMax(b);
    std::array<int, 64> pending;  // the tree is balanced
    int count = 0;
    pending[count++] = 0;
    while (count > 0)
    {
        const int index = pending[--count];
        const Node &node = nodes_[index];
        const Point gap = (node.lower - upper).cwiseMax(lower - node.upper).cwiseMax(0.0);
        if (gap.squaredNorm() > room * room)
            continue;
        if (node.obstacle >= 0)
            visit(shapes_[node.obstacle]);
        else
        {
            pending[count++] = node.second;
            pending[count++] = index + 1;
        }
    }
}

template <int D>
void ChordObstacles<D>::contacts(const Point &a, const Point &b, double room, std::vector<ChordContact<D>> &found) const
{
    descend(a, b, room,
            [&](const ChordShape<D> &shape)
            {
                const ChordContact<D> contact = shape.contact(a, b);
                if (contact.distance < room)
                    found.push_back(contact);
            });
}

template <int D>
double ChordObstacles<D>::clearance(const Point &a, const Point &b, double atMost) const
{
    double least = atMost, room = std::max(atMost, 0.0);
    bool meets = false;
    descend(a, b, room,
            [&](const ChordShape<D> &shape)
            {
                least = std::min(least, shape.contact(a, b).distance);
                meets = meets || least <= 0.0;
                // Obstacles that meet the segment have boxes that do: those are all looked at.
                room = meets ? 0.0 : least;
            });
    return least;
}

template class ChordObstacles<2>;
template class ChordObstacles<3>;
}  // namespace narrows
