// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "kernel/PlanarModel.h"
#include "kernel/SpatialModel.h"

namespace narrows
{
/// Says whether a whole arm is free of obstacles (and of itself, if its model asks for that): in one configuration, and
/// all along a straight motion. Configurations are the kernel's (planar arms: absolute angles). Joint limits are not
/// its business. Immutable, so that threads may share one.
class ArmChecker
{
public:
    virtual ~ArmChecker() = default;

    virtual bool isFree(ConfigurationRef q) const = 0;

    /// Least distance of any link to what it must not touch: negative or zero iff something touches, +infinity if there
    /// is nothing to touch.
    virtual double clearance(ConfigurationRef q) const = 0;

    /// Is q + t * delta free for all t in [0, 1]? Decided exactly, without a step size: a stretch of the motion is free
    /// when certificates from its middle (kernel/LinkMotion.h) cover it for every link; otherwise it is halved, widest
    /// first. Motions that are found closer than 1e-9 of the arm's reach to an obstacle are refused: they cannot be
    /// told from touching. \pre q is free \param placements grows by the number of configurations that were looked at
    virtual bool isMotionFree(ConfigurationRef q, ConfigurationRef delta, std::uint64_t &placements) const = 0;

    /// Some t, found to 1/256, up to which that motion is certainly free.
    virtual double freeUntil(ConfigurationRef q, ConfigurationRef delta, std::uint64_t &placements) const = 0;
};

/// Makes a checker by its name, "analytic" (closed-form geometry) or "fcl" (Flexible Collision Library).
/// \throws std::invalid_argument for any other name, or for a shape that the checker cannot do.
std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const PlanarModel &model);
std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const SpatialModel &model);
}  // namespace narrows
