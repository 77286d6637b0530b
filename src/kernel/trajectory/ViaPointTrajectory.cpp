// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/ViaPointTrajectory.h"

namespace narrows
{
namespace
{
// Errors of the terms grow with one over the pivot.
constexpr double leastRelativePivot = 1e-9;

TrajectoryFailure faultOf(const ViaPointTask &task)
{
    for (const double value : {task.start, task.via, task.goal, task.viaTime, task.duration})
        if (!std::isfinite(value))
            return TrajectoryFailure::NotFinite;
    return task.viaTime > 0.0 && task.viaTime < task.duration ? TrajectoryFailure::None : TrajectoryFailure::BadTime;
}
}  // namespace

ViaPointTrajectory::ViaPointTrajectory(const ViaPointTask &task, const Rise &toVia, double viaSpan, const Rise &toGoal)
  : task_(task),
    toVia_(toVia),
    toGoal_(toGoal),
    viaSpan_(viaSpan),
    viaRate_(1.0 / viaSpan),
    goalRate_(1.0 / task.duration)
{
}

OrFailure<ViaPointTrajectory> ViaPointTrajectory::paper(const ViaPointTask &task, const PaperParameters &parameters)
{
    if (const TrajectoryFailure fault = faultOf(task); fault != TrajectoryFailure::None)
        return fault;
    const OrFailure<Rise> toVia = Rise::paper(parameters.nVia, parameters.aVia, task.viaTime);
    const OrFailure<Rise> toGoal = Rise::paper(parameters.n, parameters.a, task.duration);
    if (!toVia || !toGoal)
        return toVia ? toGoal.failure : toVia.failure;
    return solved(task, *toVia, task.viaTime, *toGoal);
}

OrFailure<ViaPointTrajectory> ViaPointTrajectory::resting(const ViaPointTask &task, double viaShape, double goalShape)
{
    if (const TrajectoryFailure fault = faultOf(task); fault != TrajectoryFailure::None)
        return fault;
    const OrFailure<Rise> toVia = Rise::resting(viaShape), toGoal = Rise::resting(goalShape);
    if (!toVia || !toGoal)
        return toVia ? toGoal.failure : toVia.failure;
    return solved(task, *toVia, task.viaTime, *toGoal);
}

OrFailure<ViaPointTrajectory> ViaPointTrajectory::full(const ViaPointTask &task, double viaShape, double goalShape)
{
    const OrFailure<Rise> toVia = Rise::resting(viaShape), toGoal = Rise::resting(goalShape);
    if (!toVia || !toGoal)
        return toVia ? toGoal.failure : toVia.failure;
    return full(task, *toVia, *toGoal);
}

OrFailure<ViaPointTrajectory> ViaPointTrajectory::full(const ViaPointTask &task, const Rise &toVia, const Rise &toGoal)
{
    if (const TrajectoryFailure fault = faultOf(task); fault != TrajectoryFailure::None)
        return fault;
    return solved(task, toVia, task.duration, toGoal);
}

OrFailure<ViaPointTrajectory> ViaPointTrajectory::solved(const ViaPointTask &task, const Rise &toVia, double viaSpan,
                                                         const Rise &toGoal)
{
    ViaPointTrajectory made(task, toVia, viaSpan, toGoal);
    const double viaShare = viaSpan == task.viaTime ? 1.0 : toVia.at<0>(task.viaTime * made.viaRate_)[0];
    made.goalShare_ = toGoal.at<0>(task.viaTime * made.goalRate_)[0];
    const double pivot = viaShare - made.goalShare_;
    if (!(std::abs(pivot) > leastRelativePivot * std::max(1.0, made.goalShare_)))
        return TrajectoryFailure::Singular;
    // Both parts as differences, so that a joint that need not move stays where
    // it is.
    made.viaPart_ = ((task.via - task.start) - made.goalShare_ * (task.goal - task.start)) / pivot;
    made.goalPart_ = (viaShare * (task.goal - task.start) - (task.via - task.start)) / pivot;
    made.feedback_ = task.start + made.viaPart_;
    if (!std::isfinite(made.viaPart_) || !std::isfinite(made.goalPart_))
        return TrajectoryFailure::NotFinite;
    return made;
}

std::vector<double> ViaPointTrajectory::knots() const
{
    if (viaSpan_ < task_.duration)
        return {0.0, viaSpan_, task_.duration};
    return {0.0, task_.duration};
}

Series<4, Enclosure> ViaPointTrajectory::over(std::size_t piece, const Enclosure &t) const
{
    const auto argument = [&t](double rate)
    {
        return Enclosure(std::min(t.lower * rate, 1.0), std::min(t.upper * rate, 1.0));
    };
    Series<4, Enclosure> sum{};
    sum[0] = task_.start;
    addRise<4, Enclosure>(sum, toVia_, piece == 0 ? argument(viaRate_) : Enclosure(2.0), viaPart_, viaRate_);
    addRise<4, Enclosure>(sum, toGoal_, argument(goalRate_), goalPart_, goalRate_);
    return sum;
}

Series<3> ViaPointTrajectory::viaJump() const
{
    Series<3> jump{};
    if (viaSpan_ < task_.duration)
    {
        addRise<3>(jump, toVia_, 1.0, -viaPart_, viaRate_);
        jump[0] += viaPart_;
    }
    return jump;
}

double ViaPointTrajectory::overshoot(const ViaPointTask &task, const MotionPeaks &peaks)
{
    const auto [lowest, highest] = std::minmax({task.start, task.via, task.goal});
    return std::max({0.0, lowest - peaks[0].lowest, peaks[0].highest - highest});
}
}  // namespace narrows
