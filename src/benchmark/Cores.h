// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace narrows
{
/// Numbers of CPUs, as the system counts them, sorted.
using CpuList = std::vector<int>;

/// "0-3,8" as numbers; what is not of that form ends the list.
CpuList cpuListFromText(const std::string &text);
/// The inverse: "0-3,8".
std::string toText(const CpuList &cpus);

/// The physical cores that this process may use, each with those of its CPUs (hardware threads) that it may use,
/// sorted. A CPU whose core the system does not tell counts as a core of its own. \param root where the system
/// describes its CPUs
std::vector<CpuList> usablePhysicalCores(const std::string &root = "/sys/devices/system/cpu");

/// How runs at a time share the machine: the CPUs for each of `slots` runs, whole cores only and as evenly as possible.
/// No two slots have a core in common unless there are more slots than cores; then cores are dealt out in turn.
std::vector<CpuList> sharesOf(const std::vector<CpuList> &cores, std::size_t slots);

/// Keeps this process, and those that it starts, to these CPUs; none: to no others than before.
/// \return false if the system refuses
bool keepTo(const CpuList &cpus);
}  // namespace narrows
