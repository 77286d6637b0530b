// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/DistanceField.h"

namespace narrows
{
namespace
{
/// Replaces f by min over j of f(j) + (i - j)^2 along one row.
class RowTransform
{
public:
    explicit RowTransform(int length) : values_(length), apexes_(length), begins_(length) {}

    void apply(int *row, int length, int stride)
    {
        int count = 0;
        for (int i = 0; i < length; ++i)
        {
            values_[i] = row[static_cast<std::ptrdiff_t>(i) * stride];
            if (values_[i] != noSquaredDistance)
                count = push(i, length, count);
        }
        if (count == 0)
            return;
        for (int k = 0; k < count; ++k)
        {
            const int end = k + 1 < count ? begins_[k + 1] : length;
            for (int i = begins_[k]; i < end; ++i)
                row[static_cast<std::ptrdiff_t>(i) * stride] =
                    values_[apexes_[k]] + (i - apexes_[k]) * (i - apexes_[k]);
        }
    }

private:
    /// Adds the parabola with its apex over i to the `count` of the envelope so far.
    int push(int i, int length, int count)
    {
        int begin = 0;
        while (count > 0)
        {
            begin = takeover(apexes_[count - 1], i);
            if (begin > begins_[count - 1])
                break;
            --count;
            begin = 0;
        }
        if (begin >= length)
            return count;
        apexes_[count] = i;
        begins_[count] = begin;
        return count + 1;
    }

    /// The first whole place where the parabola over j > i is not above the one over i; at least 0.
    int takeover(int i, int j) const
    {
        const std::int64_t first = i, second = j;
        const std::int64_t rise = values_[j] - std::int64_t{values_[i]} + second * second - first * first;
        const std::int64_t run = 2 * (second - first);
        return rise <= 0 ? 0 : static_cast<int>(std::min<std::int64_t>((rise + run - 1) / run, noSquaredDistance));
    }

    std::vector<int> values_;
    std::vector<int> apexes_;
    std::vector<int> begins_;  ///< where each parabola takes over
};

/// Squared steps to the layer around the grid.
template <int D>
int squaredStepsOut(const Eigen::Matrix<int, D, 1> &index, const Eigen::Matrix<int, D, 1> &counts)
{
    const int steps = std::min((index.array() + 1).minCoeff(), (counts - index).minCoeff());
    return steps * steps;
}
}  // namespace

template <int D>
std::vector<int> squaredDistances(const VoxelGrid<D> &grid, GridBorder border)
{
    std::vector<int> squares(grid.cells());
    for (int cell = 0; cell < grid.cells(); ++cell)
        squares[cell] = grid.occupied(cell) ? 0 : noSquaredDistance;
    RowTransform transform(grid.counts().maxCoeff());
    for (int axis = 0; axis < D; ++axis)
    {
        const int stride = grid.stride(axis), length = grid.counts()[axis];
        for (int block = 0; block < grid.cells(); block += stride * length)
            for (int row = 0; row < stride; ++row)
                transform.apply(&squares[block + row], length, stride);
    }
    if (border == GridBorder::Wall)
        for (int cell = 0; cell < grid.cells(); ++cell)
            squares[cell] = std::min(squares[cell], squaredStepsOut<D>(grid.index(cell), grid.counts()));
    return squares;
}

template <int D>
std::vector<float> distanceField(const VoxelGrid<D> &grid, GridBorder border)
{
    const std::vector<int> squares = squaredDistances(grid, border);
    std::vector<float> distances(squares.size());
    for (std::size_t i = 0; i < squares.size(); ++i)
        distances[i] = squares[i] == noSquaredDistance
                           ? std::numeric_limits<float>::infinity()
                           : static_cast<float>(grid.spacing() * std::sqrt(static_cast<double>(squares[i])));
    return distances;
}

template std::vector<int> squaredDistances(const VoxelGrid<2> &, GridBorder);
template std::vector<int> squaredDistances(const VoxelGrid<3> &, GridBorder);
template std::vector<float> distanceField(const VoxelGrid<2> &, GridBorder);
template std::vector<float> distanceField(const VoxelGrid<3> &, GridBorder);
}  // namespace narrows
