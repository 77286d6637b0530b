// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "kernel/SpatialTerm.h"

namespace narrows
{
/// A smooth stand-in for the clearance between a link and a box or prism.
///
/// The distance itself has kinks: where a link lies parallel to a face, its nearest point jumps from one end to the
/// other. It is the least of the distances d_k of both ends from the solid and of the link from the solid's edges,
/// which are smooth (edges parallel to the link excepted). With F_k = d_k^2 - radius^2, the stand-in e is
///   e (e + 2 radius) = (sum of F_k^-2)^(-1/2):
/// never more than the clearance, and 0 with it.
class EdgedPole
{
public:
    /// Of a box, all its edges and corners.
    explicit EdgedPole(const Box &box);
    /// \param far no link gets further than this from the origin: what is further away of endless edges is left out
    EdgedPole(const Prism &prism, double far);

    /// The stand-in where the link is clear, else the clearance.
    SpatialTerm clearance(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double linkRadius) const;

    /// How the segment lies to the solid itself.
    Nearness nearest(const Eigen::Vector3d &a, const Eigen::Vector3d &b) const;

private:
    using Edge = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

    std::variant<Box, Prism> solid_;
    std::vector<Edge> edges_;
};
}  // namespace narrows
