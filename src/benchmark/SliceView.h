// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "scenario/Problem.h"

namespace narrows
{
/// What there is to see in the slice of joint space in which HPPM followed a curve.
struct SliceView
{
    bool joins = false;       ///< does the slice's free part join start and goal (SliceOracle, or the curve itself)?
    double bottleneck = 0.0;  ///< clearance of the widest way that was found; 0 without a way
    double spacing = 0.0;     ///< gaps narrower than this may have been overlooked, in the slice's unit (radians)
    std::string status;       ///< how the curve ended (TraceStatus)
    std::string json;         ///< all of it, for analysis/draw_slice.py and the report's page

    /// Whose failure it is that the curve did not reach the goal: "slice", "curve", or nothing if it did.
    std::string failure() const { return status == "reached_goal" ? "" : joins ? "curve" : "slice"; }
};

/// \param recipe parameters of hppm with search = paper: Record::recipe
/// \throws std::invalid_argument if the scenario's goal is no configuration, or the recipe is not one of a slice
SliceView viewSlice(const Scenario &scenario, const ProblemOptions &options,
                    const std::map<std::string, std::string> &recipe);

/// Draws it, or writes its data if the file's name ends in .json.
/// \throws std::runtime_error as drawRecord, or if the file cannot be written
void drawSlice(const SliceView &view, const std::string &outputFile);
}  // namespace narrows
