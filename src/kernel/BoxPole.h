// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/SpatialTerm.h"

namespace narrows
{
/// A smooth stand-in for the clearance between a link and a box.
///
/// The distance itself has kinks: where a link lies parallel to a face, its nearest point jumps from one end to the
/// other. It is the least of the distances d_k of both ends from the box and of the link from the box's twelve edges,
/// which are smooth (edges parallel to the link excepted). With F_k = d_k^2 - radius^2, the stand-in e is
///   e (e + 2 radius) = (sum of F_k^-2)^(-1/2):
/// never more than the clearance, and 0 with it.
class BoxPole
{
public:
    explicit BoxPole(const Box &box);

    /// The stand-in where the link is clear, else the clearance.
    SpatialTerm clearance(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double linkRadius) const;

    const Box &box() const { return box_; }

private:
    struct Edge
    {
        Eigen::Vector3d from, to;
    };

    Box box_;
    std::vector<Edge> edges_;
};
}  // namespace narrows
