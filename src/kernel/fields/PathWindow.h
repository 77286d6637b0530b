// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// A polyline in the plane or in space.
template <int D>
using PointPath = std::vector<Eigen::Matrix<double, D, 1>>;

/// Of the whole polyline; 0 of a point or none.
template <int D>
double lengthOf(const PointPath<D> &path)
{
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
        length += (path[i] - path[i - 1]).norm();
    return length;
}

/// Points of a polyline at equal shares of its length, its ends among them.
/// \param count >= 2
/// \pre the path is not empty
template <int D>
PointPath<D> pointsAlong(const PointPath<D> &path, int count)
{
    PointPath<D> points{path.front()};
    const double step = lengthOf<D>(path) / (count - 1);
    double passed = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
        const double length = (path[i] - path[i - 1]).norm();
        double next = step * static_cast<double>(points.size());
        while (length > 0.0 && next <= passed + length && static_cast<int>(points.size()) + 1 < count)
        {
            points.push_back(path[i - 1] + (next - passed) / length * (path[i] - path[i - 1]));
            next = step * static_cast<double>(points.size());
        }
        passed += length;
    }
    while (static_cast<int>(points.size()) < count)
        points.push_back(path.back());
    return points;
}

/// The same with neighbours about `spacing` (> 0) apart, never further.
template <int D>
PointPath<D> resampled(const PointPath<D> &path, double spacing)
{
    const double pieces = std::max(std::ceil(lengthOf<D>(path) / spacing - 1e-9), 1.0);
    return pointsAlong<D>(path, static_cast<int>(pieces) + 1);
}

/// The paper's windowing (Minnetoglu and Conkur 2022, Section 2, without numbers): every point becomes the mean of
/// those up to `halfWidth` places away. The window shrinks towards the ends, which stay where they are.
/// \param halfWidth >= 0
template <int D>
PointPath<D> windowed(const PointPath<D> &path, int halfWidth, int passes)
{
    PointPath<D> before, after = path;
    const int last = static_cast<int>(path.size()) - 1;
    for (int pass = 0; pass < passes; ++pass)
    {
        before = after;
        for (int i = 0; i <= last; ++i)
        {
            const int reach = std::min({halfWidth, i, last - i});
            Eigen::Matrix<double, D, 1> sum = before[i];
            for (int k = 1; k <= reach; ++k)
                sum += before[i - k] + before[i + k];
            after[i] = sum / (2 * reach + 1);
        }
    }
    return after;
}

/// The same with a window that is a length, so that what comes of it does not depend on how dense the points are.
/// \param path points at equal shares of its length, at least two
/// \param halfLength >= 0
template <int D>
PointPath<D> windowedOver(const PointPath<D> &path, double halfLength, int passes)
{
    const double spacing = lengthOf<D>(path) / static_cast<double>(path.size() - 1);
    return spacing > 0.0 ? windowed<D>(path, static_cast<int>(std::lround(halfLength / spacing)), passes) : path;
}
}  // namespace narrows
