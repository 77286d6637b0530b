// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ViaPointOptimizer.h"

#include <nlopt.h>

namespace narrows
{
namespace
{
// Of the middle of both logarithms of shapes, and of half their difference;
// equal shapes are singular.
constexpr double leastMiddle = -2.5, largestMiddle = 3.5;
constexpr double leastHalf = 0.01, largestHalf = 2.0;
constexpr double searchTolerance = 1e-5;  // of extremes, while searching
constexpr double penalty = 100.0;         // per excess; objectives are logarithms
constexpr double unusable = 1e6;
constexpr double localTolerance = 1e-7;  // of logarithms of shapes

OrFailure<ViaPointTrajectory> made(const ViaPointTask &task, const TrajectoryWish &wish, double viaShape,
                                   double goalShape)
{
    if (!wish.mixed)
        return ViaPointTrajectory::full(task, viaShape, goalShape);
    return ViaPointTrajectory::full(task, *Rise::symmetric(viaShape), *Rise::resting(goalShape));
}

class ViaPointSearch
{
public:
    ViaPointSearch(const ViaPointTask &task, const TrajectoryWish &wish) : task_(task), wish_(wish)
    {
        const auto [lowest, highest] = std::minmax({task.start, task.via, task.goal});
        range_ = highest > lowest ? highest - lowest : 1.0;
        // Two rises of one kind may change places; two of different kinds may not,
        // and may have equal shapes.
        lower_[1] = wish.mixed ? -largestHalf : leastHalf;
    }

    void run()
    {
        double x[] = {0.5 * (lower_[0] + upper_[0]), 0.5 * (lower_[1] + upper_[1])};
        minimize(NLOPT_GN_DIRECT_L, wish_.evaluations, x);
        if (best_)
            std::copy(bestPoint_, bestPoint_ + 2, x);
        minimize(NLOPT_LN_NELDERMEAD, (wish_.evaluations + 1) / 2, x);
    }

    /// The best that keeps everything, if any.
    std::optional<OptimizedTrajectory> result() const
    {
        if (!best_)
            return std::nullopt;
        const auto [viaShape, goalShape] = shapes(bestPoint_);
        return OptimizedTrajectory{*best_, motionPeaks(*best_), viaShape, goalShape, evaluations_};
    }

private:
    static std::pair<double, double> shapes(const double *x) { return {std::exp(x[0] + x[1]), std::exp(x[0] - x[1])}; }

    static double judge(unsigned, const double *x, double *, void *search)
    {
        return static_cast<ViaPointSearch *>(search)->value(x);
    }

    void minimize(nlopt_algorithm algorithm, int evaluations, double *x)
    {
        nlopt_opt optimizer = nlopt_create(algorithm, 2);
        nlopt_set_min_objective(optimizer, judge, this);
        nlopt_set_lower_bounds(optimizer, lower_);
        nlopt_set_upper_bounds(optimizer, upper_);
        nlopt_set_maxeval(optimizer, evaluations);
        nlopt_set_xtol_abs1(optimizer, localTolerance);
        double least = 0.0;
        nlopt_optimize(optimizer, x, &least);
        nlopt_destroy(optimizer);
    }

    double value(const double *x)
    {
        ++evaluations_;
        const auto [viaShape, goalShape] = shapes(x);
        const OrFailure<ViaPointTrajectory> motion = made(task_, wish_, viaShape, goalShape);
        if (!motion)
            return unusable;
        const MotionPeaks peaks = motionPeaks(*motion, searchTolerance);
        const double objective = objectiveOf(peaks), excess = excessOf(peaks);
        if (excess == 0.0 && objective < leastObjective_)
        {
            leastObjective_ = objective;
            best_ = *motion;
            std::copy(x, x + 2, bestPoint_);
        }
        return objective + penalty * excess;
    }

    double objectiveOf(const MotionPeaks &peaks) const
    {
        // A motion that stands still is perfect.
        const auto logarithm = [](double least)
        {
            return std::log(std::max(least, 1e-300));
        };
        switch (wish_.objective)
        {
            case TrajectoryObjective::Acceleration:
                return logarithm(peaks[2].magnitude());
            case TrajectoryObjective::Overshoot:
                return ViaPointTrajectory::overshoot(task_, peaks) / range_ + 1e-3 * logarithm(peaks[3].magnitude());
            case TrajectoryObjective::Duration:
                return logarithm(stretchFor(peaks, *wish_.limits));
            case TrajectoryObjective::Jerk:
                break;
        }
        return logarithm(peaks[3].magnitude());
    }

    /// By how much it breaks what was asked for; extremes may be further out by
    /// the tolerance.
    double excessOf(const MotionPeaks &peaks) const
    {
        const double overshoot = ViaPointTrajectory::overshoot(task_, peaks);
        double excess = 0.0;
        // A peak that only touches a point of the task overshoots nothing.
        if (overshoot > 0.0 && std::isfinite(wish_.maxOvershoot))
            excess = std::max(0.0, (overshoot + searchTolerance * peaks[0].magnitude() - wish_.maxOvershoot) / range_);
        if (wish_.limits && wish_.objective != TrajectoryObjective::Duration)
            excess += std::max(0.0, stretchFor(peaks, *wish_.limits) * (1.0 + searchTolerance) - 1.0);
        return excess;
    }

    const ViaPointTask &task_;
    const TrajectoryWish &wish_;
    double range_;
    double lower_[2] = {leastMiddle, leastHalf}, upper_[2] = {largestMiddle, largestHalf};
    int evaluations_ = 0;
    std::optional<ViaPointTrajectory> best_;
    double bestPoint_[2] = {};
    double leastObjective_ = std::numeric_limits<double>::infinity();
};
}  // namespace

OrFailure<OptimizedTrajectory> optimizeViaPoint(const ViaPointTask &task, const TrajectoryWish &wish)
{
    if (const OrFailure<ViaPointTrajectory> any = ViaPointTrajectory::full(task, 2.0, 0.5);
        any.failure == TrajectoryFailure::NotFinite || any.failure == TrajectoryFailure::BadTime)
        return any.failure;
    if (!(wish.maxOvershoot >= 0.0) || (wish.limits && !wish.limits->valid()) ||
        (!wish.limits && wish.objective == TrajectoryObjective::Duration))
        return TrajectoryFailure::BadLimit;
    if (wish.evaluations < 1)
        return TrajectoryFailure::BadCount;
    ViaPointSearch search(task, wish);
    search.run();
    std::optional<OptimizedTrajectory> found = search.result();
    if (!found)
        return TrajectoryFailure::Infeasible;
    if (wish.objective != TrajectoryObjective::Duration)
        return *found;
    const double factor = stretchFor(found->peaks, *wish.limits) * (1.0 + 2e-9);
    if (!(factor > 0.0))
        return *found;
    ViaPointTask fast = task;
    fast.viaTime *= factor;
    fast.duration *= factor;
    const OrFailure<ViaPointTrajectory> motion = made(fast, wish, found->viaShape, found->goalShape);
    if (!motion)
        return motion.failure;
    return OptimizedTrajectory{*motion, motionPeaks(*motion), found->viaShape, found->goalShape, found->evaluations};
}
}  // namespace narrows
