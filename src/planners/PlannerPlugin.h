// SPDX-License-Identifier: BSD-3-Clause
// What a shared library has to offer so that `narrows --plugin` adds its planners to the table. Needs nothing but OMPL.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/config.h>

/// Counts up whenever these declarations change.
#define NARROWS_PLUGIN_INTERFACE 1

extern "C"
{
    struct NarrowsPlugin;

    /// The function that a plugin defines (with default visibility). The table stays valid as long as the library is
    /// loaded.
    const NarrowsPlugin *narrowsPlugin();
}

/// One planner. Its parameters are those that it declares, its name the one by which experiments ask for it.
struct NarrowsPluginPlanner
{
    const char *name;     ///< lower-case letters, digits and underscores, as no other planner is called
    const char *summary;  ///< one line: what it does, whose it is
    /// \return a new planner, for the caller to delete
    ompl::base::Planner *(*make)(const ompl::base::SpaceInformationPtr &si);
    bool threaded;  ///< plans with threads of its own, so that runs cannot be repeated exactly
};

/// What a plugin's entry point returns: what it was built with, then its planners.
struct NarrowsPlugin
{
    int interface;                         ///< NARROWS_PLUGIN_INTERFACE
    int ompl;                              ///< OMPL_VERSION_VALUE
    int abi;                               ///< NARROWS_PLUGIN_ABI
    int count;                             ///< of planners
    const NarrowsPluginPlanner *planners;  ///< `count` of them, valid as long as the library is loaded
};

#if defined(__GXX_ABI_VERSION) && defined(_GLIBCXX_USE_CXX11_ABI)
/// Whose classes and strings the library was compiled with.
#define NARROWS_PLUGIN_ABI (__GXX_ABI_VERSION * 10 + _GLIBCXX_USE_CXX11_ABI)
#else
#define NARROWS_PLUGIN_ABI 0
#endif
