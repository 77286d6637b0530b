// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ArmChecker.h"

#include "validity/LinkwiseChecker.h"
#include "validity/PlanarChecker.h"
#include "validity/SpatialChecker.h"

namespace narrows
{
std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const PlanarModel &model)
{
    return std::make_unique<LinkwiseChecker<PlanarArm>>(model.arm, makeChecker(name, model), model.selfCollision);
}

std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const SpatialModel &model)
{
    return std::make_unique<LinkwiseChecker<SpatialArm>>(model.arm, makeChecker(name, model), model.selfCollision);
}
}  // namespace narrows
