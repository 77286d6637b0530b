// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/fields/VoxelGrid.h"

namespace narrows
{
/// Why there is no field.
enum class LaplaceFailure
{
    None,
    GoalOutside,   ///< beyond the grid
    GoalBlocked,   ///< in an occupied cell
    TooManyCells,  ///< more free cells than allowed
    NotFactored,   ///< the factorization broke down
    Underflow,     ///< the value of some cell connected with the goal is too small for a long double
    NotConverged,  ///< the sweeps ended before the residual was small enough
};

/// "not_converged" and the like.
std::string toText(LaplaceFailure failure);

/// The paper's potential (Minnetoglu and Conkur 2022, Eq. 1 to 5) in the form v = 1 - u: v = 1 in the goal's cell, 0 in
/// occupied cells and all around the grid, in every other cell the mean over its 4 or 6 neighbours. Held as
/// phi = -ln v: v itself falls by e^(-pi) per width of a planar corridor, u is 1 to the last digit after a dozen.
struct LaplaceField
{
    LaplaceFailure failure = LaplaceFailure::None;  ///< none: the field is whole
    /// Of every cell: 0 at the goal, infinity in occupied cells and in those without a way to the goal.
    std::vector<double> phi;
    /// Greatest |v - mean| / v over the cells connected with the goal, as the solver saw it; 0 from a factorization,
    /// which does not look.
    double residual = 0.0;
    int sweeps = 0;  ///< of laplaceBySweeps()
};

/// The equations of all free cells, factored once, for any number of goals. Immutable.
///
/// Every goal is a unit source: the field is the source's response, divided by its value at the goal. The factor of a
/// symmetric M-matrix has no positive entries off its diagonal, so that nothing cancels in the two triangular solves
/// and even the smallest value has all its relative accuracy; they are done in long double for its range of exponents.
template <int D>
class LaplaceSystem
{
public:
    /// \param maxFree most free cells: time and memory of the factor grow faster than the cells do
    explicit LaplaceSystem(const VoxelGrid<D> &grid, int maxFree = 200'000);

    /// TooManyCells or NotFactored, or None.
    LaplaceFailure failure() const { return failure_; }

    /// Entries of the factor off its diagonal.
    std::size_t factorSize() const { return rows_.size(); }

    /// For any point; where it lies may be the failure.
    LaplaceField solve(const Eigen::Matrix<double, D, 1> &goal) const;

private:
    void factorize();

    VoxelGrid<D> grid_;
    LaplaceFailure failure_ = LaplaceFailure::None;
    std::vector<int> cells_;    ///< the free ones
    std::vector<int> places_;   ///< of every cell: where it comes in the elimination, -1 if occupied
    std::vector<int> columns_;  ///< where each column of the unit lower factor begins
    std::vector<int> rows_;
    std::vector<double> factor_;
    std::vector<double> pivots_;
};

/// Of every cell: how many steps through free cells from the goal's; -1 where there is no way.
/// \pre the goal is a free cell
template <int D>
std::vector<int> stepsToGoal(const VoxelGrid<D> &grid, int goal);

extern template class LaplaceSystem<2>;
extern template class LaplaceSystem<3>;
extern template std::vector<int> stepsToGoal(const VoxelGrid<2> &, int);
extern template std::vector<int> stepsToGoal(const VoxelGrid<3> &, int);
}  // namespace narrows
