// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/ChordWays.h"

#include "kernel/SegmentDistance.h"
#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
double apart(const Eigen::Vector2d &a, const Eigen::Vector2d &b, const Eigen::Vector2d &c, const Eigen::Vector2d &d)
{
    return distance(a, b, c, d);
}

double apart(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &c, const Eigen::Vector3d &d)
{
    const ClosestFractions near = closestFractions(a, b, c, d);
    return (a + near.first * (b - a) - c - near.second * (d - c)).norm();
}

template <int D>
class Meeting
{
public:
    using Point = Eigen::Matrix<double, D, 1>;
    using Stretch = ChordStretch<D>;

    Meeting(const LeaderPath<D> &path, double linkLength, const std::vector<Stretch> &stretches, const Point &atRest,
            double distance, double shortest)
      : path_(path),
        linkLength_(linkLength),
        stretches_(stretches),
        atRest_(atRest),
        distance_(distance),
        shortest_(shortest)
    {
        if (!stretches_.empty())
            build(0, static_cast<int>(stretches_.size()));
    }

    std::optional<double> find()
    {
        if (!nodes_.empty() && !together(0, 0))
            for (const Stretch &stretch : stretches_)
                if (found_ || meetsWaiting(stretch))
                    break;
        return found_;
    }

private:
    /// The stretches from `first` to before `last`, with a box around their chords; the children are the next node and
    /// node `second`.
    struct Node
    {
        int first;
        int last;
        int second;
        Point lower;
        Point upper;
        double begin;
        double secondAtMost;
    };

    int build(int first, int last)
    {
        const int index = static_cast<int>(nodes_.size());
        nodes_.push_back({first, last, -1, stretches_[first].front, stretches_[first].front, stretches_[first].begin,
                          stretches_[first].secondAtMost});
        for (int i = first; i < last; ++i)
        {
            const Stretch &s = stretches_[i];
            Node &node = nodes_[index];
            node.lower = node.lower.cwiseMin((s.front.cwiseMin(s.rear).array() - s.moves()).matrix());
            node.upper = node.upper.cwiseMax((s.front.cwiseMax(s.rear).array() + s.moves()).matrix());
            node.secondAtMost = std::max(node.secondAtMost, s.secondAtMost);
        }
        if (last - first == 1)
            return index;
        const int half = (first + last) / 2;
        build(first, half);
        const int second = build(half, last);
        nodes_[index].second = second;
        return index;
    }

    /// Whether chords of `front` may meet chords of `back` that can be those of a later link at the same time.
    bool together(int front, int back)
    {
        const Node &a = nodes_[front];
        const Node &b = nodes_[back];
        if (b.begin > a.secondAtMost)
            return false;
        const Point gap = (a.lower - b.upper).cwiseMax(b.lower - a.upper).cwiseMax(0.0);
        if (gap.squaredNorm() > distance_ * distance_)
            return false;
        if (a.second < 0 && b.second < 0)
            return meets(stretches_[a.first], stretches_[b.first]);
        if (b.second < 0 || (a.second >= 0 && a.last - a.first >= b.last - b.first))
            return together(front + 1, back) || together(a.second, back);
        return together(front, back + 1) || together(front, b.second);
    }

    bool meets(const Stretch &a, const Stretch &b)
    {
        if (b.begin > a.secondAtMost || apart(a.front, a.rear, b.front, b.rear) - a.moves() - b.moves() > distance_)
            return false;
        const bool halveFirst = a.end - a.begin >= b.end - b.begin;
        const Stretch &longer = halveFirst ? a : b;
        if (longer.end - longer.begin < shortest_)
        {
            found_ = a.middle();
            return true;
        }
        const Stretch early = chordStretch<D>(path_, linkLength_, longer.begin, longer.middle());
        const Stretch late = chordStretch<D>(path_, linkLength_, longer.middle(), longer.end);
        return halveFirst ? meets(early, b) || meets(late, b) : meets(a, early) || meets(a, late);
    }

    /// The same for the links that wait on the entrance line.
    bool meetsWaiting(const Stretch &a)
    {
        const double nearest = std::min(a.secondAtMost, 0.0);
        if (apart(a.front, a.rear, atRest_, path_.at(nearest)) - a.moves() > distance_)
            return false;
        if (a.end - a.begin < shortest_)
        {
            found_ = a.middle();
            return true;
        }
        return meetsWaiting(chordStretch<D>(path_, linkLength_, a.begin, a.middle())) ||
               meetsWaiting(chordStretch<D>(path_, linkLength_, a.middle(), a.end));
    }

    const LeaderPath<D> &path_;
    double linkLength_;
    const std::vector<Stretch> &stretches_;
    Point atRest_;
    double distance_;
    double shortest_;
    std::vector<Node> nodes_;
    std::optional<double> found_;
};
}  // namespace

template <int D>
std::optional<double> findMeetingChords(const LeaderPath<D> &path, double linkLength,
                                        const std::vector<ChordStretch<D>> &stretches,
                                        const Eigen::Matrix<double, D, 1> &atRest, double distance, double shortest)
{
    return Meeting<D>(path, linkLength, stretches, atRest, distance, shortest).find();
}

template std::optional<double> findMeetingChords(const LeaderPath<2> &, double, const std::vector<ChordStretch<2>> &,
                                                 const Eigen::Vector2d &, double, double);
template std::optional<double> findMeetingChords(const LeaderPath<3> &, double, const std::vector<ChordStretch<3>> &,
                                                 const Eigen::Vector3d &, double, double);
}  // namespace narrows
