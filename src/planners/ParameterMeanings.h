// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace narrows
{
/// What a planner's parameter means, in one line, units included; OMPL's parameter sets keep only names and ranges. Our
/// planners' headers say more.
/// \param planner name in the factory \param parameter name in its params()
/// \return empty if nothing is known of it (planners of others)
std::string parameterMeaning(const std::string &planner, const std::string &parameter);
}  // namespace narrows
