// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/StopAndGo.h"

#include <stdexcept>

#include "kernel/trajectory/JerkLimitedMove.h"
#include "kernel/trajectory/SegmentWay.h"
#include "kernel/trajectory/TimedPoints.h"

namespace narrows
{
namespace
{
constexpr double repeatTolerance = 1e-12;  // of the largest coordinate

TrajectoryFailure faultOf(const Eigen::MatrixXd &points)
{
    if (points.rows() < 1 || points.cols() < 1)
        return TrajectoryFailure::BadCount;
    return points.allFinite() ? TrajectoryFailure::None : TrajectoryFailure::NotFinite;
}

TrajectoryFailure faultOf(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits)
{
    if (const TrajectoryFailure fault = faultOf(points); fault != TrajectoryFailure::None)
        return fault;
    if (static_cast<Eigen::Index>(limits.size()) != points.rows())
        return TrajectoryFailure::BadCount;
    for (const MotionLimits &own : limits)
        if (!own.valid())
            return TrajectoryFailure::BadLimit;
    return TrajectoryFailure::None;
}

/// What the joint with the longest way may do, so that no joint exceeds its own limits.
MotionLimits limitsAlong(const Eigen::VectorXd &direction, const std::vector<MotionLimits> &limits)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    MotionLimits along{infinity, infinity, infinity};
    for (Eigen::Index i = 0; i < direction.size(); ++i)
    {
        const MotionLimits &own = limits[static_cast<std::size_t>(i)];
        const double share = std::abs(direction[i]);
        along.velocity = std::min(along.velocity, own.velocity / share);
        along.acceleration = std::min(along.acceleration, own.acceleration / share);
        along.jerk = std::min(along.jerk, own.jerk / share);
    }
    return along;
}

struct Segment
{
    Eigen::VectorXd from, direction;  ///< of the joint with the longest way: +-1
    double distance;                  ///< of that joint
};

std::vector<Segment> segmentsOf(const Eigen::MatrixXd &vertices)
{
    std::vector<Segment> segments;
    for (Eigen::Index k = 1; k < vertices.cols(); ++k)
    {
        const Eigen::VectorXd difference = vertices.col(k) - vertices.col(k - 1);
        const double distance = difference.cwiseAbs().maxCoeff();
        if (!(distance > 0.0))
            throw std::invalid_argument("a vertex repeats its predecessor");
        segments.push_back({vertices.col(k - 1), difference / distance, distance});
    }
    return segments;
}

void append(const Segment &segment, const SegmentWay &way, std::vector<PolynomialTrajectory::Piece> &pieces)
{
    for (const WayPiece &piece : way)
    {
        pieces.push_back({piece.duration, segment.direction * piece.coefficients});
        pieces.back().coefficients.col(0) += segment.from;
    }
}

template <class MakeWay>
OrFailure<PolynomialTrajectory> stops(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits,
                                      const MakeWay &makeWay)
{
    if (const TrajectoryFailure fault = faultOf(points, limits); fault != TrajectoryFailure::None)
        return fault;
    std::vector<PolynomialTrajectory::Piece> pieces;
    for (const Segment &segment : segmentsOf(distinctVertices(points)))
    {
        const SegmentWay way = makeWay(segment.distance, limitsAlong(segment.direction, limits));
        if (!(timeOf(way) <= longestTime))
            return TrajectoryFailure::BadTime;
        append(segment, way, pieces);
    }
    if (pieces.empty())
        return TrajectoryFailure::NoMotion;
    return PolynomialTrajectory(std::move(pieces));
}
}  // namespace

Eigen::MatrixXd distinctVertices(const Eigen::MatrixXd &points)
{
    if (points.size() == 0)
        return points;
    const double tolerance = repeatTolerance * points.cwiseAbs().maxCoeff();
    Eigen::MatrixXd kept(points.rows(), points.cols());
    kept.col(0) = points.col(0);
    Eigen::Index count = 1;
    for (Eigen::Index k = 1; k < points.cols(); ++k)
        if ((points.col(k) - kept.col(count - 1)).cwiseAbs().maxCoeff() > tolerance)
            kept.col(count++) = points.col(k);
    if (count > 1)
        kept.col(count - 1) = points.col(points.cols() - 1);
    return kept.leftCols(count);
}

Eigen::MatrixXd polylineCorners(const Eigen::MatrixXd &points)
{
    Eigen::MatrixXd vertices = distinctVertices(points);
    if (vertices.size() == 0)
        return vertices;
    const double tolerance = repeatTolerance * points.cwiseAbs().maxCoeff();
    const auto between = [&](Eigen::Index from, Eigen::Index middle, Eigen::Index to)
    {
        const Eigen::VectorXd way = vertices.col(to) - vertices.col(from);
        const Eigen::VectorXd own = vertices.col(middle) - vertices.col(from);
        const double share = own.dot(way) / way.squaredNorm();
        return share >= 0.0 && share <= 1.0 && (own - share * way).cwiseAbs().maxCoeff() <= tolerance;
    };
    Eigen::Index corner = 0;
    for (Eigen::Index k = 1; k < vertices.cols(); ++k)
        if (k + 1 == vertices.cols() || !between(corner, k, k + 1))
            vertices.col(++corner) = vertices.col(k);
    return vertices.leftCols(corner + 1);
}

OrFailure<PolynomialTrajectory> sevenPhaseStops(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits)
{
    return stops(points, limits, sevenPhaseWay);
}

OrFailure<PolynomialTrajectory> quinticStops(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits)
{
    return stops(points, limits, quinticWay);
}

OrFailure<PolynomialTrajectory> trapezoidStops(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits)
{
    return stops(points, limits, trapezoidWay);
}

OrFailure<PolynomialTrajectory> parabolicBlends(const Eigen::MatrixXd &points, const std::vector<double> &times)
{
    if (const TrajectoryFailure fault = faultOf(points, times); fault != TrajectoryFailure::None)
        return fault;
    std::vector<PolynomialTrajectory::Piece> pieces;
    std::size_t k = 0;
    for (const Segment &segment : segmentsOf(points))
    {
        append(segment, blendedWay(segment.distance, times[k + 1] - times[k]), pieces);
        ++k;
    }
    return PolynomialTrajectory(std::move(pieces));
}

OrFailure<std::vector<double>> stopTimes(const Eigen::MatrixXd &points, const std::vector<MotionLimits> &limits)
{
    if (const TrajectoryFailure fault = faultOf(points, limits); fault != TrajectoryFailure::None)
        return fault;
    std::vector<double> times{0.0};
    for (const Segment &segment : segmentsOf(points))
        times.push_back(times.back() +
                        fastestMove(segment.distance, limitsAlong(segment.direction, limits)).duration());
    return times;
}
}  // namespace narrows
