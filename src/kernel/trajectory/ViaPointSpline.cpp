// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/ViaPointSpline.h"

#include "kernel/trajectory/TimedPoints.h"

namespace narrows
{
namespace
{
constexpr double shortestPiece = 1e-12;  // of the duration: below it knots are one
constexpr double leastPivot = 0.05;      // below it levels run away from the points
}  // namespace

ViaPointSpline::ViaPointSpline(const std::vector<double> &times, double overlap, const Rise &rise)
  : times_(times), overlap_(overlap), rise_(rise)
{
    makeWindows();
}

OrFailure<ViaPointSpline> ViaPointSpline::through(const Eigen::MatrixXd &points, const std::vector<double> &times,
                                                  double overlap, const Rise &rise)
{
    if (const TrajectoryFailure fault = faultOf(points, times); fault != TrajectoryFailure::None)
        return fault;
    if (!std::isfinite(overlap))
        return TrajectoryFailure::NotFinite;
    if (!(overlap >= 0.0 && overlap <= 1.0))
        return TrajectoryFailure::BadShape;
    ViaPointSpline spline(times, overlap, rise);
    if (!spline.solveLevels(points))
        return TrajectoryFailure::Singular;
    return OrFailure<ViaPointSpline>(std::move(spline));
}

void ViaPointSpline::makeWindows()
{
    const std::size_t segments = times_.size() - 1;
    windows_.resize(segments);
    for (std::size_t k = 0; k < segments; ++k)
    {
        Window &window = windows_[k];
        window.from = k == 0 ? 0.0 : times_[k] - overlap_ * (times_[k] - times_[k - 1]);
        window.to = k + 1 == segments ? times_.back() : times_[k + 1] + overlap_ * (times_[k + 2] - times_[k + 1]);
        window.rate = 1.0 / (window.to - window.from);
    }
}

bool ViaPointSpline::solveLevels(const Eigen::MatrixXd &points)
{
    // Elimination downwards, one division per via; the joints are the right-hand sides.
    levels_ = points;
    const Eigen::Index last = points.cols() - 1;
    std::vector<double> ratios(static_cast<std::size_t>(last), 0.0);
    const auto share = [this](Eigen::Index term, double t)
    {
        const Window &window = windows_[static_cast<std::size_t>(term)];
        return rise_.at<0>(std::clamp((t - window.from) * window.rate, 0.0, 1.0))[0];
    };
    for (Eigen::Index j = 1; j < last; ++j)
    {
        const double t = times_[static_cast<std::size_t>(j)];
        const double own = share(j - 1, t), next = share(j, t);
        const double pivot = own - next - (1.0 - own) * ratios[static_cast<std::size_t>(j) - 1];
        if (!(std::abs(pivot) >= leastPivot))
            return false;
        const double inverse = 1.0 / pivot;
        ratios[static_cast<std::size_t>(j)] = next * inverse;
        levels_.col(j) = inverse * levels_.col(j) - (inverse * (1.0 - own)) * levels_.col(j - 1);
    }
    for (Eigen::Index j = last - 1; j > 0; --j)
        levels_.col(j) -= ratios[static_cast<std::size_t>(j)] * levels_.col(j + 1);
    return levels_.allFinite();
}

class ViaPointSpline::Joint : public PiecewiseMotion
{
public:
    Joint(const ViaPointSpline &spline, Eigen::Index index);

    std::vector<double> knots() const override { return knots_; }
    Series<4, Enclosure> over(std::size_t piece, const Enclosure &t) const override;

private:
    const ViaPointSpline &spline_;
    Eigen::Index index_;
    std::vector<double> knots_;      ///< where windows begin and end
    std::vector<std::size_t> done_;  ///< how many terms have ended when a piece begins
};

ViaPointSpline::Joint::Joint(const ViaPointSpline &spline, Eigen::Index index) : spline_(spline), index_(index)
{
    for (const Window &window : spline.windows_)
    {
        knots_.push_back(window.from);
        knots_.push_back(window.to);
    }
    std::sort(knots_.begin(), knots_.end());
    const double near = shortestPiece * spline.duration();
    knots_.erase(std::unique(knots_.begin(), knots_.end(), [near](double a, double b) { return b - a <= near; }),
                 knots_.end());
    knots_.back() = spline.duration();
    std::size_t done = 0;
    for (std::size_t piece = 0; piece + 1 < knots_.size(); ++piece)
    {
        const double middle = 0.5 * (knots_[piece] + knots_[piece + 1]);
        while (done < spline.windows_.size() && spline.windows_[done].to <= middle)
            ++done;
        done_.push_back(done);
    }
}

Series<4, Enclosure> ViaPointSpline::Joint::over(std::size_t piece, const Enclosure &t) const
{
    const double middle = 0.5 * (knots_[piece] + knots_[piece + 1]);
    const auto argument = [](double time, const Window &window)
    {
        return std::clamp((time - window.from) * window.rate, 0.0, 1.0);
    };
    // Windows begin and end in their order: the terms that have ended add up to a level.
    Series<4, Enclosure> sum{};
    sum[0] = spline_.levels_(index_, static_cast<Eigen::Index>(done_[piece]));
    for (std::size_t k = done_[piece]; k < spline_.windows_.size() && spline_.windows_[k].from < middle; ++k)
    {
        const Window &window = spline_.windows_[k];
        const Eigen::Index column = static_cast<Eigen::Index>(k);
        const double part = spline_.levels_(index_, column + 1) - spline_.levels_(index_, column);
        addRise<4, Enclosure>(sum, spline_.rise_, {argument(t.lower, window), argument(t.upper, window)}, part,
                              window.rate);
    }
    return sum;
}

std::unique_ptr<PiecewiseMotion> ViaPointSpline::joint(Eigen::Index index) const
{
    return std::make_unique<Joint>(*this, index);
}

ViaPointSpline ViaPointSpline::stretched(double factor) const
{
    ViaPointSpline result = *this;
    for (double &time : result.times_)
        time *= factor;
    result.makeWindows();
    return result;
}

OrFailure<ViaPointSpline> ViaPointSpline::scaledTo(const std::vector<MotionLimits> &limits) const
{
    if (static_cast<Eigen::Index>(limits.size()) != joints())
        return TrajectoryFailure::BadCount;
    double factor = 0.0;
    for (Eigen::Index i = 0; i < joints(); ++i)
    {
        const MotionLimits &own = limits[static_cast<std::size_t>(i)];
        if (!own.valid())
            return TrajectoryFailure::BadLimit;
        factor = std::max(factor, stretchFor(motionPeaks(*joint(i)), own));
    }
    // Nothing moves: no time is too short.
    return factor > 0.0 ? stretched(factor * peakSlack) : *this;
}
}  // namespace narrows
