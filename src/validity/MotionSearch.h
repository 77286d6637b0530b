// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "validity/LinkChecker.h"
#include "validity/MovingArm.h"

namespace narrows
{
using LinkPair = std::pair<int, int>;  ///< indices of two links of one arm

/// So many links are looked at faster all at once, by their boxes; fewer, one by one.
constexpr int worthBoxing = 6;

/// One motion of an arm under examination. Keeps its memory from one motion to the next.
template <class Arm>
class MotionSearch
{
public:
    /// Chooses the motion q + t * delta, t in [0, 1]. What is given by reference must last until the next begin().
    /// \param arm that moves \param checker of its links among the obstacles
    /// \param pairs links that must not touch each other
    /// \param resolution what is closer counts as touching
    /// \param q, delta a configuration and a difference of two
    /// \param placements grows by the number of configurations that are looked at
    void begin(const Arm &arm, const LinkChecker<Arm::Dim> &checker, const std::vector<LinkPair> &pairs,
               double resolution, ConfigurationRef q, ConfigurationRef delta, std::uint64_t &placements)
    {
        checker_ = &checker;
        pairs_ = &pairs;
        linkCount_ = arm.linkCount();
        resolution_ = resolution;
        placements_ = &placements;
        moving_.begin(arm, q, delta);
    }

    /// Level by level, because a collision is found soonest where nothing has been looked at yet. In the open the first
    /// look settles the whole motion, ends included; a look of its own at the end was measured to cost more than it
    /// saves.
    bool isFree()
    {
        if (!examine(all(0.0, 1.0), true))
            return false;
        for (std::size_t next = 0; next < pending_.size(); ++next)
            if (!examine(pending_[next], true))
                return false;
        return true;
    }

    /// End of the free stretch that begins at 0, to a resolution of 1/256.
    double freeUntil()
    {
        double certain = 0.0;
        double width = 1.0;
        while (certain < 1.0 && width >= 1.0 / 256)
        {
            const double end = std::min(certain + width, 1.0);
            if (examine(all(certain, end), false))
                certain = end;
            else
                width *= 0.5;
        }
        return certain;
    }

private:
    struct Stretch
    {
        double begin;
        double end;
        int firstTask;  ///< what is still to be certified is tasks_[firstTask] ... tasks_[firstTask + taskCount - 1]
        int taskCount;
    };

    /// A stretch of which nothing is known yet. A task is the index of a link, or, beyond these, of a pair.
    Stretch all(double begin, double end)
    {
        pending_.clear();
        tasks_.resize(taskCount());
        std::iota(tasks_.begin(), tasks_.end(), 0);
        return {begin, end, 0, static_cast<int>(tasks_.size())};
    }

    /// Certifies what can be certified of a stretch. With `divide`, its halves are queued for the other tasks and only
    /// a touch is a failure; without, every task that is not certified is one. By value: pending_ grows.
    bool examine(const Stretch stretch, bool divide)
    {
        const double half = 0.5 * (stretch.end - stretch.begin);
        const double middle = stretch.begin + half;
        moving_.place(middle);
        ++*placements_;
        const bool boxed = linkCount_ >= worthBoxing && stretch.taskCount == taskCount();
        if (boxed)
            findNear(half);
        const int firstOpen = static_cast<int>(tasks_.size());
        for (int k = 0; k < stretch.taskCount; ++k)
        {
            const int task = tasks_[stretch.firstTask + k];
            const Finding finding = examineTask(task, half, boxed);
            if (finding == Finding::Clear)
                continue;
            if (!divide || finding == Finding::Touching || reach(task, half) < resolution_)
                return false;
            tasks_.push_back(task);
        }
        const int open = static_cast<int>(tasks_.size()) - firstOpen;
        if (open > 0)
        {
            pending_.push_back(Stretch{stretch.begin, middle, firstOpen, open});
            pending_.push_back(Stretch{middle, stretch.end, firstOpen, open});
        }
        return true;
    }

    int taskCount() const { return linkCount_ + static_cast<int>(pairs_->size()); }

    /// Boxes around all that the links can reach on a stretch, and what is in them. It pays where most of the arm is in
    /// the open, which is when nothing is known yet.
    void findNear(double half)
    {
        boxes_.resize(linkCount_);
        for (int i = 0; i < linkCount_; ++i)
        {
            const LinkMotion<Arm::Dim> link = moving_.motion(i, half, resolution_);
            boxes_.set(i, link.a.position, link.b.position, link.radius + link.reach());
        }
        checker_->findNear(boxes_, near_);
    }

    /// Links are made thicker by the resolution, so that certificates have rounding errors to spare.
    Finding examineTask(int task, double half, bool boxed) const
    {
        if (task < linkCount_)
        {
            const ObstacleBits near = boxed ? near_[task] : allObstacles;
            return near == 0 ? Finding::Clear : checker_->examine(moving_.motion(task, half, resolution_), near);
        }
        const auto &[link, other] = (*pairs_)[task - linkCount_];
        if (boxed && !boxes_.meet(link, other))
            return Finding::Clear;
        return checker_->examine(moving_.motion(link, half, resolution_), moving_.motion(other, half, resolution_));
    }

    double reach(int task, double half) const
    {
        if (task < linkCount_)
            return moving_.motion(task, half, 0.0).reach();
        const auto &[link, other] = (*pairs_)[task - linkCount_];
        return moving_.motion(link, half, 0.0).reach() + moving_.motion(other, half, 0.0).reach();
    }

    const LinkChecker<Arm::Dim> *checker_ = nullptr;
    const std::vector<LinkPair> *pairs_ = nullptr;
    int linkCount_ = 0;
    double resolution_ = 0.0;
    std::uint64_t *placements_ = nullptr;
    MovingArm<Arm> moving_;
    BoxArrays<Arm::Dim> boxes_;
    std::vector<ObstacleBits> near_;
    std::vector<int> tasks_;
    std::vector<Stretch> pending_;
};
}  // namespace narrows
