// SPDX-License-Identifier: BSD-3-Clause
#include "validity/StraightMotion.h"

namespace narrows
{
const StraightMotion &straightMotion(const ArmStateSpace &space, const ob::State *from, const ob::State *to)
{
    thread_local StraightMotion motion;
    space.toConfiguration(from, motion.q);
    space.displacement(from, to, motion.delta);
    return motion;
}
}  // namespace narrows
