// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/SpatialTerm.h"
#include "kernel/threading/GapEquations.h"
#include "kernel/threading/SpatialGap.h"

namespace narrows
{
/// MidGap for arms in space. With the link's base b, direction u, and the gap's middle m, axis e and line `along` t:
///
///   F1 = (u x t) . (m - b) / |u x t|,   a length: the link's line meets the line of the gap's middle,
///   F2 = u . e,                          a sine: the link stands square to the axis.
///
/// Without t, e x u stands for it: F1 is then how far off m the link passes, square to itself, along e. A hole is a gap
/// per pair of sides: four equations then, that the link's line is the hole's axis. Immutable.
class SpatialMidGap : public GapEquations
{
public:
    /// \param gaps as findGaps() finds them
    SpatialMidGap(const SpatialArm &arm, std::vector<SpatialGap> gaps);
    /// Of all gaps between the model's obstacles that leave the thinnest link at most twice `widest`.
    SpatialMidGap(const SpatialModel &model, double widest);

    const std::vector<SpatialGap> &gaps() const { return gaps_; }  ///< as they were given or found

    int gapCount() const override { return static_cast<int>(gaps_.size()); }  ///< as many as gaps()
    double halfWidth(const Configuration &, const GapCrossing &crossing) const override { return roomOf(crossing); }
    /// A quarter of the link's length at least: walls may be thinner than links need guidance.
    double size(const GapCrossing &crossing) const override;
    /// As in the plane: where the link, made longer at both ends, meets the plane of e and t at more than 30 degrees,
    /// and there is nearer to the middle than half the width and 0.3 sizes, along t nearer than that to the line.
    void crossings(const Configuration &q, double lengthening, std::vector<GapCrossing> &result) const override;
    void evaluate(const Configuration &q, const std::vector<GapCrossing> &crossings, Eigen::VectorXd &values,
                  Eigen::MatrixXd &transposedJacobian) const override;

private:
    const SpatialGap &gapOf(const GapCrossing &crossing) const { return gaps_[static_cast<std::size_t>(crossing.gap)]; }
    double roomOf(const GapCrossing &crossing) const;
    bool crosses(const SpatialArm::Placement &placement, const GapCrossing &crossing, double lengthening) const;

    SpatialArm arm_;
    std::vector<double> lengths_;  ///< per link
    std::vector<SpatialGap> gaps_;
};
}  // namespace narrows
