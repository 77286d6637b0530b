// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planners/PlannerFactory.h"

namespace narrows
{
/// OMPL's geometric planners, as far as a SpaceInformation is all that they need. Left out are those that need what a
/// planning problem does not have: a task space (TSRRT), a vector field (VFRRT), a data base of past solutions
/// (Lightning, Thunder), a sequence of simpler robots (QRRT).
std::vector<PlannerEntry> omplPlanners();
}  // namespace narrows
