// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "kernel/Repulsion.h"
#include "kernel/SpatialPoles.h"

namespace narrows
{
/// The continuous poles of a spatial arm: W = sum of P / C over all links and obstacles, limits and pairs of links. C
/// and the order of the poles: SpatialRepulsionModel.h.
class SpatialRepulsion : public Repulsion
{
public:
    /// \param strengths P per group of `poles`; 0 leaves the group out
    /// \throws std::invalid_argument for a wrong count or a strength that is not finite.
    SpatialRepulsion(std::shared_ptr<const SpatialPoles> poles, const std::vector<double> &strengths);

    int dimension() const override { return poles_->arm().dimension(); }
    void evaluate(const Eigen::Ref<const Eigen::VectorXd> &q, Sample &sample) const override;
    double value(const Eigen::Ref<const Eigen::VectorXd> &q) const override;

private:
    struct Workspace;
    struct Source
    {
        const SpatialPole *pole;
        double strength;
    };

    void addObstacles(Workspace &work, Sample &sample) const;
    void addLimits(const Eigen::Ref<const Eigen::VectorXd> &q, Sample &sample) const;
    void addPairs(Workspace &work, Sample &sample) const;

    std::shared_ptr<const SpatialPoles> poles_;
    std::vector<Source> sources_;
    double limitStrength_ = 0.0;
    double pairStrength_ = 0.0;
};
}  // namespace narrows
