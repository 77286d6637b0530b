// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/PathTiming.h"

#include <stdexcept>

#include "benchmark/ProvenMotions.h"
#include "benchmark/Text.h"
#include "kernel/trajectory/StopAndGo.h"
#include "kernel/trajectory/TrajectoryPeaks.h"
#include "planners/TrajectorySmoother.h"

namespace narrows
{
namespace
{
constexpr Eigen::Index mostCorners = 40;  // of a polyline that is tried as it is

Eigen::MatrixXd columnsOf(const std::vector<Eigen::VectorXd> &path)
{
    if (path.empty())
        return {};
    Eigen::MatrixXd points(path.front().size(), static_cast<Eigen::Index>(path.size()));
    for (std::size_t i = 0; i < path.size(); ++i)
        points.col(static_cast<Eigen::Index>(i)) = path[i];
    return points;
}

/// Then the way itself is the task: no corner may be cut.
bool mustFollowTipPath(const Scenario &scenario)
{
    return !scenario.isPlanar() && std::holds_alternative<SpatialTipPath>(scenario.spatial().task.goal);
}

/// The fastest along the polylines that come into question: the path as it is, if it has few corners, with shortcuts
/// from either end, and the one that a smooth path was made from.
OrFailure<SmoothedTrajectory> fastestAlong(const Eigen::MatrixXd &corners, const Eigen::MatrixXd &vias,
                                           const std::vector<MotionLimits> &limits, const ProvenMotions &proven)
{
    std::vector<Eigen::MatrixXd> ways{proven.withShortcuts(corners),
                                      proven.withShortcuts(corners.rowwise().reverse()).rowwise().reverse()};
    if (corners.cols() <= mostCorners)
        ways.push_back(corners);
    if (vias.cols() > 1 && proven.isFree(vias))
        ways.push_back(vias);
    std::optional<OrFailure<SmoothedTrajectory>> best;
    double leastStops = std::numeric_limits<double>::infinity();
    for (const Eigen::MatrixXd &way : ways)
    {
        OrFailure<SmoothedTrajectory> smooth =
            smoothTrajectory(way, limits, [&proven](const JointTrajectory &motion) { return proven.isFree(motion); });
        if (!smooth)
            return smooth.failure;
        leastStops = std::min(leastStops, smooth->stopDuration);
        if (!best || smooth->motion.duration() < (*best)->motion.duration())
            best.emplace(std::move(smooth));
    }
    best->value->stopDuration = leastStops;
    return std::move(*best);
}
}  // namespace

MotionLimits limitsFromText(const std::string &text)
{
    const std::vector<std::string> parts = split(text, ',');
    std::vector<double> numbers;
    for (const std::string &part : parts)
        numbers.push_back(toNumber(part).value_or(0.0));
    if (numbers.size() == 3)
        if (const MotionLimits limits{numbers[0], numbers[1], numbers[2]}; limits.valid())
            return limits;
    throw std::invalid_argument("limits are three positive numbers: velocity,acceleration,jerk; not '" + text + "'");
}

OrFailure<PathTiming> timePath(const RunSpec &spec, const Record &record, const MotionLimits &limits)
{
    const std::vector<Eigen::VectorXd> &path = record.path;
    const std::vector<MotionLimits> ofJoints(path.empty() ? 0 : static_cast<std::size_t>(path.front().size()), limits);
    const Eigen::MatrixXd corners = polylineCorners(columnsOf(path));
    PathTiming timing;
    if (mustFollowTipPath(*spec.scenario))
    {
        OrFailure<PolynomialTrajectory> stops = sevenPhaseStops(corners, ofJoints);
        if (!stops)
            return stops.failure;
        timing.method = "stop and go";
        timing.stopDuration = stops->duration();
        timing.motion = std::make_unique<PolynomialTrajectory>(std::move(*stops.value));
    }
    else if (OrFailure<SmoothedTrajectory> smooth =
                 fastestAlong(corners, columnsOf(record.vias), ofJoints, ProvenMotions(spec)))
    {
        timing.method = smooth->blended ? "overlapped moves" : "stop and go";
        timing.stopDuration = smooth->stopDuration;
        timing.motion = std::make_unique<PolynomialTrajectory>(std::move(smooth.value->motion));
    }
    else
        return smooth.failure;
    timing.peaks = trajectoryPeaks(*timing.motion);
    return OrFailure<PathTiming>(std::move(timing));
}

void recordTiming(const RunSpec &spec, Record &record)
{
    if (!spec.limits || record.outcome != Outcome::Solved)
        return;
    const OrFailure<PathTiming> timing = timePath(spec, record, *spec.limits);
    if (!timing)
        return;  // a path that does not move has no duration: its columns stay empty
    const Series<3> peaks = largestPeaks(timing->peaks);
    record.duration = timing->motion->duration();
    record.stopDuration = timing->stopDuration;
    record.peakVelocity = peaks[1];
    record.peakAcceleration = peaks[2];
    record.peakJerk = peaks[3];
}
}  // namespace narrows
