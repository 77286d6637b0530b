// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace narrows
{
/// Nested affine slices of joint space: the slice of dimension k is origin + span of the first k columns of an
/// orthonormal basis. Smooth bends of a chain are where its ways are found first, so that searching a slice of few
/// dimensions that holds start and goal often beats searching all of joint space.
struct AffineSlices
{
    Eigen::VectorXd origin;  ///< the start
    Eigen::MatrixXd basis;   ///< orthonormal columns

    int dimensions() const { return static_cast<int>(basis.cols()); }  ///< of the largest slice
    /// Coordinates of the nearest point of the largest slice.
    Eigen::VectorXd coordinates(const Eigen::VectorXd &q) const { return basis.transpose() * (q - origin); }
    /// \param coordinates of a slice of as many dimensions; no more than dimensions()
    Eigen::VectorXd point(const Eigen::VectorXd &coordinates) const
    {
        return origin + basis.leftCols(coordinates.size()) * coordinates;
    }
};

/// Directions, in columns, that bend a chain of `links` links evenly: cos(pi k (i + 1/2) / links) of link i, k = 0 ...
/// count - 1. Orthogonal; \param offset joints before the first link, which stay where they are
/// \throws std::invalid_argument unless 0 <= count <= links and offset >= 0.
Eigen::MatrixXd cosineModes(int links, int count, int offset = 0);

/// Slices through `start`: first along goal - start, then along `modes` by columns, each made orthogonal to what comes
/// before it; a direction that has less than a hundredth of its length left is dropped. \param most dimensions; >= 1
/// \throws std::invalid_argument if sizes disagree.
AffineSlices affineSlices(const Eigen::VectorXd &start, const Eigen::VectorXd &goal, const Eigen::MatrixXd &modes,
                          int most);
}  // namespace narrows
