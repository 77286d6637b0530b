// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/LinkPushes.h"

#include <Eigen/Geometry>

#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
template <int D>
Eigen::Vector3d inSpace(const Eigen::Matrix<double, D, 1> &point)
{
    Eigen::Vector3d spatial = Eigen::Vector3d::Zero();
    spatial.template head<D>() = point;
    return spatial;
}

/// A link, or the links that wait on the entrance line.
struct Chord
{
    double s;       ///< of its front end
    double place;   ///< of its rear end
    double second;  ///< g(place): chords whose front end is further on than this are neighbours or come before it
    Eigen::Vector3d front;
    Eigen::Vector3d rear;

    Eigen::Vector3d at(double fraction) const { return rear + fraction * (front - rear); }
};

template <int D>
class Parting
{
public:
    Parting(const LeaderPath<D> &path, const LinkRoom &room, NodePushes<D> &pushes)
      : path_(path), room_(room), pushes_(pushes)
    {
    }

    bool run()
    {
        for (const double s : path_.arcs())
            chords_.push_back(chordAt(s));
        bool good = true;
        for (std::size_t i = 1; i < chords_.size(); ++i)
        {
            for (std::size_t j = 0; j < i && chords_[j].s <= chords_[i].second; ++j)
                good = part(chords_[i], chords_[j]) && good;
            const double front = std::min(chords_[i].second, 0.0);
            good = part(chords_[i], {front, -room_.waiting, front, inSpace<D>(path_.at(front)),
                                     inSpace<D>(path_.at(-room_.waiting))}) &&
                   good;
        }
        return good;
    }

private:
    Chord chordAt(double s) const
    {
        const double place = path_.follower(s, room_.linkLength);
        return {s, place, path_.follower(place, room_.linkLength), inSpace<D>(path_.at(s)),
                inSpace<D>(path_.at(place))};
    }

    bool part(const Chord &a, const Chord &b)
    {
        const double reach = 0.5 * ((a.front - a.rear).norm() + (b.front - b.rear).norm()) + room_.wanted;
        if ((a.at(0.5) - b.at(0.5)).squaredNorm() >= reach * reach)
            return true;
        const ClosestFractions near = closestFractions(a.rear, a.front, b.rear, b.front);
        const Eigen::Vector3d apart = a.at(near.first) - b.at(near.second);
        const double distance = apart.norm();
        if (distance >= room_.wanted)
            return true;
        const Eigen::Vector3d way =
            0.5 * std::min(room_.wanted - distance, room_.mostPush) * direction(a, b, apart, distance);
        const double weight = 1.0 + room_.wanted - distance;
        pushes_.pushChord(a.s, a.place, near.first, way.template head<D>(), weight);
        pushes_.pushChord(b.s, b.place, near.second, -way.template head<D>(), weight);
        return distance >= room_.needed;
    }

    /// Unit vector in which `a` gets away from `b`.
    Eigen::Vector3d direction(const Chord &a, const Chord &b, const Eigen::Vector3d &apart, double distance) const
    {
        if (distance > 1e-9 * room_.linkLength)
            return apart / distance;
        const Eigen::Vector3d between = a.at(0.5) - b.at(0.5);
        const Eigen::Vector3d across = (a.front - a.rear).cross(b.front - b.rear);
        const bool inPlane = D == 2 || across.isZero(1e-9 * room_.linkLength * room_.linkLength);
        const Eigen::Vector3d away = inPlane ? between : Eigen::Vector3d(across.dot(between) < 0.0 ? -across : across);
        return away.isZero(0.0) ? Eigen::Vector3d::UnitX() : away.normalized();
    }

    const LeaderPath<D> &path_;
    const LinkRoom &room_;
    NodePushes<D> &pushes_;
    std::vector<Chord> chords_;
};
}  // namespace

template <int D>
bool pushLinksApart(const LeaderPath<D> &path, const LinkRoom &room, NodePushes<D> &pushes)
{
    return Parting<D>(path, room, pushes).run();
}

template bool pushLinksApart(const LeaderPath<2> &, const LinkRoom &, NodePushes<2> &);
template bool pushLinksApart(const LeaderPath<3> &, const LinkRoom &, NodePushes<3> &);
}  // namespace narrows
