// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/threading/MidGap.h"

namespace narrows
{
/// Gaps between two links of a planar arm that do not meet at a joint: where they are nearest to each other, wherever
/// the arm carries them. Other links of the arm may thread them; the equations are those of MidGap, for a middle and
/// an axis that move. Derivatives by the ends of the three links are central differences. Immutable.
class LinkGaps : public GapEquations
{
public:
    /// \param fixed gaps that do not move, counted first; not null
    /// \param widest half width, less the links' radius, from which on gaps are left out; > 0
    LinkGaps(const PlanarArm &arm, std::shared_ptr<const GapEquations> fixed, double widest);

    /// Those that stand still first, then those between links.
    int gapCount() const override { return fixed_->gapCount() + static_cast<int>(pairs_.size()); }
    double halfWidth(const Configuration &q, const GapCrossing &crossing) const override;
    /// Of gaps between links the links' radius, but a quarter of the shorter one's length at least.
    double size(const GapCrossing &crossing) const override;
    void crossings(const Configuration &q, double lengthening, std::vector<GapCrossing> &result) const override;
    void evaluate(const Configuration &q, const std::vector<GapCrossing> &crossings, Eigen::VectorXd &values,
                  Eigen::MatrixXd &transposedJacobian) const override;

private:
    using Points = std::vector<Eigen::Vector2d>;  ///< as PlanarArm::place yields them

    const Points &placed(const Configuration &q) const;
    bool isFixed(const GapCrossing &crossing) const { return crossing.gap < fixed_->gapCount(); }
    std::size_t pairOf(const GapCrossing &crossing) const
    {
        return static_cast<std::size_t>(crossing.gap - fixed_->gapCount());
    }
    /// Links that cross touch: then the middle is where they cross, and the half width not positive.
    Gap gapOf(const Points &points, std::size_t pair) const;
    /// Whether the two links are surely too far apart for a gap.
    bool areFar(const Points &points, std::size_t pair) const;
    /// F1 and F2 of a crossing between links.
    Eigen::Vector2d valuesOf(const Points &points, const GapCrossing &crossing) const;
    void evaluateMoving(const Points &points, const GapCrossing &crossing, Eigen::Index row, Eigen::VectorXd &values,
                        Eigen::MatrixXd &transposedJacobian) const;

    PlanarArm arm_;
    std::shared_ptr<const GapEquations> fixed_;
    double widest_;
    std::vector<std::pair<int, int>> pairs_;
};
}  // namespace narrows
