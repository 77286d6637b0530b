// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Orphans.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <string>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace narrows
{
namespace
{
std::vector<pid_t> children()
{
    std::vector<pid_t> result;
    const std::string self = std::to_string(getpid());
    std::ifstream list("/proc/" + self + "/task/" + self + "/children");
    for (pid_t child = 0; list >> child;)
        result.push_back(child);
    return result;
}

bool contains(const std::vector<pid_t> &pids, pid_t pid)
{
    return std::find(pids.begin(), pids.end(), pid) != pids.end();
}
}  // namespace

Orphans::Orphans() : before_(children())
{
    prctl(PR_GET_CHILD_SUBREAPER, &wasReaper_);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
}

Orphans::~Orphans()
{
    kill({});
    prctl(PR_SET_CHILD_SUBREAPER, wasReaper_);
}

void Orphans::kill(const std::vector<pid_t> &except) const
{
    // The children of an orphan that dies become orphans of ours: look until there are none.
    for (bool found = true; found;)
    {
        found = false;
        for (const pid_t child : children())
            if (!contains(before_, child) && !contains(except, child))
            {
                found = true;
                ::kill(child, SIGKILL);
                while (waitpid(child, nullptr, 0) < 0 && errno == EINTR)
                    continue;
            }
    }
}
}  // namespace narrows
