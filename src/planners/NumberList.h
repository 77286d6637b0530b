// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Core>

namespace narrows
{
/// Reads "1, 2, 3" as a vector; blank text is the empty vector. The dot is the decimal mark in every locale.
/// \throws std::invalid_argument for anything else than finite numbers with commas between them.
Eigen::VectorXd parseVector(const std::string &text);

/// Reads "1, 2; 3, 4" as a matrix with one row per semicolon-separated list; blank text is the empty matrix.
/// \throws std::invalid_argument as parseVector; also if the rows differ in length.
Eigen::MatrixXd parseMatrix(const std::string &text);

/// The inverse of parseMatrix: the shortest texts that read back as the same numbers.
std::string toText(const Eigen::MatrixXd &matrix);
}  // namespace narrows
