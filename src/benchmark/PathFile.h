// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "scenario/Scenario.h"

namespace narrows
{
/// Reads waypoints from JSON: {"path": {"angles": [[...], ...]}} (a record), {"angles": [[...], ...]} or a bare array.
/// \return configurations, from the scenario's own convention
/// \throws InputError naming the file and what is wrong with it, a row of the wrong dimension included
std::vector<Eigen::VectorXd> readPathFile(const std::string &file, const Scenario &scenario);

/// The same for text that is already in memory; `file` is what error messages call it.
std::vector<Eigen::VectorXd> parsePath(const std::string &text, const std::string &file, const Scenario &scenario);
}  // namespace narrows
