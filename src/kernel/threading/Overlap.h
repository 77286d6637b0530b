// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace narrows
{
/// Where a robot overlaps obstacles most, and how it gets out: far cheaper than to certify a motion.
class Overlap
{
public:
    virtual ~Overlap() = default;

    /// A function of the link and the obstacle that overlap most: negative, and nearer to 0 the less they do; 0 if none
    /// do. `gradient` is its derivative by the configuration, if it is not 0.
    virtual double deepest(const Eigen::Ref<const Eigen::VectorXd> &q, Eigen::VectorXd &gradient) = 0;

    /// Whether a link overlaps an obstacle.
    virtual bool isMet(const Eigen::Ref<const Eigen::VectorXd> &q)
    {
        Eigen::VectorXd gradient;
        return deepest(q, gradient) < 0.0;
    }

    /// The first joint, as q counts them, whose link overlaps an obstacle: as long as the joints before it stay, so do
    /// the links before that one. 0 also where links are not looked at one by one; -1 if none overlaps.
    /// The second argument: links of joints before it are known not to.
    virtual int firstMet(const Eigen::Ref<const Eigen::VectorXd> &q, int /*joint*/) { return isMet(q) ? 0 : -1; }

    /// Whether a link overlaps an obstacle at one of the configurations q + (i / parts) delta, 0 < i < parts, the
    /// middle first. Where that is not much cheaper than to certify the motion, none is looked at. Parts are 1, 2, 4
    /// or 8
    virtual bool isMetBetween(const Eigen::Ref<const Eigen::VectorXd> & /*q*/,
                              const Eigen::Ref<const Eigen::VectorXd> & /*delta*/, int /*parts*/)
    {
        return false;
    }
};
}  // namespace narrows
