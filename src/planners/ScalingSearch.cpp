// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ScalingSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernel/scaling/PoseRules.h"
#include "kernel/scaling/TipPath.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double marginPerRadius = 1.63;  ///< the paper: 100 mm for links of 61.5 mm
constexpr double marginPerReach = 0.032;  ///< for links without thickness
constexpr double stepsPerReach = 625.0;   ///< the paper's arm: 5 mm
constexpr double jumpPerStep = 6.0;
constexpr double tipGap = 1.02;        ///< the tip keeps this much more than the margin
constexpr double waypointGap = 0.999;  ///< what is left of a waypoint's or the start's distance for the tip
/// A leg that comes nearer than its ends, but not nearer than this share, is a chord of an arc: it is to be gone along.
constexpr double chord = 0.9;
constexpr int mostChoices = 20;

bool isEndless(const ConvexSection &section)
{
    return std::isinf(section.span().lower) && std::isinf(section.span().upper);
}

SectionChain project(const std::vector<Vector3d> &centres)
{
    SectionChain chain;
    for (const Vector3d &centre : centres)
        chain.push_back(centre.tail<2>());
    return chain;
}

/// The sets of choices with the smallest sums of detours: at most `count`, beginning with the empty set.
std::vector<std::vector<bool>> cheapestSides(const TipRoutes &routes, std::size_t count)
{
    std::vector<std::size_t> order(routes.choices());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return routes.detour(a) < routes.detour(b); });
    order.resize(std::min<std::size_t>(order.size(), mostChoices));
    std::vector<std::pair<double, std::vector<bool>>> sets{{0.0, std::vector<bool>(routes.choices(), false)}};
    // The cheapest sets of the first i choices are among the cheapest of the first i - 1, with and without choice i.
    for (const std::size_t choice : order)
    {
        const std::size_t size = sets.size();
        for (std::size_t s = 0; s < size; ++s)
        {
            sets.push_back(sets[s]);
            sets.back().first += routes.detour(choice);
            sets.back().second[choice] = true;
        }
        std::stable_sort(sets.begin(), sets.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
        sets.resize(std::min(sets.size(), count));
    }
    std::vector<std::vector<bool>> result;
    for (auto &set : sets)
        result.push_back(std::move(set.second));
    return result;
}
}  // namespace

ScalingSearch::ScalingSearch(const ScalingProblem &problem, const ScalingSettings &settings,
                             const std::vector<Vector3d> &start, const std::vector<Vector3d> &waypoints)
  : problem_(problem), settings_(settings), start_(start), waypoints_{start.back()}, considered_(problem)
{
    waypoints_.insert(waypoints_.end(), waypoints.begin(), waypoints.end());
    const double reach = problem.reach();
    if (settings_.margin == 0.0)
        settings_.margin = problem.radius > 0.0 ? marginPerRadius * problem.radius : marginPerReach * reach;
    if (settings_.step == 0.0)
        settings_.step = reach / stepsPerReach;
    if (settings_.maxJump == 0.0)
        settings_.maxJump = jumpPerStep * settings_.step;
    for (const ConvexSection &section : problem.sections)
        active_.push_back(isEndless(section));
    prepareMargins();
}

/// How near a section comes the waypoints and the chords of arcs about it.
double ScalingSearch::tipDistance(const ConvexSection &section) const
{
    double least = std::numeric_limits<double>::infinity();
    for (const Vector3d &waypoint : waypoints_)
        least = std::min(least, section.distance(waypoint.tail<2>()));
    double chords = least;
    for (std::size_t i = 1; i < waypoints_.size(); ++i)
    {
        const double distance = section.distance(waypoints_[i - 1].tail<2>(), waypoints_[i].tail<2>());
        if (distance >= chord * least)
            chords = std::min(chords, distance);
    }
    return chords;
}

double ScalingSearch::startDistance(const ConvexSection &section) const
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < start_.size(); ++i)
        least = std::min(least, section.distance(start_[i - 1].tail<2>(), start_[i].tail<2>()));
    return least;
}

/// Are all waypoints beyond an obstacle along the slide, so that the arm may end before it?
bool ScalingSearch::isBehindTips(const ConvexSection &section) const
{
    return std::all_of(waypoints_.begin(), waypoints_.end(),
                       [&](const Vector3d &waypoint) { return section.span().upper + problem_.radius < waypoint.x(); });
}

