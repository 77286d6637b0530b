// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace narrows
{
/// Adds the planners of a shared library (planners/PlannerPlugin.h) to the factory. It stays loaded until the program
/// ends. What it does when it is loaded is in this process: only its planners' runs are isolated.
/// \throws std::invalid_argument naming the file if it is no such library, was built with another OMPL, interface or
/// C++ library than this program, or offers a planner that there is already or that cannot be called so. Then none of
/// its planners is added.
void loadPlugin(const std::string &path);

struct LoadedPlugin
{
    std::string path;  ///< absolute
    std::string sha256;
};

/// The libraries loaded so far: what runs of their planners depend on.
const std::vector<LoadedPlugin> &loadedPlugins();
}  // namespace narrows
