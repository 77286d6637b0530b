// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/LinkGaps.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "kernel/LinkTerm.h"
#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d inSpace(const Vector2d &point)
{
    return {point.x(), point.y(), 0.0};
}
}  // namespace

LinkGaps::LinkGaps(const PlanarArm &arm, std::shared_ptr<const GapEquations> fixed, double widest)
  : arm_(arm), fixed_(std::move(fixed)), widest_(widest)
{
    if (!fixed_ || !(widest > 0.0))
        throw std::invalid_argument("gaps between links need the fixed ones and a positive greatest width");
    for (int first = 0; first < arm_.linkCount(); ++first)
        for (int second = first + 1; second < arm_.linkCount(); ++second)
            if (!arm_.areNeighbours(first, second))
                pairs_.emplace_back(first, second);
}

const LinkGaps::Points &LinkGaps::placed(const Configuration &q) const
{
    static thread_local Points points;
    arm_.place(q, points);
    return points;
}

Gap LinkGaps::gapOf(const Points &points, std::size_t pair) const
{
    const auto end = [&](int link, bool tip) -> const Vector2d &
    {
        return points[static_cast<std::size_t>((tip ? link : arm_.links()[static_cast<std::size_t>(link)].parent) + 1)];
    };
    const auto [first, second] = pairs_[pair];
    const Vector2d &a = end(first, false), &b = end(first, true), &c = end(second, false), &d = end(second, true);
    const ClosestFractions closest = closestFractions(inSpace(a), inSpace(b), inSpace(c), inSpace(d));
    const Vector2d one = a + closest.first * (b - a), other = c + closest.second * (d - c), apart = other - one;
    const double distance = apart.norm();
    const Vector2d axis = distance > 0.0 ? Vector2d(apart / distance) : Vector2d(Vector2d::UnitX());
    const double shorter = std::min((b - a).norm(), (d - c).norm());
    // The links of the gap are as thick as the one between them.
    return {0.5 * (one + other), axis, 0.5 * distance - 2.0 * arm_.radius(), std::max(arm_.radius(), 0.25 * shorter)};
}

bool LinkGaps::areFar(const Points &points, std::size_t pair) const
{
    const auto middle = [&](int link) -> Vector2d
    {
        const int parent = arm_.links()[static_cast<std::size_t>(link)].parent;
        return 0.5 * (points[static_cast<std::size_t>(parent + 1)] + points[static_cast<std::size_t>(link + 1)]);
    };
    const auto [first, second] = pairs_[pair];
    const double lengths =
        arm_.links()[static_cast<std::size_t>(first)].length + arm_.links()[static_cast<std::size_t>(second)].length;
    const double near = 0.5 * lengths + 2.0 * (widest_ + 2.0 * arm_.radius());
    return (middle(first) - middle(second)).squaredNorm() > near * near;
}

double LinkGaps::halfWidth(const Configuration &q, const GapCrossing &crossing) const
{
    return isFixed(crossing) ? fixed_->halfWidth(q, crossing)
                             : std::max(gapOf(placed(q), pairOf(crossing)).halfWidth, 0.0);
}

double LinkGaps::size(const GapCrossing &crossing) const
{
    if (isFixed(crossing))
        return fixed_->size(crossing);
    const auto [first, second] = pairs_[pairOf(crossing)];
    const auto length = [&](int link)
    {
        return arm_.links()[static_cast<std::size_t>(link)].length;
    };
    return std::max(arm_.radius(), 0.25 * std::min(length(first), length(second)));
}

void LinkGaps::crossings(const Configuration &q, double lengthening, std::vector<GapCrossing> &result) const
{
    fixed_->crossings(q, lengthening, result);
    const Points &points = placed(q);
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair)
    {
        if (areFar(points, pair))
            continue;
        const Gap gap = gapOf(points, pair);
        if (!(gap.halfWidth > 0.0) || gap.halfWidth >= widest_)
            continue;
        for (int link = 0; link < arm_.linkCount(); ++link)
        {
            // What meets one of the two at a joint need not keep away from it.
            const auto [first, second] = pairs_[pair];
            if (link == first || link == second || arm_.areNeighbours(link, first) || arm_.areNeighbours(link, second))
                continue;
            const Vector2d &base =
                points[static_cast<std::size_t>(arm_.links()[static_cast<std::size_t>(link)].parent + 1)];
            if (crossesGap(base, points[static_cast<std::size_t>(link + 1)], gap, lengthening, gap.size))
                result.push_back({link, fixed_->gapCount() + static_cast<int>(pair), true});
        }
    }
}

