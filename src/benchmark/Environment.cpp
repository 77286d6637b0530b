// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Environment.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <SQLiteCpp/Database.h>
#include <ompl/config.h>
#include <sched.h>
#include <sys/utsname.h>
#include <Eigen/Core>
#include <boost/version.hpp>

#include "benchmark/BuildInfo.h"
#include "benchmark/Commit.h"
#include "benchmark/Plugins.h"
#include "benchmark/Text.h"

namespace narrows
{
namespace
{
/// What follows the colon of a line of /proc/cpuinfo; empty where there is no such line.
std::string cpuModel()
{
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.rfind("model name", 0) == 0)
            return trimmed(line.substr(line.find(':') + 1));
    return "unknown";
}

std::string firstLine(const std::string &path)
{
    std::ifstream stream(path);
    std::string line;
    std::getline(stream, line);
    return line.empty() ? "unknown" : line;
}

/// Cores that this process may use: fewer than there are if it is pinned.
int usableCores()
{
    cpu_set_t cores;
    CPU_ZERO(&cores);
    return sched_getaffinity(0, sizeof(cores), &cores) == 0 ? CPU_COUNT(&cores) : 0;
}

/// "libx.so 0123..." with the SHA-256, of all.
std::string pluginNames()
{
    std::vector<std::string> names;
    for (const LoadedPlugin &plugin : loadedPlugins())
        names.push_back(std::filesystem::path(plugin.path).filename().string() + " " + plugin.sha256);
    return joined(names, "; ");
}

std::string dotted(int major, int minor, int patch)
{
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}
}  // namespace

std::string omplVersion()
{
    return "OMPL " + dotted(OMPL_MAJOR_VERSION, OMPL_MINOR_VERSION, OMPL_PATCH_VERSION);
}

Environment captureEnvironment(int jobs)
{
    utsname system{};
    uname(&system);
    const std::string cores = std::to_string(std::thread::hardware_concurrency());

    Environment environment;
    environment.hostname = system.nodename;
    environment.cpu = cpuModel() + ", " + cores + " cores";
    environment.facts = {{"narrows", build::version},
                         {"git_commit", build::commit},
                         {"git_dirty", build::dirty ? "1" : "0"},
                         {"compiler", build::compiler},
                         {"flags", build::flags},
                         {"cpu", cpuModel()},
                         {"cores", cores},
                         {"usable_cores", std::to_string(usableCores())},
                         {"jobs", std::to_string(jobs)},
                         {"load_average", firstLine("/proc/loadavg")},
                         {"governor", firstLine("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")},
                         {"kernel", std::string(system.sysname) + " " + system.release},
                         {"ompl", omplVersion().substr(5)},
                         {"fcl", build::fcl},
                         {"cgal", build::cgal},
                         {"eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
                         {"boost", dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
                         {"sqlite", SQLite::getLibVersion()},
                         {"plugins", pluginNames()}};
    return environment;
}
}  // namespace narrows
