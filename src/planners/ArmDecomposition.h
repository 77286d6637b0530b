// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/geometric/planners/xxl/XXLPositionDecomposition.h>

#include "spaces/PlanarArmStateSpace.h"
#include "spaces/SpatialArmStateSpace.h"

namespace narrows
{
/// A grid over all places that the tip of an arm's last link can reach, for XXL. States of a cell are found by pulling
/// the tip of a perturbed state into it.
/// \tparam Space PlanarArmStateSpace or SpatialArmStateSpace
template <class Space>
class ArmDecomposition : public og::XXLPositionDecomposition
{
public:
    using Point = Eigen::Matrix<double, Space::tipDimension, 1>;  ///< place of the tip

    /// \throws std::invalid_argument if the state space is not a Space.
    explicit ArmDecomposition(const ob::SpaceInformationPtr &si);

    int numLayers() const override { return 1; }  ///< The tip's position is all there is.

    /// Writes a free state of the cell, next to `near` if there is one; false if none is found in a few tries.
    bool sampleFromRegion(int region, ob::State *state, const ob::State *near = nullptr) const override;
    /// The same, whatever the layer.
    bool sampleFromRegion(int region, ob::State *state, const ob::State *near, int layer) const override;

    /// Where the tip is: two or three coordinates, whatever the layer.
    void project(const ob::State *state, std::vector<double> &position, int layer = 0) const override;
    void project(const ob::State *state, std::vector<int> &regions) const override;  ///< The one cell of the tip.

private:
    Point randomPoint(int region) const;

    ob::SpaceInformation *si_;  ///< the planner that owns this keeps it alive
    const Space *space_;
    ob::StateSamplerPtr sampler_;
    mutable ompl::RNG rng_;
};

extern template class ArmDecomposition<PlanarArmStateSpace>;
extern template class ArmDecomposition<SpatialArmStateSpace>;
}  // namespace narrows
