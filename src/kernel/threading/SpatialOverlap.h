// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/SpatialBounds.h"
#include "kernel/SpatialPoles.h"
#include "kernel/threading/Overlap.h"

namespace narrows
{
/// Overlap of an arm in space with obstacles and, if the model minds, of links with each other: the clearance where it
/// is least. Keeps its memory from one call to the next.
class SpatialOverlap : public Overlap
{
public:
    /// Refers to nothing: obstacles and arm are copied.
    explicit SpatialOverlap(const SpatialModel &model);

    double deepest(const Eigen::Ref<const Eigen::VectorXd> &q, Eigen::VectorXd &gradient) override;

private:
    /// Forces of what overlaps more than `depth`, which becomes that.
    void lookAtObstacles(std::size_t link, double &depth);
    void lookAtPairs(double &depth);

    SpatialPoles poles_;
    std::vector<SpatialBounds> boxes_;
    SpatialArm::Placement placement_;
    std::vector<EndForces> forces_;
};
}  // namespace narrows
