// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/trajectory/JointTrajectory.h"

namespace narrows
{
/// A motion whose joints are polynomials of time between knots, as most methods in use make them.
class PolynomialTrajectory : public JointTrajectory
{
public:
    /// Between two knots one polynomial per joint.
    struct Piece
    {
        double duration;               ///< > 0
        Eigen::MatrixXd coefficients;  ///< one row per joint; column k multiplies (time since the piece began)^k
    };

    /// \throws std::invalid_argument unless there is a piece, all durations are positive and finite, all coefficients
    /// finite, and all pieces have the same joints. Whether pieces join is the caller's business: see largestJumps().
    explicit PolynomialTrajectory(std::vector<Piece> pieces);

    Eigen::Index joints() const override { return pieces_.front().coefficients.rows(); }
    double duration() const override { return knots_.back(); }
    void at(double t, States &state) const override;
    std::unique_ptr<PiecewiseMotion> joint(Eigen::Index index) const override;

    const std::vector<Piece> &pieces() const { return pieces_; }  ///< one after the other
    /// Where pieces begin, and the end.
    const std::vector<double> &knots() const { return knots_; }

    /// The same way in `factor` times the time. \param factor > 0
    PolynomialTrajectory stretched(double factor) const;

private:
    class Joint;

    std::vector<Piece> pieces_;
    std::vector<double> knots_;
};
}  // namespace narrows
