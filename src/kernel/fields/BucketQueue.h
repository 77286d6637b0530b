// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace narrows
{
/// A queue for Dijkstra's algorithm without comparisons: costs fall into buckets that are no wider than the least cost
/// of a step, so that nothing in the lowest bucket can be improved any more and its order does not matter.
class BucketQueue
{
public:
    /// \param least least cost of a step, > 0
    /// \param most greatest cost of a step
    BucketQueue(double least, double most) : width_(least), buckets_(static_cast<std::size_t>(most / least) + 3) {}

    /// \pre between the cost taken out last and that plus the greatest cost of a step
    void push(double cost, int item)
    {
        bucketOf(static_cast<std::int64_t>(cost / width_)).emplace_back(cost, item);
        ++size_;
    }

    /// Whether nothing is left.
    bool empty() const { return size_ == 0; }

    /// \pre not empty
    std::pair<double, int> pop()
    {
        while (bucketOf(current_).empty())
            ++current_;
        const std::pair<double, int> item = bucketOf(current_).back();
        bucketOf(current_).pop_back();
        --size_;
        return item;
    }

private:
    std::vector<std::pair<double, int>> &bucketOf(std::int64_t number)
    {
        return buckets_[static_cast<std::size_t>(number) % buckets_.size()];
    }

    double width_;
    std::vector<std::vector<std::pair<double, int>>> buckets_;
    std::int64_t current_ = 0;
    std::size_t size_ = 0;
};
}  // namespace narrows
