// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmark/Experiment.h"
#include "benchmark/IniFile.h"

namespace narrows
{
/// Reads the [hypothesis] section of an experiment file: `alpha = 0.05`, `name = statement` begins a hypothesis, and
/// `name.key = value` belongs to it (docs/experiments.md). Names of planners and groups are resolved, so that what is
/// declared depends on no later reading of the file.
/// \param entries the lines of the section
/// \param experiment its scenarios, checkers, motions and planners as they were read
/// \param faults gains what is wrong
Hypotheses readHypothesisSection(const std::vector<IniEntry> &entries, const Experiment &experiment,
                                 std::vector<InputFault> &faults);

/// A hypothesis and its level as one JSON text: the same text for the same meaning.
std::string toJson(const Hypothesis &hypothesis, double alpha);
}  // namespace narrows
