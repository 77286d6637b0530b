// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Cores.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>

#include <sched.h>

namespace narrows
{
namespace
{
CpuList usableCpus()
{
    cpu_set_t set;
    CPU_ZERO(&set);
    CpuList cpus;
    if (sched_getaffinity(0, sizeof(set), &set) == 0)
        for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
            if (CPU_ISSET(cpu, &set))
                cpus.push_back(cpu);
    return cpus;
}

/// All CPUs of the core that a CPU belongs to, as text; itself if that is not told. Kernels before 5.x have the older
/// name only.
std::string coreOf(int cpu, const std::string &root)
{
    for (const char *name : {"core_cpus_list", "thread_siblings_list"})
    {
        std::ifstream file(root + "/cpu" + std::to_string(cpu) + "/topology/" + name);
        std::string line;
        if (std::getline(file, line) && !cpuListFromText(line).empty())
            return line;
    }
    return std::to_string(cpu);
}
}  // namespace

CpuList cpuListFromText(const std::string &text)
{
    constexpr int most = 1 << 16;
    CpuList cpus;
    const char *place = text.data();
    const char *const end = place + text.size();
    while (place != end)
    {
        int first = 0;
        std::from_chars_result read = std::from_chars(place, end, first);
        int last = first;
        if (read.ec == std::errc{} && read.ptr != end && *read.ptr == '-')
            read = std::from_chars(read.ptr + 1, end, last);
        if (read.ec != std::errc{} || first < 0 || last < first || last > most)
            break;
        for (int cpu = first; cpu <= last; ++cpu)
            cpus.push_back(cpu);
        if (read.ptr == end || *read.ptr != ',')
            break;
        place = read.ptr + 1;
    }
    return cpus;
}

std::string toText(const CpuList &cpus)
{
    std::string text;
    for (std::size_t i = 0; i < cpus.size();)
    {
        std::size_t last = i;
        while (last + 1 < cpus.size() && cpus[last + 1] == cpus[last] + 1)
            ++last;
        text += (text.empty() ? "" : ",") + std::to_string(cpus[i]);
        if (last > i)
            text += "-" + std::to_string(cpus[last]);
        i = last + 1;
    }
    return text;
}

std::vector<CpuList> usablePhysicalCores(const std::string &root)
{
    std::map<std::string, CpuList> cores;
    for (const int cpu : usableCpus())
        cores[coreOf(cpu, root)].push_back(cpu);
    std::vector<CpuList> result;
    for (auto &[name, cpus] : cores)
        result.push_back(std::move(cpus));
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<CpuList> sharesOf(const std::vector<CpuList> &cores, std::size_t slots)
{
    std::vector<CpuList> shares(slots);
    if (cores.empty())
        return shares;
    for (std::size_t i = 0; i < std::max(slots, cores.size()); ++i)
    {
        CpuList &share = shares[i % slots];
        const CpuList &core = cores[i % cores.size()];
        share.insert(share.end(), core.begin(), core.end());
    }
    for (CpuList &share : shares)
        std::sort(share.begin(), share.end());
    return shares;
}

bool keepTo(const CpuList &cpus)
{
    if (cpus.empty())
        return true;
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const int cpu : cpus)
        if (cpu < CPU_SETSIZE)
            CPU_SET(cpu, &set);
    return sched_setaffinity(0, sizeof(set), &set) == 0;
}
}  // namespace narrows
