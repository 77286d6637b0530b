// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Plugins.h"

#include <algorithm>
#include <filesystem>
#include <list>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/dll/shared_library.hpp>

#include "benchmark/Sha256.h"
#include "planners/PlannerFactory.h"
#include "planners/PlannerPlugin.h"
#include "scenario/InputText.h"

namespace narrows
{
namespace
{
constexpr const char *function = "narrowsPlugin";

[[noreturn]] void refuse(const std::string &path, const std::string &reason)
{
    throw std::invalid_argument(path + ": " + reason);
}

/// "1.5.2" of OMPL_VERSION_VALUE.
std::string versionText(int value)
{
    return fmt::format("{}.{}.{}", value / 1000000, value / 1000 % 1000, value % 1000);
}

boost::dll::shared_library open(const std::string &path)
{
    if (!std::filesystem::is_regular_file(path))
        refuse(path, "there is no such plugin");
    try
    {
        return boost::dll::shared_library(std::filesystem::absolute(path).string(), boost::dll::load_mode::rtld_now);
    }
    catch (const std::exception &error)
    {
        refuse(path, fmt::format("cannot be loaded: {}", error.what()));
    }
}

const NarrowsPlugin &tableOf(const std::string &path, const boost::dll::shared_library &library)
{
    if (!library.has(function))
        refuse(path, fmt::format("is no plugin: it has no function {}()", function));
    const NarrowsPlugin *table = library.get<const NarrowsPlugin *()>(function)();
    if (table == nullptr)
        refuse(path, "is no plugin: it gives no table");
    if (table->interface != NARROWS_PLUGIN_INTERFACE)
        refuse(path, fmt::format("was built for interface {} of plugins; this program has {}", table->interface,
                                 NARROWS_PLUGIN_INTERFACE));
    if (table->ompl != OMPL_VERSION_VALUE)
        refuse(path, fmt::format("was built with OMPL {}, this program with OMPL {}", versionText(table->ompl),
                                 versionText(OMPL_VERSION_VALUE)));
    if (table->abi != NARROWS_PLUGIN_ABI)
        refuse(path, fmt::format("was built with another C++ ABI ({}) than this program ({})", table->abi,
                                 NARROWS_PLUGIN_ABI));
    return *table;
}

bool isName(const std::string &text)
{
    return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

PlannerEntry entryOf(const std::string &path, const NarrowsPluginPlanner &planner)
{
    if (planner.name == nullptr || !isName(planner.name))
        refuse(path, "offers a planner whose name is not of lower-case letters, digits and underscores");
    if (planner.make == nullptr)
        refuse(path, fmt::format("offers {} but no function that makes one", planner.name));
    PlannerEntry entry;
    entry.name = planner.name;
    entry.summary = fmt::format("{} (plugin {})", planner.summary == nullptr ? "" : planner.summary,
                                std::filesystem::path(path).filename().string());
    entry.threaded = planner.threaded;
    entry.make = [make = planner.make, name = entry.name](const PlannerContext &context)
    {
        ob::PlannerPtr made(make(context.si));
        if (made == nullptr)
            throw std::runtime_error("the plugin makes no " + name);
        return made;
    };
    return entry;
}

std::vector<PlannerEntry> entriesOf(const std::string &path, const NarrowsPlugin &table)
{
    if (table.count < 1 || table.planners == nullptr)
        refuse(path, "offers no planner");
    std::set<std::string> names;
    for (const PlannerEntry &entry : planners())
        names.insert(entry.name);
    std::vector<PlannerEntry> entries;
    for (int i = 0; i < table.count; ++i)
    {
        entries.push_back(entryOf(path, table.planners[i]));
        if (!names.insert(entries.back().name).second)
            refuse(path, fmt::format("offers a planner {}, which there is already", entries.back().name));
    }
    return entries;
}

std::vector<LoadedPlugin> &loaded()
{
    static std::vector<LoadedPlugin> all;
    return all;
}
}  // namespace

void loadPlugin(const std::string &path)
{
    static std::list<boost::dll::shared_library> libraries;
    boost::dll::shared_library library = open(path);
    for (PlannerEntry &entry : entriesOf(path, tableOf(path, library)))
        registerPlanner(std::move(entry));
    libraries.push_back(std::move(library));
    loaded().push_back({std::filesystem::absolute(path).string(), sha256(readInputText(path))});
}

const std::vector<LoadedPlugin> &loadedPlugins()
{
    return loaded();
}
}  // namespace narrows
