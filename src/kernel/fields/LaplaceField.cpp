// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/LaplaceField.h"

#include <Eigen/SparseCholesky>

namespace narrows
{
namespace
{
/// Calls visit(cell) for the free cells beside one.
template <int D, class Visit>
void visitNeighbours(const VoxelGrid<D> &grid, int cell, const Visit &visit)
{
    const auto index = grid.index(cell);
    for (int axis = 0; axis < D; ++axis)
    {
        const int stride = grid.stride(axis);
        if (index[axis] > 0 && !grid.occupied(cell - stride))
            visit(cell - stride);
        if (index[axis] + 1 < grid.counts()[axis] && !grid.occupied(cell + stride))
            visit(cell + stride);
    }
}
}  // namespace

std::string toText(LaplaceFailure failure)
{
    switch (failure)
    {
        case LaplaceFailure::None:
            return "none";
        case LaplaceFailure::GoalOutside:
            return "goal_outside";
        case LaplaceFailure::GoalBlocked:
            return "goal_blocked";
        case LaplaceFailure::TooManyCells:
            return "too_many_cells";
        case LaplaceFailure::NotFactored:
            return "not_factored";
        case LaplaceFailure::Underflow:
            return "underflow";
        case LaplaceFailure::NotConverged:
            return "not_converged";
    }
    return "unknown";
}

template <int D>
std::vector<int> stepsToGoal(const VoxelGrid<D> &grid, int goal)
{
    std::vector<int> steps(grid.cells(), -1);
    std::vector<int> queue{goal};
    steps[goal] = 0;
    for (std::size_t next = 0; next < queue.size(); ++next)
    {
        const int cell = queue[next];
        visitNeighbours(grid, cell,
                        [&](int neighbour)
                        {
                            if (steps[neighbour] >= 0)
                                return;
                            steps[neighbour] = steps[cell] + 1;
                            queue.push_back(neighbour);
                        });
    }
    return steps;
}

template <int D>
LaplaceSystem<D>::LaplaceSystem(const VoxelGrid<D> &grid, int maxFree) : grid_(grid), places_(grid.cells(), -1)
{
    if (grid.freeCells() > maxFree)
    {
        failure_ = LaplaceFailure::TooManyCells;
        return;
    }
    for (int cell = 0; cell < grid.cells(); ++cell)
        if (!grid.occupied(cell))
        {
            places_[cell] = static_cast<int>(cells_.size());
            cells_.push_back(cell);
        }
    if (!cells_.empty())
        factorize();
}

template <int D>
void LaplaceSystem<D>::factorize()
{
    const auto size = static_cast<Eigen::Index>(cells_.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (int cell : cells_)
    {
        entries.emplace_back(places_[cell], places_[cell], 2.0 * D);
        visitNeighbours(grid_, cell,
                        [&](int neighbour)
                        {
                            if (places_[neighbour] < places_[cell])
                                entries.emplace_back(places_[cell], places_[neighbour], -1.0);
                        });
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 0.0))
    {
        failure_ = LaplaceFailure::NotFactored;
        return;
    }
    const auto &lower = solver.matrixL().nestedExpression();
    columns_.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + size + 1);
    rows_.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
    factor_.assign(lower.valuePtr(), lower.valuePtr() + lower.nonZeros());
    const Eigen::VectorXd pivots = solver.vectorD();
    pivots_.assign(pivots.data(), pivots.data() + size);
    for (int cell : cells_)
        places_[cell] = solver.permutationP().indices()[places_[cell]];
}

template <int D>
LaplaceField LaplaceSystem<D>::solve(const Eigen::Matrix<double, D, 1> &goal) const
{
    LaplaceField field;
    field.failure = failure_;
    const int goalCell = grid_.cellAround(goal);
    if (goalCell < 0)
        field.failure = LaplaceFailure::GoalOutside;
    else if (grid_.occupied(goalCell))
        field.failure = LaplaceFailure::GoalBlocked;
    if (field.failure != LaplaceFailure::None)
        return field;

    std::vector<long double> values(cells_.size(), 0.0L);
    values[places_[goalCell]] = 1.0L;
    const int size = static_cast<int>(cells_.size());
    for (int column = places_[goalCell]; column < size; ++column)
        if (values[column] != 0.0L)
            for (int k = columns_[column]; k < columns_[column + 1]; ++k)
                values[rows_[k]] -= static_cast<long double>(factor_[k]) * values[column];
    for (int column = size - 1; column >= 0; --column)
    {
        values[column] /= static_cast<long double>(pivots_[column]);
        for (int k = columns_[column]; k < columns_[column + 1]; ++k)
            values[column] -= static_cast<long double>(factor_[k]) * values[rows_[k]];
    }

    const long double atGoal = std::log(values[places_[goalCell]]);
    const std::vector<int> steps = stepsToGoal(grid_, goalCell);
    field.phi.assign(grid_.cells(), std::numeric_limits<double>::infinity());
    for (int cell : cells_)
    {
        const long double value = values[places_[cell]];
        if (steps[cell] < 0)
            continue;
        if (value < std::numeric_limits<long double>::min())
            field.failure = LaplaceFailure::Underflow;
        else
            field.phi[cell] = static_cast<double>(atGoal - std::log(value));
    }
    return field;
}

template class LaplaceSystem<2>;
template class LaplaceSystem<3>;
template std::vector<int> stepsToGoal(const VoxelGrid<2> &, int);
template std::vector<int> stepsToGoal(const VoxelGrid<3> &, int);
}  // namespace narrows
