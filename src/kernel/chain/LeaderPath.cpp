// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/LeaderPath.h"

#include <stdexcept>

namespace narrows
{
namespace
{
/// The smaller root of |from + t along - x| = distance for a unit vector `along`: where a point that comes along that
/// line enters the ball around x. The foot of x if the line misses the ball.
template <class Point>
double entry(const Point &from, const Point &along, const Point &x, double distance)
{
    const Point away = x - from;
    const double foot = along.dot(away);
    const double square = distance * distance - (away - foot * along).squaredNorm();
    return foot - std::sqrt(std::max(square, 0.0));
}
}  // namespace

template <int D>
LeaderPath<D>::LeaderPath(const PointPath<D> &nodes, const Point &entrance) : entrance_(entrance.normalized())
{
    for (const Point &node : nodes)
    {
        if (!node.allFinite())
            throw std::invalid_argument("LeaderPath: a node is not finite");
        const double step = nodes_.empty() ? 0.0 : (node - nodes_.back()).norm();
        if (!nodes_.empty() && step <= 0.0)
            continue;
        arcs_.push_back(nodes_.empty() ? 0.0 : arcs_.back() + step);
        nodes_.push_back(node);
    }
    if (nodes_.size() < 2)
        throw std::invalid_argument("LeaderPath: at least two different nodes are needed");
    if (!entrance_.allFinite() || entrance_.isZero())
        throw std::invalid_argument("LeaderPath: the entrance needs a direction");
}

template <int D>
int LeaderPath<D>::segmentBefore(double s) const
{
    // Nodes mostly are at about equal distances: look around where s would be then.
    const int last = static_cast<int>(nodes_.size()) - 1;
    const int guess = std::clamp(static_cast<int>(s / arcs_.back() * last), 0, last);
    constexpr int around = 8;
    auto begin = arcs_.begin(), end = arcs_.end();
    if (const int from = std::max(guess - around, 0); arcs_[from] < s)
        begin += from;
    if (const int to = std::min(guess + around, last); arcs_[to] >= s)
        end = arcs_.begin() + to;
    const int node = static_cast<int>(std::lower_bound(begin, end, s) - arcs_.begin());
    return std::clamp(node - 1, 0, last - 1);
}

template <int D>
typename LeaderPath<D>::Point LeaderPath<D>::at(double s) const
{
    if (s <= 0.0)
        return nodes_.front() + s * entrance_;
    const int i = segmentBefore(s);
    const double share = std::min((s - arcs_[i]) / (arcs_[i + 1] - arcs_[i]), 1.0);
    return nodes_[i] + share * (nodes_[i + 1] - nodes_[i]);
}

template <int D>
typename LeaderPath<D>::Point LeaderPath<D>::directionBefore(double s) const
{
    if (s <= 0.0)
        return entrance_;
    const int i = segmentBefore(s);
    return (nodes_[i + 1] - nodes_[i]) / (arcs_[i + 1] - arcs_[i]);
}

template <int D>
double LeaderPath<D>::follower(double s, const Point &x, double distance) const
{
    // Nothing on the way from s back to s - (distance - gap) can be far enough: a chord is no longer than its arc.
    double from = s, gap = distance - (x - at(s)).norm();
    while (gap > 0.0 && from - gap > 0.0)
    {
        const int i = segmentBefore(from - gap);
        // On a segment the distance from x is greatest at an end.
        from = arcs_[i];
        gap = distance - (x - nodes_[i]).norm();
        if (gap <= 0.0)
            return onSegment(i, x, distance);
    }
    return gap > 0.0 ? entry<Point>(nodes_.front(), entrance_, x, distance) : from;
}

template <int D>
double LeaderPath<D>::onSegment(int segment, const Point &x, double distance) const
{
    const double length = arcs_[segment + 1] - arcs_[segment];
    const Point along = (nodes_[segment + 1] - nodes_[segment]) / length;
    return arcs_[segment] + std::clamp(entry<Point>(nodes_[segment], along, x, distance), 0.0, length);
}

template <int D>
std::vector<double> jointPlaces(const LeaderPath<D> &path, double s, double linkLength, int links)
{
    std::vector<double> places{s};
    for (int i = 0; i < links; ++i)
        places.push_back(path.follower(places.back(), linkLength));
    return places;
}

template class LeaderPath<2>;
template class LeaderPath<3>;
template std::vector<double> jointPlaces(const LeaderPath<2> &, double, double, int);
template std::vector<double> jointPlaces(const LeaderPath<3> &, double, double, int);
}  // namespace narrows
