// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/PlanarWorldReader.h"

#include "scenario/ConfinementReader.h"
#include "scenario/MethodsReader.h"
#include "scenario/ObstacleReader.h"
#include "scenario/RobotReader.h"
#include "scenario/TaskCheck.h"
#include "scenario/TaskReader.h"

namespace narrows
{
void readPlanarWorld(const Mapping &root, Scenario &scenario)
{
    const RobotDraft robot = readRobot(root.required("robot"));
    const ObstaclesDraft obstacles = readObstacles(root.required("obstacles"));
    const Field start = root.required("start");
    const Field goal = root.required("goal");
    const std::optional<PlanarTask> task = readTask(start, goal, robot);
    scenario.methods = readMethods(root.optional("methods"), obstacles.names, robot.arm ? robot.arm->dimension() : 0);
    PlanarWorld world;
    world.convention = robot.convention;
    if (task && obstacles.obstacles.size() == obstacles.names.size())
    {
        world.task = *task;
        world.model =
            std::make_shared<const PlanarModel>(PlanarModel{*robot.arm, obstacles.obstacles, robot.selfCollision});
        checkTaskIsFree(start, goal, *world.model, *task);
        scenario.infeasible = readConfinement(root.optional("infeasible"), world);
    }
    scenario.world = std::move(world);
}
}  // namespace narrows
