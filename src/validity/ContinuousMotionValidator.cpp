// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ContinuousMotionValidator.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace narrows
{
/// One motion under examination. Lives per thread, so that its memory is used again.
class ContinuousMotionValidator::Motion
{
public:
    void begin(const ContinuousMotionValidator &validator, const ob::State *from, const ob::State *to)
    {
        validator_ = &validator;
        placements_ = 0;
        validator.space_->toAbsolute(from, from_);
        validator.space_->displacement(from, to, delta_);
        validator.space_->arm().motionBounds(delta_, bounds_, bends_);
    }

    std::uint64_t placements() const { return placements_; }

    /// Level by level, because a collision is found soonest where nothing has been looked at yet. In the open the first
    /// look settles the whole motion, ends included; a look of its own at the end was measured to cost more than it
    /// saves.
    bool isFree()
    {
        links_.resize(bounds_.size());
        std::iota(links_.begin(), links_.end(), 0);
        pending_.clear();
        if (!examine(Stretch{0.0, 1.0, 0, static_cast<int>(links_.size())}, true))
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
            links_.resize(bounds_.size());
            std::iota(links_.begin(), links_.end(), 0);
            pending_.clear();
            // The first stretch only: what it leaves pending is for a narrower one to decide.
            if (examine(Stretch{certain, std::min(certain + width, 1.0), 0, static_cast<int>(links_.size())}, false))
                certain = std::min(certain + width, 1.0);
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
        int firstLink;  ///< the links still to be certified are links_[firstLink] ... links_[firstLink + linkCount - 1]
        int linkCount;
    };

    void place(double t)
    {
        q_ = from_ + t * delta_;
        validator_->space_->arm().place(q_, points_);
        ++placements_;
    }

    /// How far any point of a link can get from where it is now, within `half` of the motion's parameter either way: at
    /// most the bound on its way, and at most its speed now times `half` plus what its acceleration can add. A link's
    /// points move no faster than the faster of its ends.
    double travel(int link, double half) const
    {
        const Eigen::Vector2d &base = velocities_[validator_->space_->arm().links()[link].parent + 1];
        const double speed = std::sqrt(std::max(base.squaredNorm(), velocities_[link + 1].squaredNorm()));
        return half * std::min(bounds_[link], speed + 0.5 * half * bends_[link]);
    }

    /// Certifies what can be certified of a stretch. With `divide`, its halves are queued for the other links and only
    /// a link that touches something is a failure; without, every link that is not certified is one. By value: pending_
    /// grows.
    bool examine(const Stretch stretch, bool divide)
    {
        const double half = 0.5 * (stretch.end - stretch.begin);
        const double middle = stretch.begin + half;
        place(middle);
        validator_->space_->arm().velocities(points_, delta_, velocities_);
        const int firstOpen = static_cast<int>(links_.size());
        for (int k = 0; k < stretch.linkCount; ++k)
        {
            const int i = links_[stretch.firstLink + k];
            const Eigen::Vector2d &a = points_[validator_->space_->arm().links()[i].parent + 1];
            const Eigen::Vector2d &b = points_[i + 1];
            const double reach = travel(i, half);
            if (validator_->checker_->linkClears(a, b, reach))
                continue;
            if (!divide || reach < validator_->resolution_ || !validator_->checker_->linkClears(a, b, 0.0))
                return false;
            links_.push_back(i);
        }
        const int open = static_cast<int>(links_.size()) - firstOpen;
        if (open > 0)
        {
            pending_.push_back(Stretch{stretch.begin, middle, firstOpen, open});
            pending_.push_back(Stretch{middle, stretch.end, firstOpen, open});
        }
        return true;
    }

    const ContinuousMotionValidator *validator_ = nullptr;
    Eigen::VectorXd from_, delta_, bounds_, bends_, q_;
    std::vector<Eigen::Vector2d> points_, velocities_;
    std::vector<int> links_;
    std::vector<Stretch> pending_;
    std::uint64_t placements_ = 0;
};

ContinuousMotionValidator::ContinuousMotionValidator(const ob::SpaceInformationPtr &si,
                                                     std::shared_ptr<const PlanarChecker> checker,
                                                     std::shared_ptr<CheckCounts> counts)
  : ob::MotionValidator(si),
    space_(si->getStateSpace()->as<PlanarArmStateSpace>()),
    checker_(std::move(checker)),
    counts_(std::move(counts)),
    resolution_(1e-9 * space_->arm().reach())
{
}

bool ContinuousMotionValidator::checkMotion(const ob::State *from, const ob::State *to) const
{
    thread_local Motion motion;
    motion.begin(*this, from, to);
    const bool free = space_->satisfiesBounds(to) && motion.isFree();
    counts_->placements.fetch_add(motion.placements(), std::memory_order_relaxed);
    return record(free);
}

bool ContinuousMotionValidator::checkMotion(const ob::State *from, const ob::State *to,
                                            std::pair<ob::State *, double> &lastValid) const
{
    if (checkMotion(from, to))
        return true;
    thread_local Motion motion;
    motion.begin(*this, from, to);
    lastValid.second = motion.freeUntil();
    counts_->placements.fetch_add(motion.placements(), std::memory_order_relaxed);
    if (lastValid.first != nullptr)
        si_->getStateSpace()->interpolate(from, to, lastValid.second, lastValid.first);
    return false;
}

bool ContinuousMotionValidator::record(bool free) const
{
    // OMPL's own tallies are plain numbers; with several threads they are approximate, ours are not.
    ++(free ? valid_ : invalid_);
    counts_->motionChecks.fetch_add(1, std::memory_order_relaxed);
    return free;
}
}  // namespace narrows
