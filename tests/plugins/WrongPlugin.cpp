// SPDX-License-Identifier: BSD-3-Clause
// A plugin with one thing wrong, chosen when it is compiled.
#include "planners/PlannerPlugin.h"

namespace
{
ompl::base::Planner *makeNothing(const ompl::base::SpaceInformationPtr &)
{
    return nullptr;
}

#if defined(WRONG_NAME)
constexpr const char *name = "Not A Name";
#elif defined(WRONG_TWIN)
constexpr const char *name = "rrtconnect";
#else
constexpr const char *name = "nothing";
#endif

#if defined(WRONG_INTERFACE)
constexpr int interfaceNumber = NARROWS_PLUGIN_INTERFACE + 1;
#else
constexpr int interfaceNumber = NARROWS_PLUGIN_INTERFACE;
#endif

#if defined(WRONG_OMPL)
constexpr int omplNumber = 1004002;
#else
constexpr int omplNumber = OMPL_VERSION_VALUE;
#endif

#if defined(WRONG_ABI)
constexpr int abi = NARROWS_PLUGIN_ABI + 1;
#else
constexpr int abi = NARROWS_PLUGIN_ABI;
#endif

const NarrowsPluginPlanner planners[] = {{name, "does nothing", makeNothing, false}};
const NarrowsPlugin plugin{interfaceNumber, omplNumber, abi, 1, planners};
}  // namespace

#if !defined(WRONG_FUNCTION)
const NarrowsPlugin *narrowsPlugin()
{
    return &plugin;
}
#else
const NarrowsPlugin *anotherName()
{
    return &plugin;
}
#endif
