// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "scenario/YamlField.h"

namespace narrows
{
/// Reports a configuration in which links touch obstacles or, if the model asks for that, each other, all by name.
/// \param numbers what the file counts each of the arm's links as
/// \tparam Model PlanarModel or SpatialModel
template <class Model>
void checkStateIsFree(const Field &field, const Model &model, const std::vector<int> &numbers,
                      const Eigen::VectorXd &q);
}  // namespace narrows
