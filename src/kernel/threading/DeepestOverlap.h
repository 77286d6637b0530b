// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/PlanarPoles.h"

namespace narrows
{
/// Where an arm overlaps obstacles most, and how it gets out: far cheaper than to certify a motion. Knows nothing of
/// the arm's collisions with itself. Keeps its memory from one call to the next.
class DeepestOverlap
{
public:
    explicit DeepestOverlap(const PlanarModel &model);

    /// The obstacle function of the link and the obstacle that overlap most, negative; 0 if none do. `gradient` is its
    /// derivative by the configuration.
    double deepest(ConfigurationRef q, Eigen::VectorXd &gradient);

private:
    PlanarPoles poles_;
    std::vector<Bounds> boxes_;
    std::vector<Eigen::Vector2d> points_, carried_;
    std::vector<Segment> links_;
    std::vector<LinkForce> forces_;
};
}  // namespace narrows
