// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/JointTrajectory.h"
#include "kernel/trajectory/ViaPointTrajectory.h"

namespace narrows
{
/// Any number of joints through any number of via points: term k rises from S_(k-1) to S_k in a window around its
/// segment, [t_(k-1) - overlap D_(k-1), t_k + overlap D_(k+1)], D_k = t_k - t_(k-1), cut off at start and end.
///
/// A via then sees its two neighbouring terms only:
///     (1 - h_j) S_(j-1) + (h_j - k_j) S_j + k_j S_(j+1) = theta_j,
/// one tridiagonal matrix for all joints. Overlap 0 is the polyline, with a stop at every via; the motion depends
/// continuously on the overlap. With the paper's terms, which all begin at 0, errors grow by K / (1 - K) per via.
class ViaPointSpline : public JointTrajectory
{
public:
    /// \param points one column per point, one row per joint: start, vias, goal
    /// \param times of the points: 0 first, ascending, up to 1e6
    /// \param overlap in [0, 1]. Singular where windows nearly coincide: with one via, from about 0.85 on
    /// \param rise of all terms; one that rests at both ends (all but Rise::paper) for a motion that does
    static OrFailure<ViaPointSpline> through(const Eigen::MatrixXd &points, const std::vector<double> &times,
                                             double overlap, const Rise &rise);

    /// Positions and derivatives up to Order (0 to 3), one column each; before the start and after the end at rest.
    template <int Order>
    using State = Eigen::Matrix<double, Eigen::Dynamic, Order + 1>;
    /// Position and derivatives of every joint, column by column.
    template <int Order>
    void at(double t, State<Order> &state) const;
    void at(double t, States &state) const override { at<3>(t, state); }

    Eigen::Index joints() const override { return levels_.rows(); }
    double duration() const override { return times_.back(); }
    std::unique_ptr<PiecewiseMotion> joint(Eigen::Index index) const override;
    const std::vector<double> &times() const { return times_; }  ///< of the vias, start and goal included
    /// S_k, one column each, from the start to the goal.
    const Eigen::MatrixXd &levels() const { return levels_; }

    /// The same way in `factor` times the time. \param factor > 0
    ViaPointSpline stretched(double factor) const;

    /// Stretched (or shortened) so that the joint that is nearest to its limits just keeps them.
    /// \param limits one for every joint
    OrFailure<ViaPointSpline> scaledTo(const std::vector<MotionLimits> &limits) const;

private:
    class Joint;
    struct Window
    {
        double from, to, rate;
    };

    ViaPointSpline(const std::vector<double> &times, double overlap, const Rise &rise);
    void makeWindows();
    bool solveLevels(const Eigen::MatrixXd &points);

    std::vector<double> times_;
    double overlap_;
    Rise rise_;
    std::vector<Window> windows_;  ///< of the terms; the first is term 1
    Eigen::MatrixXd levels_;
};

template <int Order>
void ViaPointSpline::at(double t, State<Order> &state) const
{
    state.setZero(joints(), Order + 1);
    const std::size_t segments = windows_.size();
    const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, t) - times_.begin();
    // Only the terms of this segment and of its neighbours move.
    const std::size_t first = next > 1 ? static_cast<std::size_t>(next) - 2 : 0;
    const std::size_t end = std::min(static_cast<std::size_t>(next) + 1, segments);
    state.col(0) = levels_.col(static_cast<Eigen::Index>(first));
    for (std::size_t k = first; k < end; ++k)
    {
        const Window &window = windows_[k];
        if (t < window.from)
            continue;
        Series<Order> sum{};
        addRise<Order>(sum, rise_, t > window.to ? 2.0 : std::min((t - window.from) * window.rate, 1.0), 1.0,
                       window.rate);
        const Eigen::Index column = static_cast<Eigen::Index>(k);
        for (int order = 0; order <= Order; ++order)
            state.col(order) += sum[order] * (levels_.col(column + 1) - levels_.col(column));
    }
}
}  // namespace narrows
