// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/beams/BeamFan.h"

#include <Eigen/Geometry>

namespace narrows
{
namespace
{
template <int D>
PointPath<D> tangentsOf(const PointPath<D> &points)
{
    PointPath<D> tangents;
    const std::size_t last = points.size() - 1;
    for (std::size_t i = 0; i <= last; ++i)
    {
        // Where the path turns back on itself, the way forwards.
        Eigen::Matrix<double, D, 1> along = points[std::min(i + 1, last)] - points[i > 0 ? i - 1 : 0];
        if (along.isZero(0.0))
            along = points[std::min(i + 1, last)] - points[i];
        tangents.push_back(along.normalized());
    }
    return tangents;
}

std::vector<PointPath<2>> directionsOf(const PointPath<2> &, const PointPath<2> &tangents, int)
{
    PointPath<2> left;
    for (const Eigen::Vector2d &tangent : tangents)
        left.emplace_back(-tangent.y(), tangent.x());
    return {left};
}

/// The first vector of the frame at the next point: reflected in the plane between the points, and in that which brings
/// the tangents together.
Eigen::Vector3d carried(const Eigen::Vector3d &vector, const Eigen::Vector3d &step, const Eigen::Vector3d &tangent,
                        const Eigen::Vector3d &nextTangent)
{
    const auto reflected = [](const Eigen::Vector3d &v, const Eigen::Vector3d &normal)
    {
        const double square = normal.squaredNorm();
        return square > 0.0 ? Eigen::Vector3d(v - 2.0 / square * normal.dot(v) * normal) : v;
    };
    const Eigen::Vector3d half = reflected(vector, step), halfTangent = reflected(tangent, step);
    const Eigen::Vector3d next = reflected(half, nextTangent - halfTangent);
    return (next - next.dot(nextTangent) * nextTangent).normalized();
}

std::vector<PointPath<3>> directionsOf(const PointPath<3> &points, const PointPath<3> &tangents, int couples)
{
    const Eigen::Vector3d first = tangents.front();
    const Eigen::Vector3d up = std::abs(first.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
    Eigen::Vector3d u = (up - up.dot(first) * first).normalized();
    std::vector<PointPath<3>> directions(static_cast<std::size_t>(couples));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        if (i > 0)
            u = carried(u, points[i] - points[i - 1], tangents[i - 1], tangents[i]);
        for (int m = 0; m < couples; ++m)
        {
            const double angle = M_PI * m / couples;
            directions[m].push_back(std::cos(angle) * u + std::sin(angle) * tangents[i].cross(u));
        }
    }
    return directions;
}

/// How far a point may go until an obstacle is `room` away, within a hundredth of `margin`.
template <int D>
double freeWay(const Eigen::Matrix<double, D, 1> &from, const Eigen::Matrix<double, D, 1> &direction,
               const PointDistance<D> &distance, double room, double margin, double longest)
{
    double way = 0.0;
    while (way < longest)
    {
        const double step = distance(Eigen::Matrix<double, D, 1>(from + way * direction)) - room;
        if (step <= 0.01 * margin)
            return way;
        way += step;
    }
    return longest;
}

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Of every station, how long its beams may be: less in open space at either end of the path.
template <int D>
std::vector<double> longestBeams(const BeamFan<D> &fan, const BeamFanOptions &options)
{
    const double most = std::min(options.longest, openBeamLinks * options.linkLength);
    std::vector<double> longest(fan.clearance.size(), most);
    const auto isOpen = [&](std::size_t i)
    {
        return fan.clearance[i] > options.openSpace * fan.typicalClearance;
    };
    const std::size_t count = longest.size();
    for (std::size_t i = 0; i < count && isOpen(i); ++i)
        longest[i] = std::min(most, fan.typicalClearance);
    for (std::size_t i = count; i > 0 && isOpen(i - 1); --i)
        longest[i - 1] = std::min(most, fan.typicalClearance);
    return longest;
}
}  // namespace

template <int D>
BeamFan<D> castBeams(const PointPath<D> &middle, const PointDistance<D> &distance, const BeamFanOptions &options)
{
    BeamFan<D> fan;
    fan.stations = resampled<D>(middle, options.spacing);
    fan.spacing = lengthOf<D>(middle) / (fan.count() - 1);
    fan.tangents = tangentsOf<D>(fan.stations);
    for (const auto &station : fan.stations)
        fan.clearance.push_back(distance(station) - options.radius);
    fan.typicalClearance = std::max(medianOf(fan.clearance), 0.0);
    const std::vector<double> longest = longestBeams(fan, options);
    const double margin = 0.01 * options.spacing;
    for (const PointPath<D> &directions : directionsOf(fan.stations, fan.tangents, options.couples))
    {
        BeamCouple<D> couple{directions, {}};
        for (int side = 0; side < 2; ++side)
            for (int i = 0; i < fan.count(); ++i)
                couple.lengths[side].push_back(freeWay<D>(fan.stations[i],
                                                          side == 0 ? directions[i] : (-directions[i]).eval(), distance,
                                                          options.radius + margin, margin, longest[i]));
        fan.couples.push_back(std::move(couple));
    }
    return fan;
}

template BeamFan<2> castBeams(const PointPath<2> &, const PointDistance<2> &, const BeamFanOptions &);
template BeamFan<3> castBeams(const PointPath<3> &, const PointDistance<3> &, const BeamFanOptions &);
}  // namespace narrows
