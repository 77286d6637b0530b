// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/HomotopyCurve.h"
#include "kernel/HomotopyEnds.h"
#include "kernel/JointSchedule.h"

namespace narrows
{
/// The homotopy in the slice of joint space that holds its curve, however many joints there are:
///
///   w = w_start + lambda D + sum s_i N_i,   D = w_goal - w_start,
///   Phi_i = c_i s_i + W_i(w) - (1 - lambda) W_i(w_start) - lambda W_i(w_goal) = 0,   i = 1 .. k.
///
/// A schedule lets chosen joints go their part of D at another pace than lambda's (ours, not the paper's).
///
/// One row (k = 1) is the paper's homotopy exactly (HPPM-PRA, Eq. 24-26; see FullHomotopy): a curve in a plane. More
/// rows, each with a W of its own, bend the curve in k directions.
///
/// z = (s_1, ..., s_k, |D| lambda). If the N_i are orthogonal to each other and to D, lengths in z are lengths in
/// joint space.
class SliceHomotopy : public HomotopyCurve
{
public:
    /// \param directions N_i in columns, one per repulsion; any lengths but 0: they are made unit vectors
    /// \param couplings c_i, not 0
    /// \throws std::invalid_argument if sizes disagree, a number is not finite, a direction vanishes or depends on the
    /// others, a coupling is 0, the schedule has another number of joints or a share outside [0, 1), or the ends are
    /// impossible (see HomotopyEnds).
    SliceHomotopy(std::vector<std::shared_ptr<const Repulsion>> repulsions, const Eigen::VectorXd &start,
                  const Eigen::VectorXd &goal, const Eigen::MatrixXd &directions, const Eigen::VectorXd &couplings,
                  const JointSchedule &schedule = {});

    /// From the paper's constants a_{k,j}, one row per equation, where W joins the last row: N is the unit vector that
    /// the other rows leave free, its largest entry positive, and c = a_v . N.
    /// \throws std::invalid_argument if the matrix is not square of the robot's dimension, not finite, or its rows but
    /// the last are dependent, or the last depends on them; also as above.
    static SliceHomotopy fromRows(std::shared_ptr<const Repulsion> repulsion, const Eigen::VectorXd &start,
                                  const Eigen::VectorXd &goal, const Eigen::MatrixXd &rows);

    const Eigen::VectorXd &start() const { return ends_.start; }            ///< lambda = 0
    const Eigen::VectorXd &goal() const { return ends_.goal; }              ///< lambda = 1
    const Eigen::VectorXd &difference() const { return ends_.difference; }  ///< D
    const Eigen::MatrixXd &directions() const { return directions_; }       ///< N_i, unit vectors
    const Eigen::VectorXd &couplings() const { return couplings_; }         ///< c_i

    int equations() const override { return static_cast<int>(couplings_.size()); }  ///< k, one a slice direction
    double lambdaScale() const override { return scale_; }                          ///< |D|
    Eigen::VectorXd startPoint() const override;
    Eigen::VectorXd goalPoint() const override;
    /// H and its Jacobian at point.z.
    void evaluate(CurvePoint &point) const override;
    void configuration(const Eigen::VectorXd &z, Eigen::VectorXd &w) const override;

private:
    /// The unit difference, joint by joint at the pace of the schedule: dw / dz of lambda's coordinate.
    void scheduledRate(double lambda, Eigen::VectorXd &rate) const;

    std::vector<std::shared_ptr<const Repulsion>> repulsions_;
    HomotopyEnds ends_;
    Eigen::MatrixXd directions_;
    Eigen::VectorXd couplings_;
    double scale_;
    Eigen::VectorXd unitDifference_;  ///< D / |D|
    JointSchedule schedule_;          ///< empty: all joints at lambda's pace
};
}  // namespace narrows
