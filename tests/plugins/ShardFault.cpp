// SPDX-License-Identifier: BSD-3-Clause
// A plugin that brings a shard of a Slurm array down when it is loaded, once: shard N if
// $NARROWS_TEST_FAULTS/segfault-N or hang-N is there, which it takes away.
#include <csignal>
#include <cstdlib>
#include <string>

#include <unistd.h>

#include "planners/PlannerPlugin.h"

namespace
{
bool take(const std::string &fault)
{
    const char *const folder = std::getenv("NARROWS_TEST_FAULTS");
    const char *const shard = std::getenv("SLURM_ARRAY_TASK_ID");
    return folder != nullptr && shard != nullptr &&
           unlink((std::string(folder) + "/" + fault + "-" + shard).c_str()) == 0;
}

ompl::base::Planner *makeNothing(const ompl::base::SpaceInformationPtr &)
{
    return nullptr;
}

const NarrowsPluginPlanner planners[] = {{"shard_fault", "makes nothing", makeNothing, false}};
const NarrowsPlugin plugin{NARROWS_PLUGIN_INTERFACE, OMPL_VERSION_VALUE, NARROWS_PLUGIN_ABI, 1, planners};
}  // namespace

const NarrowsPlugin *narrowsPlugin()
{
    if (take("segfault"))
        raise(SIGSEGV);
    if (take("hang"))
        while (true)
            pause();
    return &plugin;
}
