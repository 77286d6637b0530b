// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "kernel/PlanarPoles.h"
#include "kernel/Repulsion.h"

namespace narrows
{
/// The continuous poles of a planar arm: W = sum of P / C over all links and obstacles, joint limits and pairs of
/// links. C and the order of the poles: PlanarRepulsionModel.h.
class DistanceRepulsion : public Repulsion
{
public:
    /// \param strengths P per group of `poles`; 0 leaves the group out
    /// \throws std::invalid_argument for a wrong count or a strength that is not finite.
    DistanceRepulsion(std::shared_ptr<const PlanarPoles> poles, const std::vector<double> &strengths);

    int dimension() const override { return poles_->arm().dimension(); }
    /// W and its derivative, and the poles.
    void evaluate(ConfigurationRef q, Sample &sample) const override;
    /// W alone.
    double value(ConfigurationRef q) const override;

private:
    struct Workspace;
    struct Circles
    {
        CircleObstacle shape;
        double strength;
        std::size_t offset;  ///< of its first link among the poles
    };
    struct Shapes
    {
        const LinkObstacle *shape;
        double strength;
        std::size_t offset;
    };

    void addObstacles(Workspace &work, Sample &sample) const;
    void addPairs(Workspace &work, Sample &sample) const;
    void addLimits(ConfigurationRef q, Sample &sample) const;

    std::shared_ptr<const PlanarPoles> poles_;
    std::vector<Circles> circles_;  ///< by kind, so that the loop over them stays tight
    std::vector<Shapes> shapes_;
    double limitStrength_ = 0.0;
    double pairStrength_ = 0.0;
    std::size_t limitOffset_, pairOffset_, poleCount_;
};
}  // namespace narrows
