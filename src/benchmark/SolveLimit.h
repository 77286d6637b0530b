// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/PlannerTerminationCondition.h>

#include "spaces/Ompl.h"

namespace narrows
{
/// For solve(): holds once this process has used that much CPU time since the call, all threads together, so that a
/// busy machine takes nothing from a planner; at the latest after the wall time of wallLimit(). Polled in line.
/// \param seconds positive
ob::PlannerTerminationCondition solveLimit(double seconds);

/// Wall seconds after which a run ends that has not had its CPU time by then: the machine is too busy, or the planner
/// waits instead of planning.
double wallLimit(double seconds);
}  // namespace narrows
