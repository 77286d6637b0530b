// SPDX-License-Identifier: BSD-3-Clause
#include "planners/NearNames.h"

#include <algorithm>
#include <numeric>

namespace narrows
{
namespace
{
constexpr std::size_t farthest = 2;  ///< edits
constexpr std::size_t most = 4;      ///< names

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

bool contains(const std::string &whole, const std::string &part)
{
    return part.size() > farthest && whole.find(part) != std::string::npos;
}
}  // namespace

std::vector<std::string> nearNames(const std::string &word, const std::vector<std::string> &names)
{
    constexpr std::size_t longestWord = 64;  // keeps a hostile word from costing quadratic time
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const std::string &name : names)
    {
        const std::size_t distance = word.size() > longestWord ? word.size() : editDistance(word, name);
        const bool similar = distance <= farthest && distance < name.size();
        if (similar || contains(name, word) || contains(word, name))
            near.emplace_back(distance, name);
    }
    std::sort(near.begin(), near.end());
    near.resize(std::min(near.size(), most));
    std::vector<std::string> result;
    for (auto &[distance, name] : near)
        result.push_back(std::move(name));
    return result;
}
}  // namespace narrows