Vector2d LinkGaps::valuesOf(const Points &points, const GapCrossing &crossing) const
{
    const Gap gap = gapOf(points, pairOf(crossing));
    const PlanarLink &link = arm_.links()[static_cast<std::size_t>(crossing.link)];
    const Vector2d &base = points[static_cast<std::size_t>(link.parent + 1)];
    const Vector2d along = (points[static_cast<std::size_t>(crossing.link + 1)] - base) / link.length;
    return {Vector2d(-along.y(), along.x()).dot(gap.middle - base), along.dot(gap.axis)};
}

void LinkGaps::evaluateMoving(const Points &points, const GapCrossing &crossing, Eigen::Index row,
                              Eigen::VectorXd &values, Eigen::MatrixXd &transposedJacobian) const
{
    const Eigen::Index count = crossing.square ? 2 : 1;
    values.segment(row, count) = valuesOf(points, crossing).head(count);
    constexpr double h = 1e-6;
    static thread_local Points moved, carried;
    static thread_local std::array<std::vector<LinkForce>, 2> forces;  // of F1 and F2
    static thread_local Eigen::VectorXd gradient;
    moved = points;
    for (std::vector<LinkForce> &ofRow : forces)
        ofRow.assign(arm_.links().size(), {});
    const auto [first, second] = pairs_[pairOf(crossing)];
    for (const int link : {crossing.link, first, second})
        for (const bool isTip : {false, true})
        {
            const int parent = arm_.links()[static_cast<std::size_t>(link)].parent;
            Vector2d &point = moved[static_cast<std::size_t>((isTip ? link : parent) + 1)];
            const Vector2d place = point;
            Eigen::Matrix2d slopes;  // a row of F each
            for (int axis = 0; axis < 2; ++axis)
            {
                point[axis] = place[axis] + h;
                const Vector2d after = valuesOf(moved, crossing);
                point[axis] = place[axis] - h;
                const Vector2d before = valuesOf(moved, crossing);
                point[axis] = place[axis];
                slopes.col(axis) = (after - before) / (2.0 * h);
            }
            for (std::size_t i = 0; i < forces.size(); ++i)
                forces[i][static_cast<std::size_t>(link)].push(isTip ? 1.0 : 0.0, slopes.row(i).transpose());
        }
    for (Eigen::Index i = 0; i < count; ++i)
    {
        gatherGradient(arm_, points, forces[static_cast<std::size_t>(i)], carried, gradient);
        transposedJacobian.col(row + i) = gradient;
    }
}

void LinkGaps::evaluate(const Configuration &q, const std::vector<GapCrossing> &crossings, Eigen::VectorXd &values,
                        Eigen::MatrixXd &transposedJacobian) const
{
    const Eigen::Index rows = rowCount(crossings);
    values.resize(rows);
    transposedJacobian.resize(arm_.dimension(), rows);
    // One question for all fixed ones, in memory that is kept.
    static thread_local std::vector<GapCrossing> fixed;
    static thread_local Eigen::VectorXd fixedValues;
    static thread_local Eigen::MatrixXd fixedJacobian;
    fixed.clear();
    std::copy_if(crossings.begin(), crossings.end(), std::back_inserter(fixed),
                 [this](const GapCrossing &crossing) { return isFixed(crossing); });
    if (!fixed.empty())
        fixed_->evaluate(q, fixed, fixedValues, fixedJacobian);
    const Points &points = placed(q);
    Eigen::Index row = 0, fixedRow = 0;
    for (const GapCrossing &crossing : crossings)
    {
        const Eigen::Index count = crossing.square ? 2 : 1;
        if (isFixed(crossing))
        {
            for (Eigen::Index i = 0; i < count; ++i, ++fixedRow)
            {
                values[row + i] = fixedValues[fixedRow];
                transposedJacobian.col(row + i) = fixedJacobian.col(fixedRow);
            }
        }
        else
            evaluateMoving(points, crossing, row, values, transposedJacobian);
        row += count;
    }
}
}  // namespace narrows
