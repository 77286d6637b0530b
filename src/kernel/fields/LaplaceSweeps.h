// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/fields/LaplaceField.h"

namespace narrows
{
/// When the sweeps end.
struct LaplaceSweepOptions
{
    double tolerance = 1e-3;  ///< > 0, for LaplaceField::residual
    int maxSweeps = 1000;     ///< >= 1, a sweep away from the goal and one back count as one
};

/// The same field for grids that are too large to factor, by two levels that keep every value positive.
///
/// The fine level is Gauss-Seidel's iteration through the layers of cells with equal numbers of steps from the goal,
/// outwards and back. The coarse level has one unknown per layer: the factors on the layers' values with which the sums
/// of the equations over every layer hold, a tridiagonal system whose solution is positive. It carries along a duct in
/// one go what sweeps alone take as many of as the duct is long, in proportion: residuals are relative, so that far
/// from the goal, where values are tiny, they count as much as near it.
///
/// If it has not converged, `phi` holds what there is, and `residual` says how good that is.
template <int D>
LaplaceField laplaceBySweeps(const VoxelGrid<D> &grid, const Eigen::Matrix<double, D, 1> &goal,
                             const LaplaceSweepOptions &options = {});

extern template LaplaceField laplaceBySweeps(const VoxelGrid<2> &, const Eigen::Vector2d &,
                                             const LaplaceSweepOptions &);
extern template LaplaceField laplaceBySweeps(const VoxelGrid<3> &, const Eigen::Vector3d &,
                                             const LaplaceSweepOptions &);
}  // namespace narrows
