// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "benchmark/IniFile.h"

namespace narrows
{
/// One parameter of a family and the values it takes in turn.
struct SweepAxis
{
    std::string scenario;  ///< name of the only file it is for; empty: all that have no axis of their own
    std::string parameter;
    std::vector<std::string> values;
    int line = 0;
};

/// Reads `generate.half_width = 0.1, 0.01` and `maze.generate.seed = 1..20, 40` of the [sweep] section.
/// \param mostScenes that one scenario file may make
/// \param faults gains what is wrong; entries with faults make no axis
std::vector<SweepAxis> readSweepSection(const std::vector<IniEntry> &entries, const std::string &file, int mostScenes,
                                        std::vector<InputFault> &faults);

/// The axes of one scenario file: its own ones or, if it has none, those of all files.
std::vector<SweepAxis> axesOf(const std::string &scenario, const std::vector<SweepAxis> &axes);

/// The cross product, the last axis fastest; one empty combination if there are no axes.
std::vector<GenerateSettings> combinations(const std::vector<SweepAxis> &axes);
}  // namespace narrows
