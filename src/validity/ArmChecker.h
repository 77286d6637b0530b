// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "kernel/PlanarModel.h"
#include "kernel/SpatialModel.h"

namespace narrows
{
/// Several configurations, one a row: all values of a joint lie side by side, as vector instructions like them.
using ConfigurationRows = const Eigen::Ref<const Eigen::MatrixXd> &;

/// Says whether a whole arm is free of obstacles (and of itself, if its model asks for that): in one configuration, and
/// all along a straight motion. Configurations are the kernel's (planar arms: absolute angles). Joint limits are not
/// its business. Immutable, so that threads may share one.
class ArmChecker
{
public:
    virtual ~ArmChecker() = default;

    virtual bool isFree(ConfigurationRef q) const = 0;  ///< Does nothing touch what it must not touch?

    /// Least distance of any link to what it must not touch: negative or zero iff something touches, +infinity if there
    /// is nothing to touch.
    virtual double clearance(ConfigurationRef q) const = 0;

    /// Is q + t * delta free for all t in [0, 1]? Decided exactly, without a step size: a stretch of the motion is free
    /// when certificates from its middle (kernel/LinkMotion.h) cover it for every link; otherwise it is halved, widest
    /// first. Motions that are found closer than 1e-9 of the arm's reach to an obstacle are refused: they cannot be
    /// told from touching.
    /// \pre q is free
    /// \param q, delta as in isFree(), and a difference of two such
    /// \param placements grows by the number of configurations that were looked at
    virtual bool isMotionFree(ConfigurationRef q, ConfigurationRef delta, std::uint64_t &placements) const = 0;

    /// Some t, found to 1/256, up to which that motion is certainly free.
    virtual double freeUntil(ConfigurationRef q, ConfigurationRef delta, std::uint64_t &placements) const = 0;

    /// isFree() of many: free[k] becomes 1 or 0 for row k. Much faster where the checker can look at sixteen side by
    /// side (analytic, planar arms, a processor with AVX-512), else one by one.
    virtual void areFree(ConfigurationRows configurations, std::vector<char> &free) const;
};

///@{
/// Makes a checker by its name, "analytic" (closed-form geometry) or "fcl" (Flexible Collision Library).
/// \throws std::invalid_argument for any other name, or for a shape that the checker cannot do.
std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const PlanarModel &model);
std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const SpatialModel &model);
///@}
}  // namespace narrows
