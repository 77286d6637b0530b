// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/ChainMotionProof.h"

#include <algorithm>

#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
constexpr int mostDivisions = 4;    ///< of a link
constexpr double nearAnEnd = 0.05;  ///< of a part: what is nearest there is cut off short
constexpr double shortPart = 0.2;

/// The least value, for t from 0 to 1, of a parabola with these Bezier coefficients.
double leastOf(double begin, double control, double end)
{
    const double ends = std::min(begin, end);
    if (control >= ends)
        return ends;
    return (begin * end - control * control) / (begin - 2.0 * control + end);
}

Eigen::Vector3d inSpace(const Eigen::Vector2d &point)
{
    return {point.x(), point.y(), 0.0};
}

const Eigen::Vector3d &inSpace(const Eigen::Vector3d &point)
{
    return point;
}
}  // namespace

template <int D>
double ChainMotionProof<D>::Arc::spread() const
{
    return std::sqrt(
        std::max({(begin - middle).squaredNorm(), (control - middle).squaredNorm(), (end - middle).squaredNorm()}));
}

template <int D>
double ChainMotionProof<D>::Arc::least(const Point &normal, const Point &through) const
{
    return leastOf(normal.dot(begin - through), normal.dot(control - through), normal.dot(end - through));
}

template <int D>
typename ChainMotionProof<D>::Arc ChainMotionProof<D>::Arc::towards(const Arc &other, double fraction) const
{
    return {begin + fraction * (other.begin - begin), control + fraction * (other.control - control),
            end + fraction * (other.end - end), middle + fraction * (other.middle - middle)};
}

template <int D>
ChainMotionProof<D>::ChainMotionProof(const ChordObstacles<D> &obstacles, const ChainSpec &spec)
  : obstacles_(obstacles), spec_(spec), rounding_(1e-9 * spec.links * spec.length)
{
}

template <int D>
bool ChainMotionProof<D>::isFree(const ChainMotion<D> &motion)
{
    takeArcs(motion);
    for (int link = 0; link < spec_.links; ++link)
        if (!keepsOffObstacles(arcs_[link], arcs_[link + 1], extra_[link] + rounding_, mostDivisions))
            return false;
    for (int link = 2; spec_.selfCollision && link < spec_.links; ++link)
        if (!keepsOffLinks(link))
            return false;
    return true;
}

template <int D>
void ChainMotionProof<D>::takeArcs(const ChainMotion<D> &motion)
{
    arcs_.clear();
    for (std::size_t i = 0; i < motion.middle.size(); ++i)
        arcs_.push_back({motion.begin[i], 2.0 * motion.middle[i] - 0.5 * (motion.begin[i] + motion.end[i]),
                         motion.end[i], motion.middle[i]});
    extra_.clear();
    boxes_.clear();
    for (std::size_t i = 1; i < arcs_.size(); ++i)
    {
        const Arc &rear = arcs_[i - 1], &front = arcs_[i];
        const double extra = spec_.radius + motion.remainder[i];
        const Point lower = rear.begin.cwiseMin(rear.control)
                                .cwiseMin(rear.end)
                                .cwiseMin(front.begin.cwiseMin(front.control).cwiseMin(front.end));
        const Point upper = rear.begin.cwiseMax(rear.control)
                                .cwiseMax(rear.end)
                                .cwiseMax(front.begin.cwiseMax(front.control).cwiseMax(front.end));
        extra_.push_back(extra);
        boxes_.push_back({(lower.array() - extra - rounding_).matrix(), (upper.array() + extra + rounding_).matrix()});
    }
}

/// Of a part of a link. Where it turns about an edge, no plane does for all of it: then it is divided, so that what is
/// next to the edge becomes short.
template <int D>
bool ChainMotionProof<D>::keepsOffObstacles(const Arc &rear, const Arc &front, double room, int divisions)
{
    contacts_.clear();
    obstacles_.contacts(rear.middle, front.middle, std::max(rear.spread(), front.spread()) + room, contacts_);
    const auto missed = [&](const ChordContact<D> &contact)
    {
        return keepsOff(rear, front, room, contact);
    };
    const auto failing = std::find_if_not(contacts_.begin(), contacts_.end(), missed);
    if (failing == contacts_.end())
        return true;
    const double fraction = failing->fraction;
    if (divisions == 0 || !failing->convex || failing->distance < room)
        return false;
    const double cut = fraction < nearAnEnd ? shortPart : fraction > 1.0 - nearAnEnd ? 1.0 - shortPart : fraction;
    const Arc between = rear.towards(front, cut);
    return keepsOffObstacles(rear, between, room, divisions - 1) &&
           keepsOffObstacles(between, front, room, divisions - 1);
}

template <int D>
bool ChainMotionProof<D>::keepsOff(const Arc &rear, const Arc &front, double room, const ChordContact<D> &contact) const
{
    if (!contact.convex || contact.distance < room)
        return false;
    const Point foot =
        rear.middle + contact.fraction * (front.middle - rear.middle) - contact.distance * contact.normal;
    return rear.least(contact.normal, foot) >= room && front.least(contact.normal, foot) >= room;
}

template <int D>
bool ChainMotionProof<D>::keepsOffLinks(int link) const
{
    const Box &own = boxes_[link];
    for (int other = 0; other + 1 < link; ++other)
    {
        const Box &box = boxes_[other];
        const bool meets =
            (box.lower.array() <= own.upper.array()).all() && (box.upper.array() >= own.lower.array()).all();
        if (meets && !keepsOff(link, other))
            return false;
    }
    return true;
}

/// Two links keep apart if their ends do so along one direction.
template <int D>
bool ChainMotionProof<D>::keepsOff(int link, int other) const
{
    const Arc &a = arcs_[link], &b = arcs_[link + 1], &c = arcs_[other], &d = arcs_[other + 1];
    const ClosestFractions near =
        closestFractions(inSpace(a.middle), inSpace(b.middle), inSpace(c.middle), inSpace(d.middle));
    const Point apart = a.towards(b, near.first).middle - c.towards(d, near.second).middle;
    const double room = extra_[link] + extra_[other] + rounding_;
    if (!(apart.norm() >= room))
        return false;
    const Point normal = apart.normalized();
    for (const Arc *x : {&a, &b})
        for (const Arc *y : {&c, &d})
            if (leastOf(normal.dot(x->begin - y->begin), normal.dot(x->control - y->control),
                        normal.dot(x->end - y->end)) < room)
                return false;
    return true;
}

template class ChainMotionProof<2>;
template class ChainMotionProof<3>;
}  // namespace narrows
