// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/scaling/Outline.h"
#include "kernel/scaling/ScalingProblem.h"

namespace narrows
{
/// The ways of a tip through the section plane from waypoint to waypoint (step 4, the second problem): straight legs
/// and, where one runs into danger regions, taut bypasses along their boundaries. Every region that a leg runs into may
/// be passed on either side, which is one choice each. So is every region between a leg and the base, around which the
/// arm would be wrapped: the tip may go round it by the base's side instead.
///
/// Danger regions that overlap are one region, their convex hull.
class TipRoutes
{
public:
    /// \param clearances that tips keep from the sections, one for each
    TipRoutes(const std::vector<ConvexSection> &sections, const std::vector<double> &clearances,
              std::vector<Eigen::Vector2d> waypoints);

    /// TipBlocked or Overlap, if a waypoint is inside a region or inside a hull of several; then there are no routes.
    const ScalingFault &fault() const { return fault_; }
    std::size_t legs() const { return waypoints_.empty() ? 0 : waypoints_.size() - 1; }  ///< between waypoints
    /// Danger regions in the way, over all legs in their order, each to be passed on either side; 0 if there is a
    /// fault.
    std::size_t choices() const { return hits_.size(); }
    /// How much longer the way on the longer side is, roughly, for a choice.
    double detour(std::size_t choice) const { return hits_[choice].detour; }

    /// The corners of a leg, both waypoints included.
    /// \param longer for every choice, whether the longer side is taken; missing ones are false
    std::vector<Eigen::Vector2d> leg(std::size_t index, const std::vector<bool> &longer) const;

private:
    /// A region on a leg, or between a leg and the base: from where to where on the leg, and on which edges of the
    /// region.
    struct Hit
    {
        std::size_t leg;
        std::size_t region;
        double enters, leaves;
        std::size_t entryEdge, exitEdge;
        bool leftIsShorter;  ///< to keep the region on the left, which is to go round it counter-clockwise
        double detour;
        bool beside;  ///< not on the leg: the longer way is a whole turn around the region, which is pulled taut
    };

    void merge(const std::vector<ConvexSection> &sections, const std::vector<double> &clearances);
    void findHits(std::size_t leg);
    void findBeside(std::size_t leg);
    void visit(const Hit &hit, bool longer, std::vector<Eigen::Vector2d> &way) const;
    std::vector<Eigen::Vector2d> pull(const std::vector<Eigen::Vector2d> &way) const;
    void bypass(const Hit &hit, bool longer, std::vector<Eigen::Vector2d> &way) const;
    double around(const Hit &hit, bool left) const;

    std::vector<Outline> regions_;
    std::vector<bool> merged_;
    std::vector<Eigen::Vector2d> waypoints_;
    std::vector<Hit> hits_;  ///< in the order of legs, and along them
    ScalingFault fault_;
};
}  // namespace narrows
