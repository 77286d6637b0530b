// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenario/families/ArmScene.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
/// Draws a scene's start: a bent posture that the withdrawn arm can be bent to straight in joint space and the goal
/// cannot.
/// \tparam Scene ArmScene or SpaceScene
/// \param withdrawn a configuration out of all narrow places
/// \param bend > 0, how far every joint is at most from there, radians or lengths
/// \param leastClearance of the start
/// \return false if this draw will not do; the scene's start is not to be used then
template <class Scene>
bool drawBentStart(Scene &scene, const Eigen::VectorXd &withdrawn, double bend, double leastClearance,
                   RandomNumbers &random)
{
    scene.start = withdrawn;
    for (double &value : scene.start)
        value = rounded(value + random.uniform(-bend, bend), 6);
    return clearance(scene, scene.start) > leastClearance &&
           judgeMotion(scene, scene.start, scene.goal) == Motion::Blocked &&
           judgeMotion(scene, scene.start, withdrawn) == Motion::Free;
}
}  // namespace narrows
