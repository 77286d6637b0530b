// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/fields/PathWindow.h"
#include "kernel/fields/VoxelGrid.h"

namespace narrows
{
/// Why a streamline does not arrive.
enum class StreamlineFailure
{
    None,
    StartOutside,  ///< beyond the grid
    StartBlocked,  ///< in an occupied cell, or in one without a way to the goal
    Stalled,       ///< the field has no slope here
    LeftFreeCells,
    TooLong,  ///< not there after as many steps as asked for
};

/// "stalled" and the like.
std::string toText(StreamlineFailure failure);

/// A way down the field, or as far as it went.
template <int D>
struct Streamline
{
    StreamlineFailure failure = StreamlineFailure::None;  ///< none: it has arrived
    PointPath<D> path;  ///< from the start; the goal is its last point if there is no failure
};

/// Values of v = exp(-phi) between centers, linear along every axis (the paper's Eq. 6), and so their gradient by
/// central differences over one cell. As v may be too small for a double, both are relative to the greatest v around.
template <int D>
class FieldSample
{
public:
    using Point = Eigen::Matrix<double, D, 1>;  ///< in the plane or in space

    /// \param phi of every cell; beyond the grid it is infinite. Both are referred to.
    FieldSample(const VoxelGrid<D> &grid, const std::vector<double> &phi) : grid_(grid), phi_(phi) {}

    /// v(point) exp(reference).
    double value(const Point &point, double reference) const;
    /// Least phi among the centers around a point that count in value() or slope().
    double leastPhi(const Point &point) const;
    /// Where v rises; not normalized, zero where it has no slope.
    Point slope(const Point &point) const;

private:
    double phiAt(const typename VoxelGrid<D>::Index &index) const;

    const VoxelGrid<D> &grid_;
    const std::vector<double> &phi_;
};

/// Follows the slope of v from the start by steps of half a cell until the goal is no more than one and a half cells
/// away (the paper's middle path, Eq. 3 and Fig. 2, in the plane and in space).
/// \param phi LaplaceField::phi for this goal
/// \param maxSteps 0: as many as 4 steps per free cell of the grid
template <int D>
Streamline<D> followField(const VoxelGrid<D> &grid, const std::vector<double> &phi,
                          const Eigen::Matrix<double, D, 1> &start, const Eigen::Matrix<double, D, 1> &goal,
                          int maxSteps = 0);

extern template class FieldSample<2>;
extern template class FieldSample<3>;
extern template Streamline<2> followField(const VoxelGrid<2> &, const std::vector<double> &, const Eigen::Vector2d &,
                                          const Eigen::Vector2d &, int);
extern template Streamline<3> followField(const VoxelGrid<3> &, const std::vector<double> &, const Eigen::Vector3d &,
                                          const Eigen::Vector3d &, int);
}  // namespace narrows
