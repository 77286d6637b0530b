// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "spaces/ArmStateSpace.h"

namespace narrows
{
/// The motion q + t * delta, t in [0, 1], between two states as the kernel counts it.
struct StraightMotion
{
    Eigen::VectorXd q, delta;
};

/// In memory that each thread keeps until the next call.
const StraightMotion &straightMotion(const ArmStateSpace &space, const ob::State *from, const ob::State *to);
}  // namespace narrows
