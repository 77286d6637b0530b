// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/LaplaceSweeps.h"

#include <array>

namespace narrows
{
namespace
{
using Value = long double;

/// The cells connected with the goal, layer by layer.
template <int D>
class LayeredCells
{
public:
    LayeredCells(const VoxelGrid<D> &grid, int goal)
    {
        const std::vector<int> steps = stepsToGoal(grid, goal);
        sortByLayers(steps);
        std::vector<int> places(grid.cells(), -1);
        for (std::size_t i = 0; i < cells_.size(); ++i)
            places[cells_[i]] = static_cast<int>(i);
        neighbours_.resize(cells_.size());
        for (std::size_t i = 0; i < cells_.size(); ++i)
            neighbours_[i] = neighboursOf(grid, places, steps, cells_[i]);
        // One more, always 0, for all that is no cell.
        values_.assign(cells_.size() + 1, 0.0L);
        values_[0] = 1.0L;
    }

    void sweepOutwards()
    {
        for (std::size_t i = 1; i < cells_.size(); ++i)
            values_[i] = meanAt(i);
    }

    void sweepBack()
    {
        for (std::size_t i = cells_.size(); i-- > 1;)
            values_[i] = meanAt(i);
    }

    /// Scales every layer, so that the equations summed over each hold.
    void balanceLayers()
    {
        // f_l own_l = f_(l-1) inner_l + f_(l+1) outer_l: cells of one layer are no neighbours.
        const std::size_t layers = begins_.size() - 1;
        std::vector<Value> ratios(layers + 1, 0.0L);
        for (std::size_t l = layers - 1; l > 0; --l)
        {
            Value own = 0.0L, inner = 0.0L, outer = 0.0L;
            for (int i = begins_[l]; i < begins_[l + 1]; ++i)
            {
                own += 2 * D * values_[i];
                for (int k = 0; k < 2 * D; ++k)
                    (k < neighbours_[i].inner ? inner : outer) += values_[neighbours_[i].places[k]];
            }
            ratios[l] = inner / (own - outer * ratios[l + 1]);
        }
        Value factor = 1.0L;
        for (std::size_t l = 1; l < layers; ++l)
        {
            factor *= ratios[l];
            for (int i = begins_[l]; i < begins_[l + 1]; ++i)
                values_[i] *= factor;
        }
    }

    double residual() const
    {
        Value greatest = 0.0L;
        for (std::size_t i = 1; i < cells_.size(); ++i)
            greatest = std::max(greatest, std::abs(values_[i] - meanAt(i)) / values_[i]);
        return static_cast<double>(greatest);
    }

    /// Whether all values can still be told from zero.
    bool positive() const
    {
        return std::all_of(values_.begin(), values_.end() - 1,
                           [](Value value)
                           { return value >= std::numeric_limits<Value>::min() && std::isfinite(value); });
    }

    void writePhi(std::vector<double> &phi) const
    {
        for (std::size_t i = 0; i < cells_.size(); ++i)
            phi[cells_[i]] = static_cast<double>(-std::log(values_[i]));
    }

private:
    struct Neighbours
    {
        std::array<int, 2 * D> places;  ///< first those one layer nearer to the goal
        int inner;
    };

    void sortByLayers(const std::vector<int> &steps)
    {
        begins_.assign(*std::max_element(steps.begin(), steps.end()) + 2, 0);
        for (int step : steps)
            if (step >= 0)
                ++begins_[step + 1];
        for (std::size_t l = 1; l < begins_.size(); ++l)
            begins_[l] += begins_[l - 1];
        cells_.resize(begins_.back());
        std::vector<int> next = begins_;
        for (std::size_t cell = 0; cell < steps.size(); ++cell)
            if (steps[cell] >= 0)
                cells_[next[steps[cell]]++] = static_cast<int>(cell);
    }

    Neighbours neighboursOf(const VoxelGrid<D> &grid, const std::vector<int> &places, const std::vector<int> &steps,
                            int cell) const
    {
        Neighbours result;
        result.inner = 0;
        int end = 2 * D;
        const auto index = grid.index(cell);
        for (int axis = 0; axis < D; ++axis)
            for (int sign : {-1, 1})
            {
                auto next = index;
                next[axis] += sign;
                if (!grid.free(next))
                    result.places[--end] = static_cast<int>(cells_.size());
                else if (steps[grid.cell(next)] < steps[cell])
                    result.places[result.inner++] = places[grid.cell(next)];
                else
                    result.places[--end] = places[grid.cell(next)];
            }
        return result;
    }

    Value meanAt(std::size_t i) const
    {
        Value sum = 0.0L;
        for (int place : neighbours_[i].places)
            sum += values_[place];
        return sum * (1.0L / (2 * D));
    }

    std::vector<int> cells_;
    std::vector<int> begins_;  ///< of the layers
    std::vector<Neighbours> neighbours_;
    std::vector<Value> values_;
};
}  // namespace

template <int D>
LaplaceField laplaceBySweeps(const VoxelGrid<D> &grid, const Eigen::Matrix<double, D, 1> &goal,
                             const LaplaceSweepOptions &options)
{
    LaplaceField field;
    const int goalCell = grid.cellAround(goal);
    if (goalCell < 0)
        field.failure = LaplaceFailure::GoalOutside;
    else if (grid.occupied(goalCell))
        field.failure = LaplaceFailure::GoalBlocked;
    if (field.failure != LaplaceFailure::None)
        return field;

    LayeredCells<D> cells(grid, goalCell);
    field.failure = LaplaceFailure::NotConverged;
    while (field.sweeps < options.maxSweeps)
    {
        ++field.sweeps;
        cells.sweepOutwards();
        cells.sweepBack();
        if (!cells.positive())
        {
            field.failure = LaplaceFailure::Underflow;
            break;
        }
        cells.balanceLayers();
        if (field.sweeps % 4 != 0 && field.sweeps != options.maxSweeps)
            continue;  // a look at the residual costs as much as half a sweep
        field.residual = cells.residual();
        if (field.residual <= options.tolerance)
        {
            field.failure = LaplaceFailure::None;
            break;
        }
    }
    field.phi.assign(grid.cells(), std::numeric_limits<double>::infinity());
    cells.writePhi(field.phi);
    return field;
}

template LaplaceField laplaceBySweeps(const VoxelGrid<2> &, const Eigen::Vector2d &, const LaplaceSweepOptions &);
template LaplaceField laplaceBySweeps(const VoxelGrid<3> &, const Eigen::Vector3d &, const LaplaceSweepOptions &);
}  // namespace narrows
