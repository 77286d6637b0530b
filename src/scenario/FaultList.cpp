// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/FaultList.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace narrows
{
namespace
{
std::size_t editDistance(const std::string &a, const std::string &b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}
}  // namespace

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
    constexpr std::size_t far = 3;
    constexpr std::size_t longestWord = 64;  // keeps a hostile key from costing quadratic time
    if (word.size() > longestWord)
        return {};
    std::size_t nearest = std::min(far, word.size());
    std::string found;
    for (const std::string &candidate : known)
    {
        const std::size_t distance = editDistance(word, candidate);
        if (distance < nearest)
        {
            nearest = distance;
            found = candidate;
        }
    }
    return found.empty() ? std::string{} : fmt::format("; did you mean '{}'?", found);
}
}  // namespace narrows
