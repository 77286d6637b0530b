// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarArm.h"
#include "kernel/threading/Gap.h"
#include "kernel/threading/GapEquations.h"

namespace narrows
{
/// Whether a link crosses a gap: where its line meets the axis nearer to the middle than half the width and 0.3 sizes,
/// at more than 30 degrees, on the link made longer at both ends.
/// \param lengthening in sizes of the gap (never taken for more than `largestSize`); >= 0
bool crossesGap(const Eigen::Vector2d &base, const Eigen::Vector2d &tip, const Gap &gap, double lengthening,
                double largestSize);

/// The configurations in which links of a planar arm go through the middle of gaps. With the link's base b, direction
/// u, normal n (to its left), and the gap's middle m and axis e:
///
///   F1 = n . (m - b) = 0,    a length:  the link's line goes through the middle,
///   F2 = u . e = 0,          a sine:    the link stands square to the axis (only of crossings that are square).
///
/// F1 alone holds links that are tilted until they touch: tilt may be as large as about the root of 2 halfWidth /
/// size. Both are smooth everywhere, in collision too. Immutable.
class MidGap : public GapEquations
{
public:
    /// \param gaps as findGaps() finds them
    MidGap(const PlanarArm &arm, std::vector<Gap> gaps);

    const std::vector<Gap> &gaps() const { return gaps_; }  ///< as they were given

    /// Which links cross which gaps (crossesGap(), sizes up to half the longest link). All are square.
    /// \param points as PlanarArm::place yields them
    void crossings(const std::vector<Eigen::Vector2d> &points, double lengthening,
                   std::vector<GapCrossing> &result) const;

    /// F by rows (F1 and, where it is square, F2 of every crossing) and its derivative by the configuration.
    /// \param points of the configuration, as PlanarArm::place yields them
    void evaluate(const std::vector<Eigen::Vector2d> &points, const std::vector<GapCrossing> &crossings,
                  Eigen::VectorXd &values, Eigen::MatrixXd &transposedJacobian) const;

    const PlanarArm &arm() const { return arm_; }  ///< the arm that threads them

    int gapCount() const override { return static_cast<int>(gaps_.size()); }  ///< as many as gaps()
    double halfWidth(const Configuration &, const GapCrossing &crossing) const override
    {
        return gapOf(crossing).halfWidth;
    }
    double size(const GapCrossing &crossing) const override { return gapOf(crossing).size; }
    void crossings(const Configuration &q, double lengthening, std::vector<GapCrossing> &result) const override;
    void evaluate(const Configuration &q, const std::vector<GapCrossing> &crossings, Eigen::VectorXd &values,
                  Eigen::MatrixXd &transposedJacobian) const override;

private:
    const Gap &gapOf(const GapCrossing &crossing) const { return gaps_[static_cast<std::size_t>(crossing.gap)]; }
    PlanarArm arm_;
    std::vector<Gap> gaps_;
    double largestSize_;
};
}  // namespace narrows
