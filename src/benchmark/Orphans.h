// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <sys/types.h>

namespace narrows
{
/// While there is one, processes that lose their parent become children of this process, if they descend from it. So
/// nothing that a run has started can get away, not even into a session of its own. Where the system does not list a
/// process's children, nothing is done.
class Orphans
{
public:
    Orphans();
    /// Kills those that have not been killed yet, and gives orphans back to the system.
    ~Orphans();
    Orphans(const Orphans &) = delete;
    Orphans &operator=(const Orphans &) = delete;

    /// Kills all children of this process that it has got since construction, and waits for their end.
    /// \param except children to leave alone
    void kill(const std::vector<pid_t> &except) const;

private:
    std::vector<pid_t> before_;  ///< children at construction
    int wasReaper_ = 0;
};
}  // namespace narrows
