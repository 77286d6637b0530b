// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/ProjectionEvaluator.h>

#include "spaces/Ompl.h"

namespace narrows
{
/// Where the tip of the last link is: what the arm is for, and few numbers however many joints there are.
/// \tparam Space a joint space with arm(), tip() and lastLink()
template <typename Space>
class TipProjection : public ob::ProjectionEvaluator
{
public:
    /// \param space outlives this \param cells along the arm's reach
    TipProjection(const Space *space, int cells) : ob::ProjectionEvaluator(space), space_(space), cells_(cells) {}

    unsigned int getDimension() const override { return Space::tipDimension; }  ///< two or three

    /// Squares or cubes: the reach over the number of cells along it.
    void defaultCellSizes() override { cellSizes_.assign(Space::tipDimension, space_->arm().reach() / cells_); }

    /// The tip's place: two or three coordinates.
    void project(const ob::State *state, Eigen::Ref<Eigen::VectorXd> projection) const override
    {
        projection = space_->tip(state, space_->lastLink());
    }

private:
    const Space *space_;
    int cells_;
};
}  // namespace narrows
