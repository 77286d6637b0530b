// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "kernel/fields/CellSteps.h"
#include "kernel/fields/VoxelGrid.h"

namespace narrows
{
/// Why there is no corridor.
enum class CorridorFailure
{
    None,
    StartOutside,  ///< beyond the grid
    GoalOutside,
    StartBlocked,  ///< in an occupied cell
    GoalBlocked,
    NotConnected,  ///< no way through free cells
    Stopped,       ///< because `stop` said so
};

/// "not_connected" and the like.
std::string toText(CorridorFailure failure);

constexpr double dearestCorridor = 1e5;  ///< most that a unit of length costs, in units of one in the wide

/// What a corridor is dear for.
struct CorridorOptions
{
    /// p >= 0: a unit of length costs (wide / clearance)^p, at most dearestCorridor, the mean of the step's two ends; 0
    /// is the shortest path.
    double preference = 2.0;
    /// > 0: clearance beyond which more is not better, in units of length. By default the greatest there is. A narrow
    /// value straightens the path in rooms that are wider than this.
    double wide = std::numeric_limits<double>::infinity();
    CellSteps steps = CellSteps::All;  ///< to neighbours: which
    std::function<bool()> stop;        ///< asked every few thousand cells; may be empty
};

/// What a unit of length costs in the free cells of a grid. Refers to the clearance.
template <int D>
class CorridorCost
{
public:
    /// \param clearance of every cell, as findCorridor() takes it
    CorridorCost(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const CorridorOptions &options)
      : clearance_(clearance), preference_(options.preference)
    {
        float widest = 0.0F;
        for (int cell = 0; cell < grid.cells(); ++cell)
            if (!grid.occupied(cell) && std::isfinite(clearance[cell]))
                widest = std::max(widest, clearance[cell]);
        wide_ = std::min(widest > 0.0F ? static_cast<double>(widest) : 1.0, options.wide);
    }

    /// In [1, dearestCorridor].
    double operator()(int cell) const { return of(clearance_[cell]); }
    /// At a clearance, which it falls with.
    double of(double clearance) const
    {
        const double scarce = wide_ / std::min(clearance, wide_);
        return std::min(std::pow(scarce, preference_), dearestCorridor);
    }

private:
    const std::vector<float> &clearance_;
    double preference_;
    double wide_;
};

/// A way from start to goal through the free cells of a grid.
template <int D>
struct Corridor
{
    CorridorFailure failure = CorridorFailure::None;  ///< none: the path is whole
    std::vector<int> cells;                           ///< from the start's to the goal's
    std::vector<Eigen::Matrix<double, D, 1>> path;    ///< start, centers of the cells between, goal
    double cost = 0.0;                                ///< of the path
    double clearance = 0.0;                           ///< the least of the field over the cells
};

/// The path of least cost, exactly, by Dijkstra's algorithm. Deterministic.
/// \param clearance of every cell's center (DistanceField.h), > 0 in free cells, finite or infinite
/// \param surcharge empty, or a factor >= 1 per cell on what a unit of length costs there
/// \throws std::invalid_argument if sizes or options do not fit
template <int D>
Corridor<D> findCorridor(const VoxelGrid<D> &grid, const std::vector<float> &clearance,
                         const Eigen::Matrix<double, D, 1> &start, const Eigen::Matrix<double, D, 1> &goal,
                         const CorridorOptions &options = {}, const std::vector<float> &surcharge = {});

extern template Corridor<2> findCorridor(const VoxelGrid<2> &, const std::vector<float> &, const Eigen::Vector2d &,
                                         const Eigen::Vector2d &, const CorridorOptions &, const std::vector<float> &);
extern template Corridor<3> findCorridor(const VoxelGrid<3> &, const std::vector<float> &, const Eigen::Vector3d &,
                                         const Eigen::Vector3d &, const CorridorOptions &, const std::vector<float> &);
}  // namespace narrows
