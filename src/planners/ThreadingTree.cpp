// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ThreadingTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace narrows
{
namespace
{
double inOnePeriod(double value, double period)
{
    return 2.0 * std::abs(value) <= period ? value : std::remainder(value, period);
}
}  // namespace

int ThreadingTree::add(const Eigen::VectorXd &x, int parent, int level, const Eigen::VectorXd &coordinates, bool listed)
{
    nodes_.push_back({x, parent, level});
    if (listed)
        list(size() - 1, coordinates);
    return size() - 1;
}

void ThreadingTree::list(int node, const Eigen::VectorXd &coordinates)
{
    const Eigen::VectorXd &x = (*this)[node].x;
    listed_.push_back(node);
    for (Eigen::Index j = 0; j < x.size(); ++j)
        wrapped_.push_back(inOnePeriod(x[j], periods_[j]));
    append(coordinates);
}

int ThreadingTree::nearest(const Eigen::VectorXd &x) const
{
    thread_local Eigen::VectorXd from;
    from.resize(x.size());
    for (Eigen::Index j = 0; j < x.size(); ++j)
        from[j] = inOnePeriod(x[j], periods_[j]);
    double least = std::numeric_limits<double>::infinity();
    int result = -1;
    const double *other = wrapped_.data();
    for (const int node : listed_)
    {
        double sum = 0.0;
        for (Eigen::Index j = 0; j < from.size(); ++j)
        {
            const double apart = std::abs(from[j] - other[j]);
            const double way = std::min(apart, periods_[j] - apart);
            sum += way * way;
        }
        other += from.size();
        if (sum < least)
        {
            least = sum;
            result = node;
        }
    }
    return result;
}

int ThreadingTree::nearestInSlice(const Eigen::VectorXd &coordinates) const
{
    double least = std::numeric_limits<double>::infinity();
    int result = -1;
    const double *other = slices_.data();
    for (const int node : listed_)
    {
        if ((*this)[node].level <= coordinates.size())
        {
            double sum = 0.0;
            for (Eigen::Index j = 0; j < coordinates.size(); ++j)
                sum += (coordinates[j] - other[j]) * (coordinates[j] - other[j]);
            if (sum < least)
            {
                least = sum;
                result = node;
            }
        }
        other += coordinateCount_;
    }
    return result;
}
}  // namespace narrows