ScalingSearch::Margins ScalingSearch::margins(double wanted) const
{
    Margins result{std::max(wanted, problem_.radius), {}, {}, {}};
    for (const ConvexSection &section : considered_.sections)
    {
        const double nearest = waypointGap * tipDistance(section);
        const bool behind = nearest < problem_.radius && isBehindTips(section);
        const double tip = behind ? tipGap * wanted : std::min(tipGap * wanted, nearest);
        result.behind.push_back(behind);
        // The string must neither begin nor end in a danger region.
        const bool taut = settings_.mode == ScalingMode::Taut;
        const double joints =
            taut ? std::min({wanted, waypointGap * tip, waypointGap * startDistance(section)}) : wanted;
        result.joints.push_back(std::max(joints, problem_.radius));
        result.tip.push_back(tip);
    }
    return result;
}

/// Begins anew with the sections that are active now.
void ScalingSearch::prepareMargins()
{
    considered_.sections.clear();
    for (std::size_t s = 0; s < active_.size(); ++s)
        if (active_[s])
            considered_.sections.push_back(problem_.sections[s]);
    margins_.clear();
    margin_ = 0;
    routes_.reset();
    for (const double factor : settings_.margins)
    {
        Margins next = margins(factor * settings_.margin);
        const auto same = [&](const Margins &other)
        {
            return other.joints == next.joints && other.tip == next.tip;
        };
        // Crossbars have no margins of their own.
        if (!considered_.crossbars.empty() || std::none_of(margins_.begin(), margins_.end(), same))
            margins_.push_back(std::move(next));
    }
}

void ScalingSearch::activate(std::size_t section)
{
    active_[section] = true;
    prepareMargins();
}

void ScalingSearch::prepareSides()
{
    std::vector<Vector2d> points;
    for (const Vector3d &waypoint : waypoints_)
        points.push_back(waypoint.tail<2>());
    std::vector<ConvexSection> inTheWay;
    std::vector<double> clearances;
    for (std::size_t s = 0; s < considered_.sections.size(); ++s)
        if (!margins_[margin_].behind[s])
        {
            inTheWay.push_back(considered_.sections[s]);
            clearances.push_back(margins_[margin_].tip[s]);
        }
    routes_.emplace(inTheWay, clearances, std::move(points));
    sides_ = cheapestSides(*routes_, static_cast<std::size_t>(settings_.sideSearch));
    side_ = 0;
}

std::optional<ScaledWay> ScalingSearch::next(const std::function<bool()> &interrupted)
{
    while (margin_ < margins_.size() && !interrupted())
    {
        if (!routes_)
            prepareSides();
        if (side_ >= sides_.size())
        {
            ++margin_;
            routes_.reset();
            continue;
        }
        ScaledWay way = scale(sides_[side_++], interrupted);
        const std::optional<std::size_t> met = unexpected(way.scaled);
        if (!met)
            return way;
        activate(*met);
    }
    return std::nullopt;
}

/// A section that is not considered and that a pose runs into.
std::optional<std::size_t> ScalingSearch::unexpected(const ScalingResult &scaled) const
{
    if (std::find(active_.begin(), active_.end(), false) == active_.end())
        return std::nullopt;
    const PoseRules rules(problem_);
    for (std::size_t p = 0; p < scaled.poses(); ++p)
        for (std::size_t i = 0; i + 1 < scaled.stride; ++i)
        {
            const int section = rules.blockingSection(scaled.pose(p)[i], scaled.pose(p)[i + 1]);
            if (section >= 0 && !active_[static_cast<std::size_t>(section)])
                return static_cast<std::size_t>(section);
        }
    return std::nullopt;
}

void ScalingSearch::layTips(const std::vector<bool> &longer, ScaledWay &way) const
{
    way.tips = {waypoints_[0]};
    for (std::size_t i = 0; i < routes_->legs(); ++i)
    {
        const std::vector<Vector2d> corners = routes_->leg(i, longer);
        const double retraction = corners.size() > 2 ? settings_.retraction : 0.0;
        appendLeg(corners, waypoints_[i + 1].x(), settings_.step, retraction, way.tips);
        way.waypoints.push_back(way.tips.size() - 1);
    }
}

ScaledWay ScalingSearch::scale(const std::vector<bool> &longer, const std::function<bool()> &interrupted) const
{
    ScaledWay way;
    way.margin = margins_[margin_].all;
    way.longer = longer;
    way.fault = routes_->fault();
    if (way.fault)
        return way;
    layTips(longer, way);
    ScalingOptions options;
    options.mode = settings_.mode;
    options.margin = way.margin;
    options.margins = margins_[margin_].joints;
    options.behind = margins_[margin_].behind;
    options.maxJump = settings_.maxJump;
    options.easing = settings_.easing;
    options.wrapping = project(start_);
    options.lateStart = waypoints_.size() == 2;  // no place but the last one matters
    options.interrupt = interrupted;
    way.scaled = scalePath(considered_, way.tips, options);
    way.fault = way.scaled.fault;
    return way;
}
}  // namespace narrows
