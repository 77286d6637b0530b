// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/chain/ChainCertificate.h"
#include "kernel/chain/ChainMotion.h"

namespace narrows
{
/// Proves that a chain touches nothing on a straight motion of its joint values, from a ChainMotion of it. A link's
/// points are, all along, in the hull of the parabolas of its ends, thickened by their remainder: what lies beyond a
/// plane is missed if both parabolas stay on this side of it. Joint limits are not looked at. Keeps its memory from one
/// motion to the next.
template <int D>
class ChainMotionProof
{
public:
    /// Both are referred to. What is not told from touching by a billionth of the chain's length counts as touching.
    ChainMotionProof(const ChordObstacles<D> &obstacles, const ChainSpec &spec);

    /// False if it cannot tell: a touch, too wide a motion, or one next to an obstacle that is not convex.
    bool isFree(const ChainMotion<D> &motion);

private:
    using Point = Eigen::Matrix<double, D, 1>;

    /// The parabola of a point, by its control points and its place in the middle.
    struct Arc
    {
        Point begin, control, end, middle;

        /// How far it gets from where it is in the middle, at most.
        double spread() const;
        /// The least of normal . (x - through), for all of its points x.
        double least(const Point &normal, const Point &through) const;
        /// Of this point and one that is rigidly joined to it: the point between them at a fraction of the way.
        Arc towards(const Arc &other, double fraction) const;
    };
    struct Box
    {
        Point lower, upper;
    };

    void takeArcs(const ChainMotion<D> &motion);
    bool keepsOffObstacles(const Arc &rear, const Arc &front, double room, int divisions);
    bool keepsOff(const Arc &rear, const Arc &front, double room, const ChordContact<D> &contact) const;
    bool keepsOffLinks(int link) const;
    bool keepsOff(int link, int other) const;

    const ChordObstacles<D> &obstacles_;
    const ChainSpec &spec_;
    double rounding_;
    std::vector<Arc> arcs_;      ///< of the joint centres
    std::vector<double> extra_;  ///< of the links: remainder and radius
    std::vector<Box> boxes_;     ///< around what the links sweep
    std::vector<ChordContact<D>> contacts_;
};

extern template class ChainMotionProof<2>;
extern template class ChainMotionProof<3>;
}  // namespace narrows
