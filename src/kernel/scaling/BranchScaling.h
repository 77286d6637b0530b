// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/scaling/PathScaling.h"
#include "kernel/scaling/PlainScaling.h"
#include "kernel/scaling/PoseRules.h"

namespace narrows
{
/// Step 5 with every choice among the candidates on the auxiliary lines, tracked along the path: the choices whose
/// joints move least in all, no joint by more than `maxJump` at once. What no choice can do this says for sure, up to
/// `mostChains` chains per tip.
class BranchScaling
{
public:
    static constexpr std::size_t mostChains = 4096;  ///< that are kept per tip

    /// Refers to both, which must outlive it.
    BranchScaling(const ScalingProblem &problem, const ScalingOptions &options);

    /// A pose for every tip, up to the first that cannot be had.
    ScalingResult run(const std::vector<Eigen::Vector3d> &tips);

private:
    /// All chains of one tip that can be reached from those of the tip before.
    struct Layer
    {
        std::vector<SectionChain> chains;
        std::vector<std::size_t> parents;
        std::vector<double> costs;
    };

    void extend(std::size_t joint);
    void place(std::size_t joint, const Eigen::Vector2d &point);
    void fail(ScalingFailure failure, std::size_t link, int section = -1);
    bool connect(Layer &layer);
    void append(std::size_t tipCount, const std::vector<Eigen::Vector3d> &tips, ScalingResult &result) const;

    const ScalingProblem &problem_;
    const ScalingOptions &options_;
    PoseRules rules_;
    AuxiliaryLines lines_;
    std::vector<double> fractions_;
    std::vector<Layer> layers_;

    SectionChain chain_;                    ///< being built, from the tip inward
    std::vector<Eigen::Vector3d> centres_;  ///< of it
    std::vector<SectionChain> found_;
    ScalingFault fault_;  ///< of the chain that came nearest to the base
};
}  // namespace narrows
