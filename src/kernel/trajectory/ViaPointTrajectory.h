// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/MotionPeaks.h"

namespace narrows
{
/// One joint shall be at `start` at time 0, at `via` at `viaTime` and at `goal`
/// at `duration`.
struct ViaPointTask
{
    double start;     ///< the paper's q_0, in any unit
    double via;       ///< theta_v
    double goal;      ///< S_f
    double viaTime;   ///< t_v, in (0, duration)
    double duration;  ///< t_s
};

/// The paper's free parameters: n and a of the term that ends at the goal, n_v
/// and a_v of the one that ends at the via.
struct PaperParameters
{
    double n;     ///< of the term that ends at the goal
    double a;     ///< of the same
    double nVia;  ///< of the term that ends at the via
    double aVia;  ///< of the same
};

/// A motion of one joint through one via point, in closed form:
///     S(t) = q_0 + (S_v - q_0) h(min(t / T_h, 1)) + (S_f - S_v) g(t / t_s),
/// with rises h and g and S_v such that S(t_v) = theta_v. Before 0 it rests at
/// the start, after the end at the goal.
class ViaPointTrajectory : public PiecewiseMotion
{
public:
    /// The paper's trajectory (Eqs. 7, 8): h ends at the via and stays. Its four
    /// conditions are one signed formula; what its iteration tends to is S_v =
    /// (theta_v - K S_f) / (1 - K) with K = g(t_v), for every K but 1. Continuous
    /// at the via; smoothEnd() tells which parameters make it smoother.
    static OrFailure<ViaPointTrajectory> paper(const ViaPointTask &task, const PaperParameters &parameters);

    /// The same with own-clock rises (Rise::resting): velocity and acceleration
    /// are continuous at the via and vanish at both ends, in any unit of time; 0
    /// < K < 1 always.
    static OrFailure<ViaPointTrajectory> resting(const ViaPointTask &task, double viaShape, double goalShape);

    /// Both rises are own-clock and last for the whole duration: infinitely
    /// smooth within, velocity and acceleration vanish at both ends. S_v =
    /// (theta_v - (1 - h) q_0 - k S_f) / (h - k), h and k the rises at t_v.
    /// Singular where the shapes are (nearly) equal.
    static OrFailure<ViaPointTrajectory> full(const ViaPointTask &task, double viaShape, double goalShape);

    /// The same of any two rises. \param toVia, toGoal with both ends at rest, or
    /// the motion's ends are not
    static OrFailure<ViaPointTrajectory> full(const ViaPointTask &task, const Rise &toVia, const Rise &toGoal);

    /// Position and derivatives up to Order (0 to 3); at the via itself the
    /// limits from the left.
    template <int Order>
    Series<Order> at(double t) const;

    std::vector<double> knots() const override;
    Series<4, Enclosure> over(std::size_t piece, const Enclosure &t) const override;

    /// Right limit minus left limit at the via, of position and derivatives.
    Series<3> viaJump() const;

    const ViaPointTask &task() const { return task_; }  ///< as it was given
    /// The share K of the goal's term that is done at the via.
    double viaShare() const { return goalShare_; }
    /// S_v: where the first term leads.
    double feedback() const { return feedback_; }
    /// How far the motion leaves the range of start, via and goal; >= 0.
    static double overshoot(const ViaPointTask &task, const MotionPeaks &peaks);

private:
    ViaPointTrajectory(const ViaPointTask &task, const Rise &toVia, double viaSpan, const Rise &toGoal);
    static OrFailure<ViaPointTrajectory> solved(const ViaPointTask &task, const Rise &toVia, double viaSpan,
                                                const Rise &toGoal);

    ViaPointTask task_;
    Rise toVia_, toGoal_;
    double viaSpan_;  ///< how long the first term moves
    double goalShare_;
    double feedback_;
    double viaRate_, goalRate_;  ///< one over their spans
    double viaPart_, goalPart_;  ///< S_v - q_0 and S_f - S_v
};

/// Adds `part` times a rise whose argument runs at `rate`.
template <int Order, class Number>
void addRise(Series<Order, Number> &sum, const Rise &rise, const Number &x, double part, double rate)
{
    const Series<Order, Number> terms = rise.at<Order>(x);
    double factor = part;
    for (int k = 0; k <= Order; ++k, factor *= rate)
        sum[k] = sum[k] + factor * terms[k];
}

template <int Order>
Series<Order> ViaPointTrajectory::at(double t) const
{
    Series<Order> sum{};
    sum[0] = task_.start;
    addRise<Order>(sum, toVia_, t <= viaSpan_ ? std::min(t * viaRate_, 1.0) : 2.0, viaPart_, viaRate_);
    addRise<Order>(sum, toGoal_, t <= task_.duration ? std::min(t * goalRate_, 1.0) : 2.0, goalPart_, goalRate_);
    return sum;
}
}  // namespace narrows
