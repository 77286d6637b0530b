// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "validity/ArmChecker.h"
#include "validity/MotionSearch.h"

namespace narrows
{
/// An `ArmChecker` that asks a `LinkChecker` about each link, and each pair of links that can collide.
template <class Arm>
class LinkwiseChecker : public ArmChecker
{
public:
    /// \param arm is copied \param links among the obstacles \param selfCollision whether links that are not neighbours
    /// must not touch
    LinkwiseChecker(const Arm &arm, std::unique_ptr<const LinkChecker<Arm::Dim>> links, bool selfCollision)
      : arm_(arm), links_(std::move(links)), resolution_(1e-9 * arm.reach())
    {
        for (int link = 0; selfCollision && link < arm.linkCount(); ++link)
            for (int other = 0; other < link; ++other)
                if (!arm.areNeighbours(link, other))
                    pairs_.emplace_back(link, other);
    }

    bool isFree(ConfigurationRef q) const override
    {
        const MovingArm<Arm> &placed = place(q);
        if (arm_.linkCount() < worthBoxing)
            return areClear(placed);
        thread_local BoxArrays<Arm::Dim> boxes;
        thread_local std::vector<ObstacleBits> near;
        placed.box(boxes);
        links_->findNear(boxes, near);
        for (int i = 0; i < arm_.linkCount(); ++i)
            if (near[i] != 0 && !links_->clears(placed.link(i), near[i]))
                return false;
        for (const auto &[link, other] : pairs_)
            if (boxes.meet(link, other) && !links_->clears(placed.link(link), placed.link(other)))
                return false;
        return true;
    }

    double clearance(ConfigurationRef q) const override
    {
        const MovingArm<Arm> &placed = place(q);
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < arm_.linkCount(); ++i)
            least = std::min(least, links_->clearance(placed.link(i)));
        for (const auto &[link, other] : pairs_)
            least = std::min(least, links_->clearance(placed.link(link), placed.link(other)));
        return least;
    }

    bool isMotionFree(ConfigurationRef q, ConfigurationRef delta, std::uint64_t &placements) const override
    {
        return search(q, delta, placements).isFree();
    }

    double freeUntil(ConfigurationRef q, ConfigurationRef delta, std::uint64_t &placements) const override
    {
        return search(q, delta, placements).freeUntil();
    }

protected:
    const std::vector<LinkPair> &pairs() const { return pairs_; }  ///< links that must not touch each other

private:
    /// isFree() one by one, for few links.
    bool areClear(const MovingArm<Arm> &placed) const
    {
        for (int i = 0; i < arm_.linkCount(); ++i)
            if (!links_->clears(placed.link(i)))
                return false;
        return std::all_of(pairs_.begin(), pairs_.end(),
                           [&](const LinkPair &pair)
                           { return links_->clears(placed.link(pair.first), placed.link(pair.second)); });
    }

    const MovingArm<Arm> &place(ConfigurationRef q) const
    {
        thread_local MovingArm<Arm> placed;
        placed.rest(arm_, q);
        return placed;
    }

    MotionSearch<Arm> &search(ConfigurationRef q, ConfigurationRef delta, std::uint64_t &placements) const
    {
        thread_local MotionSearch<Arm> search;
        search.begin(arm_, *links_, pairs_, resolution_, q, delta, placements);
        return search;
    }

    Arm arm_;
    std::unique_ptr<const LinkChecker<Arm::Dim>> links_;
    std::vector<LinkPair> pairs_;
    double resolution_;
};
}  // namespace narrows
