// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "scenario/YamlField.h"

namespace narrows
{
/// A direction in space, `x`, `y`, `z` or a vector that is not zero. \return a unit vector
std::optional<Eigen::Vector3d> readAxis(const Field &field);

/// `{axis: ..., angle: ...}`; the identity if the place is not given.
std::optional<Eigen::Matrix3d> readRotation(const Field &field);

/// From end to end of a cylinder or prism; infinity for `inf`, one without ends.
std::optional<double> readLength(const Field &field);
}  // namespace narrows
