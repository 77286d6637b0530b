// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "kernel/scaling/PathScaling.h"
#include "kernel/scaling/TipRoutes.h"

namespace narrows
{
/// How the scaling method is used. Lengths that are 0 stand for the defaults that go with the robot.
struct ScalingSettings
{
    ScalingMode mode = ScalingMode::Taut;              ///< how joint centres are found that belong to a tip
    double margin = 0.0;                               ///< of danger regions, >= the links' radius; 0: 1.63 radii
    std::vector<double> margins{1.0, 1.4, 0.75, 1.8};  ///< factors > 0 of the margin, tried in this order
    int sideSearch = 64;      ///< >= 1, ways of passing obstacles on either side that are tried per margin, at most
    double step = 0.0;        ///< largest distance of neighbouring tips, >= 0; 0: a 625th of the reach
    double maxJump = 0.0;     ///< largest way of a joint in the section plane per step, >= 0; 0: six steps
    int easing = 40;          ///< >= 0, rounds in which poses that break a rule are eased (Taut)
    double retraction = 0.0;  ///< >= 0, how far the tip draws back along the slide on bypasses
};

/// Poses for a tip's way through all its waypoints, or for the first part of it.
struct ScaledWay
{
    ScalingResult scaled;                ///< its poses
    std::vector<Eigen::Vector3d> tips;   ///< of the whole way; the first is the start's
    std::vector<std::size_t> waypoints;  ///< for every waypoint after the start, which tip it is
    double margin = 0.0;                 ///< where nothing forces a smaller one
    std::vector<bool> longer;            ///< the sides taken
    ScalingFault fault;                  ///< none: all tips have poses
};

/// All ways of scaling that may lead a tip through its waypoints, one after the other: margins, and for each of them
/// the sides on which danger regions are passed, cheapest first.
///
/// An obstacle of finite length counts only from when a pose runs into it, so that the arm may pass before and behind.
class ScalingSearch
{
public:
    /// \param problem chain and obstacles \param settings lengths that are 0 get their defaults here
    /// \param start joint centres of the pose to begin near to, in the slide frame; the taut string keeps its way
    /// around obstacles
    /// \param waypoints of the tip after that
    ScalingSearch(const ScalingProblem &problem, const ScalingSettings &settings,
                  const std::vector<Eigen::Vector3d> &start, const std::vector<Eigen::Vector3d> &waypoints);

    /// The next way; nothing if all have been tried.
    std::optional<ScaledWay> next(const std::function<bool()> &interrupted);

private:
    /// Per considered section.
    struct Margins
    {
        double all;                  ///< as wanted, for all
        std::vector<double> joints;  ///< of the danger regions
        std::vector<double> tip;     ///< distances that the tip keeps on bypasses
        std::vector<bool> behind;    ///< tips are in these regions, but before the obstacle
    };

    void activate(std::size_t section);
    double tipDistance(const ConvexSection &section) const;
    double startDistance(const ConvexSection &section) const;
    bool isBehindTips(const ConvexSection &section) const;
    Margins margins(double wanted) const;
    void prepareMargins();
    void prepareSides();
    std::optional<std::size_t> unexpected(const ScalingResult &scaled) const;
    ScaledWay scale(const std::vector<bool> &longer, const std::function<bool()> &interrupted) const;
    void layTips(const std::vector<bool> &longer, ScaledWay &way) const;

    ScalingProblem problem_;
    ScalingSettings settings_;
    std::vector<Eigen::Vector3d> start_;
    std::vector<Eigen::Vector3d> waypoints_;  ///< the start's tip included
    std::vector<bool> active_;                ///< per section of the problem
    ScalingProblem considered_;               ///< with the active sections only
    std::vector<Margins> margins_;            ///< to be tried
    std::size_t margin_ = 0;
    std::optional<TipRoutes> routes_;  ///< for this margin
    std::vector<std::vector<bool>> sides_;
    std::size_t side_ = 0;
};
}  // namespace narrows
