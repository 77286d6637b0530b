// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/SpatialWorldReader.h"

#include "scenario/MeshFiles.h"
#include "scenario/MethodsReader.h"
#include "scenario/SpatialObstacleReader.h"
#include "scenario/SpatialRobotReader.h"
#include "scenario/SpatialTaskCheck.h"
#include "scenario/SpatialTaskReader.h"
#include "scenario/YamlDocument.h"

namespace narrows
{
namespace
{
/// The text with the meshes it names, if the two are one document: not if the text is one mapping in braces.
void keepMeshes(const Mapping &root, const MeshFiles &meshes, Scenario &scenario)
{
    const std::string appendix = meshes.appendix();
    if (appendix.empty())
        return;
    const std::string whole = scenario.text + "\n" + appendix;
    try
    {
        if (parseYaml(whole, scenario.name)["files"])
            scenario.text = whole;
    }
    catch (const InputError &)
    {
        root.field().fault(
            "a file that names a mesh must not be a mapping in braces: the mesh is kept with its text, under `files`");
    }
}
}  // namespace

void readSpatialWorld(const Mapping &root, const std::string &file, Scenario &scenario)
{
    const SpatialRobotDraft robot = readSpatialRobot(root.required("robot"));
    MeshFiles meshes(root.optional("files"), file);
    const SpatialObstaclesDraft obstacles = readSpatialObstacles(root.required("obstacles"), meshes);
    meshes.refuseOthers();
    const Field start = root.required("start");
    const Field goal = root.required("goal");
    const std::optional<SpatialTask> task = readSpatialTask(start, goal, robot);
    scenario.methods = readMethods(root.optional("methods"), obstacles.names, robot.arm ? robot.arm->dimension() : 0);
    SpatialWorld world;
    if (task && obstacles.obstacles.size() == obstacles.names.size())
    {
        world.task = *task;
        world.model =
            std::make_shared<const SpatialModel>(SpatialModel{*robot.arm, obstacles.obstacles, robot.selfCollision});
        checkTaskIsFree(start, goal, *world.model, *task, robot.numbers);
    }
    keepMeshes(root, meshes, scenario);
    scenario.world = std::move(world);
}
}  // namespace narrows
