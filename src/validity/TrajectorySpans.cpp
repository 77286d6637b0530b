// SPDX-License-Identifier: BSD-3-Clause
#include "validity/TrajectorySpans.h"

#include <algorithm>

namespace narrows
{
TrajectorySpans::TrajectorySpans(const JointTrajectory &trajectory)
{
    std::vector<std::vector<double>> own;
    for (Eigen::Index i = 0; i < trajectory.joints(); ++i)
    {
        joints_.push_back(trajectory.joint(i));
        own.push_back(joints_.back()->knots());
        if (i == 0 || own[static_cast<std::size_t>(i)] != own.front())
            knots_.insert(knots_.end(), own.back().begin(), own.back().end());
    }
    std::sort(knots_.begin(), knots_.end());
    knots_.erase(std::unique(knots_.begin(), knots_.end()), knots_.end());
    for (const std::vector<double> &knots : own)
    {
        own_.emplace_back();
        for (std::size_t piece = 0; piece < pieces(); ++piece)
        {
            const double middle = 0.5 * (knots_[piece] + knots_[piece + 1]);
            const auto next = std::upper_bound(knots.begin() + 1, knots.end() - 1, middle);
            own_.back().push_back(static_cast<std::size_t>(next - knots.begin()) - 1);
        }
    }
}

void TrajectorySpans::bounds(std::size_t piece, const Enclosure &span, Eigen::VectorXd &speeds,
                             Eigen::VectorXd &accelerations) const
{
    speeds.resize(static_cast<Eigen::Index>(joints_.size()));
    accelerations.resize(speeds.size());
    for (std::size_t i = 0; i < joints_.size(); ++i)
    {
        const Series<4, Enclosure> values = joints_[i]->over(own_[i][piece], span);
        speeds[static_cast<Eigen::Index>(i)] = values[1].magnitude();
        accelerations[static_cast<Eigen::Index>(i)] = values[2].magnitude();
    }
}
}  // namespace narrows
