// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/chain/LeaderPath.h"

namespace narrows
{
/// What is asked of the nodes of a path in one round of ChordRelaxation: weighted displacements, of which each node
/// goes the mean. The first node stays, and so does the entrance line; the last one stays within a ball.
template <int D>
class NodePushes
{
public:
    using Point = Eigen::Matrix<double, D, 1>;  ///< in the plane or in space

    /// Begins a round. The path is referred to until the next one.
    /// \param endMoves whether its last node may
    void reset(const LeaderPath<D> &path, bool endMoves)
    {
        path_ = &path;
        endMoves_ = endMoves;
        sums_.assign(path.nodes().size(), Point::Zero());
        weights_.assign(path.nodes().size(), 0.0);
        folds_.assign(path.nodes().size(), 0);
    }

    /// Asks the nodes around P(t) to take it along.
    void push(double t, const Point &way, double weight)
    {
        if (t <= 0.0)
            return;
        const int i = path_->segmentBefore(t);
        const std::vector<double> &arcs = path_->arcs();
        const double share = (t - arcs[i]) / (arcs[i + 1] - arcs[i]);
        add(i, way, weight * (1.0 - share));
        add(i + 1, way, weight * share);
    }

    /// Asks for `way` at a fraction (0: rear, 1: front) of the chord from P(place) to P(s).
    void pushChord(double s, double place, double fraction, const Point &way, double weight)
    {
        const double front = s < path_->length() || endMoves_ ? fraction : 0.0;
        const double rear = place > 0.0 ? 1.0 - fraction : 0.0;
        const double square = front * front + rear * rear;
        if (square < 1e-4)  // of the ends that can move none is near
            return;
        push(s, front / square * way, weight * front);
        push(place, rear / square * way, weight * rear);
    }

    /// Asks for a straighter path around P(t).
    void straighten(double t)
    {
        if (t <= 0.0)
            return;
        const int i = path_->segmentBefore(t);
        folds_[i] = folds_[i + 1] = 1;
    }

    /// Where the last node may be.
    struct End
    {
        Point middle;  ///< of the ball
        double room;   ///< >= 0
    };

    /// \param factor of the mean displacement, which is then cut to `longest`
    /// \param smoothing share of the way to the middle of its neighbours
    void apply(double factor, double longest, double smoothing, const End &end, PointPath<D> &nodes) const
    {
        PointPath<D> moved = nodes;
        for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        {
            const double share = folds_[i] ? 0.5 : smoothing;
            moved[i] += asked(i, factor, longest) + share * (0.5 * (nodes[i - 1] + nodes[i + 1]) - nodes[i]);
        }
        const Point away = nodes.back() + asked(nodes.size() - 1, factor, longest) - end.middle;
        moved.back() = end.middle + (away.norm() > end.room ? Point(end.room * away.normalized()) : away);
        nodes = std::move(moved);
    }

private:
    Point asked(std::size_t node, double factor, double longest) const
    {
        const Point way = weights_[node] > 0.0 ? Point(factor / weights_[node] * sums_[node]) : Point(Point::Zero());
        const double length = way.norm();
        return length > longest ? Point(longest / length * way) : way;
    }

    void add(int node, const Point &way, double weight)
    {
        sums_[node] += weight * way;
        weights_[node] += weight;
    }

    const LeaderPath<D> *path_ = nullptr;
    bool endMoves_ = false;
    PointPath<D> sums_;
    std::vector<double> weights_;
    std::vector<char> folds_;
};
}  // namespace narrows
