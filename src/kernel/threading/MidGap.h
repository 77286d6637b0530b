// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarArm.h"
#include "kernel/threading/Gap.h"

namespace narrows
{
/// A link that crosses a gap.
struct GapCrossing
{
    int link;
    int gap;
    bool square;  ///< the link shall also stand square to the gap's axis
};

/// The configurations in which links of a planar arm go through the middle of gaps. With the link's base b, direction
/// u, normal n (to its left), and the gap's middle m and axis e:
///
///   F1 = n . (m - b) = 0,    a length:  the link's line goes through the middle,
///   F2 = u . e = 0,          a sine:    the link stands square to the axis (only of crossings that are square).
///
/// F1 alone holds links that are tilted until they touch: tilt may be as large as about the root of 2 halfWidth /
/// size. Both are smooth everywhere, in collision too. Immutable.
class MidGap
{
public:
    MidGap(const PlanarArm &arm, std::vector<Gap> gaps);

    const std::vector<Gap> &gaps() const { return gaps_; }

    /// Which links cross which gaps: where the link's line meets the axis nearer to the middle than half the width and
    /// 0.3 sizes, at more than 30 degrees, on the link made longer at both ends. All are square.
    /// \param points as PlanarArm::place yields them
    /// \param lengthening in sizes of the gap (never taken for more than half the longest link); >= 0
    void crossings(const std::vector<Eigen::Vector2d> &points, double lengthening,
                   std::vector<GapCrossing> &result) const;

    /// F by rows (F1 and, where it is square, F2 of every crossing) and its derivative by the configuration.
    /// \param points of the configuration, as PlanarArm::place yields them
    void evaluate(const std::vector<Eigen::Vector2d> &points, const std::vector<GapCrossing> &crossings,
                  Eigen::VectorXd &values, Eigen::MatrixXd &transposedJacobian) const;

    const PlanarArm &arm() const { return arm_; }

private:
    bool crosses(const Eigen::Vector2d &base, const Eigen::Vector2d &tip, const Gap &gap, double lengthening) const;

    PlanarArm arm_;
    std::vector<Gap> gaps_;
    double largestSize_;
};
}  // namespace narrows
