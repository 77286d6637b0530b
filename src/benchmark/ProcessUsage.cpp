// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/ProcessUsage.h"

#include <fstream>
#include <string>

#include <time.h>
#include <unistd.h>

namespace narrows
{
namespace
{
/// A line "key:   123 kB" of /proc/self/status.
std::optional<double> statusKb(const std::string &key)
{
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word)
    {
        double value = 0.0;
        if (word == key && status >> value)
            return value;
        std::getline(status, word);
    }
    return std::nullopt;
}
}  // namespace

double processCpuSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::optional<double> residentKb()
{
    return statusKb("VmRSS:");
}

std::optional<double> peakResidentKb()
{
    return statusKb("VmHWM:");
}

void resetPeakResident()
{
    std::ofstream("/proc/self/clear_refs") << "5";
}

unsigned long addressSpaceBytes()
{
    unsigned long pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<unsigned long>(sysconf(_SC_PAGESIZE));
}
}  // namespace narrows
