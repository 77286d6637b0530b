// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarModel.h"
#include "validity/LaneObstacles.h"
#include "validity/LinkChecker.h"
#include "validity/MotionSearch.h"

namespace narrows
{
/// Looks at sixteen configurations of a planar arm side by side, in single precision: a filter in front of exact
/// checks. What it finds clear or touching is so in exact arithmetic; what is within some millionths of the arm's reach
/// per link of a touch it leaves open, and also what it has no closed form for (see LaneObstacles.h). Immutable.
class PlanarScreen
{
public:
    /// \param pairs links that must not touch each other
    PlanarScreen(const PlanarModel &model, std::vector<LinkPair> pairs);

    /// What can be said of each configuration. \param configurations one a row
    void examine(const Eigen::Ref<const Eigen::MatrixXd> &configurations, std::vector<Finding> &findings) const;

private:
    struct Work;

    void examineBlock(const Eigen::Ref<const Eigen::MatrixXd> &block, Work &work) const;
    std::uint32_t place(const Eigen::Ref<const Eigen::MatrixXd> &block, Work &work) const;
    void examineObstacles(Work &work) const;
    void examineObstacle(std::size_t k, const lanes::Points &a, const lanes::Points &b, std::uint32_t near,
                         Work &work) const;
    void examinePairs(Work &work) const;
    void flush(std::size_t k, Work &work) const;

    PlanarArm arm_;
    std::vector<lanes::Link> links_;
    std::vector<LinkPair> pairs_;
    double room_;  ///< how far points may be from where they are said to be
    lanes::Range pairRange_;
    LaneObstacles obstacles_;
};
}  // namespace narrows
