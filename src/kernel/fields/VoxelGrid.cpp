// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/VoxelGrid.h"

namespace narrows
{
std::string toText(GridFailure failure)
{
    switch (failure)
    {
        case GridFailure::None:
            return "none";
        case GridFailure::NotFinite:
            return "not_finite";
        case GridFailure::EmptyBounds:
            return "empty_bounds";
        case GridFailure::BadSpacing:
            return "bad_spacing";
        case GridFailure::TooManyCells:
            return "too_many_cells";
    }
    return "unknown";
}

template <int D>
typename VoxelGrid<D>::Result VoxelGrid<D>::make(const Point &lower, const Point &upper, double spacing,
                                                 std::int64_t maxCells)
{
    if (!lower.allFinite() || !upper.allFinite() || !std::isfinite(spacing))
        return {GridFailure::NotFinite, {}};
    if (!(lower.array() < upper.array()).all())
        return {GridFailure::EmptyBounds, {}};
    if (!(spacing > 0.0))
        return {GridFailure::BadSpacing, {}};

    // A bound that is a whole number of cells away, but for rounding, gets no further cell.
    const Point counts = ((upper - lower).array() / spacing - 1e-9).ceil().max(1.0).matrix();
    const auto most = std::min(maxCells, std::int64_t{std::numeric_limits<int>::max()});
    if (!(counts.prod() <= static_cast<double>(most)))
        return {GridFailure::TooManyCells, {}};

    Result result;
    VoxelGrid &grid = result.grid;
    grid.lower_ = lower;
    grid.spacing_ = spacing;
    grid.counts_ = counts.template cast<int>();
    int cells = 1;
    for (int axis = 0; axis < D; ++axis)
    {
        grid.strides_[axis] = cells;
        cells *= grid.counts_[axis];
    }
    grid.occupied_.assign(cells, 0);
    return result;
}

template <int D>
void VoxelGrid<D>::fillBlock(const Index &begin, const Index &end)
{
    const int length = end[0] - begin[0];
    Index row = begin;
    while (true)
    {
        std::fill_n(occupied_.begin() + cell(row), length, char{1});
        int axis = 1;
        while (axis < D && ++row[axis] == end[axis])
        {
            row[axis] = begin[axis];
            ++axis;
        }
        if (axis == D)
            return;
    }
}

template class VoxelGrid<2>;
template class VoxelGrid<3>;
}  // namespace narrows
