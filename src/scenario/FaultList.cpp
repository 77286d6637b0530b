// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/FaultList.h"

#include <algorithm>

#include <fmt/format.h>

#include "planners/NearNames.h"

namespace narrows
{
void FaultList::add(int line, const std::string &key, const std::string &reason)
{
    faults_.push_back({file_, line, key, reason});
}

void FaultList::throwIfAny() const
{
    if (faults_.empty())
        return;
    std::vector<InputFault> sorted = faults_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const InputFault &a, const InputFault &b) { return a.line < b.line; });
    throw InputError(std::move(sorted));
}

std::string suggestion(const std::string &word, const std::vector<std::string> &known)
{
    const std::vector<std::string> near = nearNames(word, known);
    return near.empty() ? std::string{} : fmt::format("; did you mean '{}'?", near.front());
}
}  // namespace narrows
