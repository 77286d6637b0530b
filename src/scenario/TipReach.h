// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "scenario/YamlField.h"

namespace narrows
{
/// A goal for the tip of a chain of links, as far as lengths go. In the plane, z is 0.
struct TipReach
{
    std::vector<double> lengths;  ///< of the links from the base to the tip
    Eigen::Vector3d baseFrom;     ///< the base can be anywhere between two points
    Eigen::Vector3d baseTo;
    Eigen::Vector3d point;
    double tolerance;
    int number;  ///< of the tip's link, as the file counts
};

/// Reports a goal that is too far from the base, or too near to it, whatever obstacles and limits are.
void checkReach(const Field &field, const TipReach &goal);
}  // namespace narrows
