// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/TimedPoints.h"

#include <cmath>

namespace narrows
{
namespace
{
constexpr double shortestSegment = 1e-9;  // of the duration: below it times are rounding
}  // namespace

TrajectoryFailure faultOf(const Eigen::MatrixXd &points, const std::vector<double> &times)
{
    if (points.rows() < 1 || points.cols() < 2 || static_cast<std::size_t>(points.cols()) != times.size())
        return TrajectoryFailure::BadCount;
    if (!points.allFinite())
        return TrajectoryFailure::NotFinite;
    for (const double time : times)
        if (!std::isfinite(time))
            return TrajectoryFailure::NotFinite;
    if (times.front() != 0.0 || times.back() > longestTime)
        return TrajectoryFailure::BadTime;
    for (std::size_t i = 1; i < times.size(); ++i)
        if (!(times[i] - times[i - 1] > shortestSegment * times.back()))
            return TrajectoryFailure::BadTime;
    return TrajectoryFailure::None;
}

}  // namespace narrows
