// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/CorridorPath.h"

#include <stdexcept>

#include "kernel/fields/BucketQueue.h"

namespace narrows
{
namespace
{
constexpr int cellsPerQuestion = 4096;

/// Dijkstra's algorithm over the cells of a grid.
template <int D>
class CorridorSearch
{
public:
    CorridorSearch(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const CorridorOptions &options,
                   const std::vector<float> &surcharge)
      : grid_(grid),
        steps_(stepsOf(grid, options.steps)),
        cost_(grid, clearance, options),
        stop_(options.stop),
        surcharge_(surcharge),
        costs_(grid.cells(), 0.0F)
    {
        float scarcest = std::numeric_limits<float>::infinity(), most = 1.0F;
        for (int cell = 0; cell < grid.cells(); ++cell)
            if (!grid.occupied(cell))
                scarcest = std::min(scarcest, clearance[cell]);
        for (const float factor : surcharge)
            most = std::max(most, factor);
        if (std::isfinite(scarcest))
            dearest_ = std::min(most * cost_.of(scarcest), dearestCorridor);
    }

    /// Cells from start to goal; none if there is no way. Searches from the goal: chains come from open space, all of
    /// which would be searched before the first passage, where length costs more.
    std::vector<int> run(int start, int goal)
    {
        constexpr double never = std::numeric_limits<double>::infinity();
        reached_.assign(grid_.cells(), never);
        from_.assign(grid_.cells(), -1);
        // Costs of steps are rounded: a little less than the least possible one is safe.
        BucketQueue queue(0.999 * grid_.spacing(),
                          1.001 * std::sqrt(static_cast<double>(D)) * grid_.spacing() * dearest_);
        reached_[goal] = 0.0;
        queue.push(0.0, goal);
        for (int expanded = 1; !queue.empty(); ++expanded)
        {
            if (expanded % cellsPerQuestion == 0 && stop_ && stop_())
            {
                stopped_ = true;
                return {};
            }
            const auto [cost, cell] = queue.pop();
            if (cost > reached_[cell])
                continue;
            // All of this bucket is final, so the start is.
            if (cell == start)
                return traceBack(start);
            expand(cell, cost, queue);
        }
        return {};
    }

    double cost(int cell) const { return reached_[cell]; }
    bool stopped() const { return stopped_; }

private:
    /// Of a unit of length; 0 as long as nobody has asked.
    double costOf(int cell)
    {
        if (costs_[cell] == 0.0F)
        {
            const double extra = surcharge_.empty() ? 1.0 : static_cast<double>(surcharge_[cell]);
            costs_[cell] = static_cast<float>(std::min(extra * cost_(cell), dearestCorridor));
        }
        return costs_[cell];
    }

    void expand(int cell, double cost, BucketQueue &queue)
    {
        const auto index = grid_.index(cell);
        const bool inner = (index.array() > 0).all() && (index.array() + 1 < grid_.counts().array()).all();
        const double here = costOf(cell);
        for (const CellStep<D> &step : steps_)
        {
            if (!inner && !grid_.contains(index + step.offset))
                continue;
            const int next = cell + step.jump;
            if (grid_.occupied(next))
                continue;
            const double there = cost + 0.5 * step.length * (here + costOf(next));
            if (!(there < reached_[next]))
                continue;
            if (std::any_of(step.between.begin(), step.between.end(),
                            [&](int jump) { return grid_.occupied(cell + jump); }))
                continue;
            reached_[next] = there;
            from_[next] = cell;
            queue.push(there, next);
        }
    }

    std::vector<int> traceBack(int cell) const
    {
        std::vector<int> cells;
        for (; cell >= 0; cell = from_[cell])
            cells.push_back(cell);
        return cells;
    }

    const VoxelGrid<D> &grid_;
    std::vector<CellStep<D>> steps_;
    CorridorCost<D> cost_;
    const std::function<bool()> &stop_;
    bool stopped_ = false;
    const std::vector<float> &surcharge_;
    std::vector<float> costs_;
    double dearest_ = 1.0;
    std::vector<double> reached_;
    std::vector<int> from_;
};

template <int D>
void check(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const CorridorOptions &options,
           const std::vector<float> &surcharge)
{
    const auto cells = static_cast<std::size_t>(grid.cells());
    if (clearance.size() != cells || (!surcharge.empty() && surcharge.size() != cells))
        throw std::invalid_argument("findCorridor: a field does not belong to the grid");
    if (!(options.preference >= 0.0) || !(options.wide > 0.0))
        throw std::invalid_argument("findCorridor: preference must be >= 0 and wide > 0");
}
}  // namespace

std::string toText(CorridorFailure failure)
{
    switch (failure)
    {
        case CorridorFailure::None:
            return "none";
        case CorridorFailure::StartOutside:
            return "start_outside";
        case CorridorFailure::GoalOutside:
            return "goal_outside";
        case CorridorFailure::StartBlocked:
            return "start_blocked";
        case CorridorFailure::GoalBlocked:
            return "goal_blocked";
        case CorridorFailure::NotConnected:
            return "not_connected";
        case CorridorFailure::Stopped:
            return "stopped";
    }
    return "unknown";
}

template <int D>
Corridor<D> findCorridor(const VoxelGrid<D> &grid, const std::vector<float> &clearance,
                         const Eigen::Matrix<double, D, 1> &start, const Eigen::Matrix<double, D, 1> &goal,
                         const CorridorOptions &options, const std::vector<float> &surcharge)
{
    check(grid, clearance, options, surcharge);
    Corridor<D> corridor;
    const auto failed = [&corridor](CorridorFailure failure)
    {
        corridor.failure = failure;
        return corridor;
    };
    const int first = grid.cellAround(start), last = grid.cellAround(goal);
    if (first < 0)
        return failed(CorridorFailure::StartOutside);
    if (last < 0)
        return failed(CorridorFailure::GoalOutside);
    if (grid.occupied(first))
        return failed(CorridorFailure::StartBlocked);
    if (grid.occupied(last))
        return failed(CorridorFailure::GoalBlocked);

    CorridorSearch<D> search(grid, clearance, options, surcharge);
    corridor.cells = search.run(first, last);
    if (corridor.cells.empty())
        return failed(search.stopped() ? CorridorFailure::Stopped : CorridorFailure::NotConnected);
    corridor.cost = search.cost(first);
    corridor.clearance = clearance[first];
    for (int cell : corridor.cells)
        corridor.clearance = std::min(corridor.clearance, static_cast<double>(clearance[cell]));
    corridor.path.push_back(start);
    for (std::size_t i = 1; i + 1 < corridor.cells.size(); ++i)
        corridor.path.push_back(grid.center(corridor.cells[i]));
    corridor.path.push_back(goal);
    return corridor;
}

template Corridor<2> findCorridor(const VoxelGrid<2> &, const std::vector<float> &, const Eigen::Vector2d &,
                                  const Eigen::Vector2d &, const CorridorOptions &, const std::vector<float> &);
template Corridor<3> findCorridor(const VoxelGrid<3> &, const std::vector<float> &, const Eigen::Vector3d &,
                                  const Eigen::Vector3d &, const CorridorOptions &, const std::vector<float> &);
}  // namespace narrows
