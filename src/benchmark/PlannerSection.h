// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "benchmark/Experiment.h"
#include "benchmark/IniFile.h"

namespace narrows
{
/// Reads the [planner] section of an experiment file: `name =` begins an entry, `name.key = value` belongs to the last
/// entry of that planner. Every entry is tried on the scenarios it is for, so that unknown parameters and spaces that
/// do not fit are found before the first run. \param entries the lines of the section \param space for entries without
/// a space of their own \param scenarios those that could be read
std::vector<PlannerChoice> readPlannerSection(const std::vector<IniEntry> &entries, const std::string &file,
                                              const std::string &space,
                                              const std::vector<std::shared_ptr<const Scenario>> &scenarios,
                                              std::vector<InputFault> &faults);
}  // namespace narrows
