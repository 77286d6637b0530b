// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scenario/YamlField.h"

namespace narrows
{
/// Reads `methods`, see Scenario::methods.
/// \param obstacles names of all obstacles, in order
/// \param dimension of a configuration; 0 if it is not known, which leaves the lengths of rows unchecked
std::map<std::string, std::map<std::string, std::string>> readMethods(const Field &field,
                                                                      const std::vector<std::string> &obstacles,
                                                                      int dimension);
}  // namespace narrows
