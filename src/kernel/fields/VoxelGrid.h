// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// Why there is no grid.
enum class GridFailure
{
    None,
    NotFinite,     ///< a bound or the spacing is not a finite number
    EmptyBounds,   ///< the lower bound is not below the upper one
    BadSpacing,    ///< not positive
    TooManyCells,  ///< more than asked for as the most
};

/// "too_many_cells" and the like.
std::string toText(GridFailure failure);

/// The workspace in square or cubic cells, each free or occupied, the plane and space alike.
///
/// A cell is judged by its center: that is the place a value of any field over the grid belongs to. Cells are counted
/// with the first axis running fastest. What lies beyond the grid is nobody's: each field says how it sees it.
template <int D>
class VoxelGrid
{
public:
    using Point = Eigen::Matrix<double, D, 1>;  ///< in the plane or in space
    using Index = Eigen::Matrix<int, D, 1>;     ///< of a cell along every axis, from 0

    struct Result;

    /// All cells free. If the bounds are no whole number of cells wide, the grid reaches beyond the upper ones.
    /// \param spacing edge of a cell
    /// \param maxCells at most 2^31 - 1
    static Result make(const Point &lower, const Point &upper, double spacing, std::int64_t maxCells = 100'000'000);

    int cells() const { return static_cast<int>(occupied_.size()); }  ///< how many, free and occupied
    const Index &counts() const { return counts_; }                   ///< of cells along every axis
    const Point &lower() const { return lower_; }                     ///< corner with the least coordinates
    Point upper() const { return lower_ + spacing_ * counts_.template cast<double>(); }  ///< the opposite corner
    double spacing() const { return spacing_; }                                          ///< side of a cell
    /// From one cell to the next one along an axis.
    int stride(int axis) const { return strides_[axis]; }

    /// Whether there is such a cell.
    bool contains(const Index &index) const
    {
        return (index.array() >= 0).all() && (index.array() < counts_.array()).all();
    }
    /// Linear: of a difference of indices it is the difference of the cells.
    int cell(const Index &index) const { return index.dot(strides_); }
    /// \param cell from 0, below cells()
    Index index(int cell) const
    {
        Index result;
        for (int axis = D - 1; axis >= 0; --axis)
        {
            result[axis] = cell / strides_[axis];
            cell -= result[axis] * strides_[axis];
        }
        return result;
    }
    /// Of a cell, also of one beyond the grid.
    Point center(const Index &index) const
    {
        return (lower_.array() + spacing_ * (index.template cast<double>().array() + 0.5)).matrix();
    }
    Point center(int cell) const { return center(index(cell)); }  ///< of a cell of the grid
    /// The cell around a point, -1 beyond the grid. A point between cells belongs to the upper one.
    int cellAround(const Point &point) const
    {
        const Point place = (point - lower_) / spacing_;
        if (!(place.array() >= 0.0).all() || !(place.array() < counts_.template cast<double>().array()).all())
            return -1;
        return cell(Index(place.array().floor().template cast<int>()));
    }

    bool occupied(int cell) const { return occupied_[cell] != 0; }  ///< whether the cell is
    /// Beyond the grid nothing is free.
    bool free(const Index &index) const { return contains(index) && !occupied(cell(index)); }
    void occupy(int cell) { occupied_[cell] = 1; }                            ///< the cell
    void clear() { std::fill(occupied_.begin(), occupied_.end(), char{0}); }  ///< all cells
    /// How many are not occupied.
    int freeCells() const { return static_cast<int>(std::count(occupied_.begin(), occupied_.end(), char{0})); }

    /// Occupies every cell whose center is at most `room` from an obstacle. Looks at whole blocks first, so that the
    /// work goes with the obstacle's surface.
    /// \param distance of a point from the obstacle, zero or negative inside. Between two points it changes by no more
    /// than they are apart; it may remain zero inside.
    template <class Distance>
    void occupyWithin(const Distance &distance, double room)
    {
        occupyBlock(Index::Zero(), counts_, distance, room);
    }

private:
    template <class Distance>
    void occupyBlock(const Index &begin, const Index &end, const Distance &distance, double room)
    {
        const Index size = end - begin;
        const Point half = 0.5 * spacing_ * (size.template cast<double>().array() - 1.0).matrix();
        const double reach = half.norm() * (1.0 + 1e-12);
        const double away = distance(Point(center(begin) + half));
        if (away > room + reach)
            return;
        if (away <= room - reach)
        {
            fillBlock(begin, end);
            return;
        }
        int axis = 0;
        size.maxCoeff(&axis);
        if (size[axis] == 1)
            return;
        Index middle = end;
        middle[axis] = begin[axis] + size[axis] / 2;
        occupyBlock(begin, middle, distance, room);
        Index next = begin;
        next[axis] = middle[axis];
        occupyBlock(next, end, distance, room);
    }
    void fillBlock(const Index &begin, const Index &end);

    Point lower_ = Point::Zero();
    double spacing_ = 1.0;
    Index counts_ = Index::Zero();
    Index strides_ = Index::Zero();
    std::vector<char> occupied_;
};

/// A grid, or why there is none.
template <int D>
struct VoxelGrid<D>::Result
{
    GridFailure failure = GridFailure::None;  ///< none: the grid is whole
    VoxelGrid grid;                           ///< without cells if there is a failure
};

extern template class VoxelGrid<2>;
extern template class VoxelGrid<3>;
}  // namespace narrows
