// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarModel.h"
#include "validity/TurningPlane.h"

namespace narrows::proof
{
/// Where an arm is on the straight way between two rows of a path, and how far it can get from there: the verifier's
/// own kinematics.
class PlanarMotion
{
public:
    static constexpr int Dim = 2;

    explicit PlanarMotion(const PlanarArm &arm);

    /// Goes to from + t * (to - from).
    void place(const Eigen::VectorXd &from, const Eigen::VectorXd &to, double t);

    int linkCount() const { return arm_.linkCount(); }
    double radius(int /*link*/) const { return arm_.radius(); }
    const MovingSegment<2> &link(int index) const { return links_[index]; }

    /// Two links, first < second, in a frame that turns as the first does and moves with what carries both.
    MovingPair<2> between(int first, int second) const;

    /// Whether two links meet at a joint.
    bool areNeighbours(int first, int second) const;

    /// No point of the arm gets further than this from the origin, anywhere on the path.
    double extent(const std::vector<Eigen::VectorXd> &path) const;

    /// More than any error of a computed distance between things within `extent` of the origin.
    double rounding(double extent) const;

private:
    const MovingPoint<2> &baseOf(int link) const { return points_[arm_.links()[link].parent + 1]; }
    const MovingPoint<2> &tipOf(int link) const { return points_[link + 1]; }

    const PlanarArm &arm_;
    std::vector<MovingPoint<2>> points_;  ///< the arm's base, then the tips
    std::vector<double> rates_;           ///< of the links' angles
    std::vector<MovingSegment<2>> links_;
};
}  // namespace narrows::proof
