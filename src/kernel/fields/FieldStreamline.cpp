// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/FieldStreamline.h"

namespace narrows
{
std::string toText(StreamlineFailure failure)
{
    switch (failure)
    {
        case StreamlineFailure::None:
            return "none";
        case StreamlineFailure::StartOutside:
            return "start_outside";
        case StreamlineFailure::StartBlocked:
            return "start_blocked";
        case StreamlineFailure::Stalled:
            return "stalled";
        case StreamlineFailure::LeftFreeCells:
            return "left_free_cells";
        case StreamlineFailure::TooLong:
            return "too_long";
    }
    return "unknown";
}

template <int D>
double FieldSample<D>::phiAt(const typename VoxelGrid<D>::Index &index) const
{
    return grid_.contains(index) ? phi_[grid_.cell(index)] : std::numeric_limits<double>::infinity();
}

template <int D>
double FieldSample<D>::value(const Point &point, double reference) const
{
    const Point place = ((point - grid_.lower()).array() / grid_.spacing() - 0.5).matrix();
    const Point base = place.array().floor().matrix();
    const Point share = place - base;
    double sum = 0.0;
    for (int corner = 0; corner < 1 << D; ++corner)
    {
        auto index = base.template cast<int>().eval();
        double weight = 1.0;
        for (int axis = 0; axis < D; ++axis)
        {
            const bool upper = (corner >> axis & 1) != 0;
            index[axis] += upper ? 1 : 0;
            weight *= upper ? share[axis] : 1.0 - share[axis];
        }
        if (weight > 0.0)
            sum += weight * std::exp(reference - phiAt(index));
    }
    return sum;
}

template <int D>
double FieldSample<D>::leastPhi(const Point &point) const
{
    const Point place = ((point - grid_.lower()).array() / grid_.spacing() - 0.5).matrix();
    const auto base = place.array().round().matrix().template cast<int>().eval();
    double least = std::numeric_limits<double>::infinity();
    for (int code = 0; code < (D == 2 ? 9 : 27); ++code)
    {
        auto index = base;
        for (int axis = 0, rest = code; axis < D; ++axis, rest /= 3)
            index[axis] += rest % 3 - 1;
        least = std::min(least, phiAt(index));
    }
    return least;
}

template <int D>
typename FieldSample<D>::Point FieldSample<D>::slope(const Point &point) const
{
    const double reference = leastPhi(point);
    Point result = Point::Zero();
    if (!std::isfinite(reference))
        return result;
    for (int axis = 0; axis < D; ++axis)
    {
        const Point half = 0.5 * grid_.spacing() * Point::Unit(axis);
        result[axis] = value(point + half, reference) - value(point - half, reference);
    }
    return result;
}

template <int D>
Streamline<D> followField(const VoxelGrid<D> &grid, const std::vector<double> &phi,
                          const Eigen::Matrix<double, D, 1> &start, const Eigen::Matrix<double, D, 1> &goal,
                          int maxSteps)
{
    Streamline<D> line;
    const auto ended = [&line](StreamlineFailure failure)
    {
        line.failure = failure;
        return line;
    };
    const int first = grid.cellAround(start);
    if (first < 0)
        return ended(StreamlineFailure::StartOutside);
    if (!std::isfinite(phi[first]))
        return ended(StreamlineFailure::StartBlocked);

    const FieldSample<D> field(grid, phi);
    const double step = 0.5 * grid.spacing();
    std::int64_t left = maxSteps > 0 ? maxSteps : 4 * std::int64_t{grid.freeCells()};
    Eigen::Matrix<double, D, 1> point = start;
    line.path.push_back(point);
    while ((point - goal).norm() > 3.0 * step)
    {
        if (left-- <= 0)
            return ended(StreamlineFailure::TooLong);
        const Eigen::Matrix<double, D, 1> slope = field.slope(point);
        const double steepness = slope.norm();
        if (!(steepness > 0.0))
            return ended(StreamlineFailure::Stalled);
        point += step / steepness * slope;
        const int cell = grid.cellAround(point);
        if (cell < 0 || grid.occupied(cell))
            return ended(StreamlineFailure::LeftFreeCells);
        line.path.push_back(point);
    }
    line.path.push_back(goal);
    return line;
}

template class FieldSample<2>;
template class FieldSample<3>;
template Streamline<2> followField(const VoxelGrid<2> &, const std::vector<double> &, const Eigen::Vector2d &,
                                   const Eigen::Vector2d &, int);
template Streamline<3> followField(const VoxelGrid<3> &, const std::vector<double> &, const Eigen::Vector3d &,
                                   const Eigen::Vector3d &, int);
}  // namespace narrows
