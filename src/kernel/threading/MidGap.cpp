// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/MidGap.h"

#include <algorithm>
#include <cmath>

#include "kernel/Cross.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

const std::vector<Vector2d> &placed(const PlanarArm &arm, const GapEquations::Configuration &q)
{
    static thread_local std::vector<Vector2d> points;
    arm.place(q, points);
    return points;
}
}  // namespace

MidGap::MidGap(const PlanarArm &arm, std::vector<Gap> gaps) : arm_(arm), gaps_(std::move(gaps)), largestSize_(0.0)
{
    for (const PlanarLink &link : arm_.links())
        largestSize_ = std::max(largestSize_, 0.5 * link.length);
}

bool crossesGap(const Vector2d &base, const Vector2d &tip, const Gap &gap, double lengthening, double largestSize)
{
    // base + s along = middle + t axis
    const Vector2d along = tip - base, apart = gap.middle - base;
    const double determinant = cross(along, gap.axis), length = along.norm();
    if (std::abs(determinant) < leastSquareness * length)
        return false;
    const double size = std::min(gap.size, largestSize);
    const double t = cross(apart, along) / determinant;
    if (std::abs(t) > gap.halfWidth + throatPart * size)
        return false;
    const double s = cross(apart, gap.axis) / determinant, extra = lengthening * size / length;
    return s >= -extra && s <= 1.0 + extra;
}

void MidGap::crossings(const Configuration &q, double lengthening, std::vector<GapCrossing> &result) const
{
    crossings(placed(arm_, q), lengthening, result);
}

void MidGap::evaluate(const Configuration &q, const std::vector<GapCrossing> &crossings, Eigen::VectorXd &values,
                      Eigen::MatrixXd &transposedJacobian) const
{
    evaluate(placed(arm_, q), crossings, values, transposedJacobian);
}

void MidGap::crossings(const std::vector<Vector2d> &points, double lengthening, std::vector<GapCrossing> &result) const
{
    result.clear();
    for (int link = 0; link < arm_.linkCount(); ++link)
    {
        const Vector2d &base = points[static_cast<std::size_t>(arm_.links()[link].parent + 1)];
        const Vector2d &tip = points[static_cast<std::size_t>(link + 1)];
        for (std::size_t gap = 0; gap < gaps_.size(); ++gap)
            if (crossesGap(base, tip, gaps_[gap], lengthening, largestSize_))
                result.push_back({link, static_cast<int>(gap), true});
    }
}

void MidGap::evaluate(const std::vector<Vector2d> &points, const std::vector<GapCrossing> &crossings,
                      Eigen::VectorXd &values, Eigen::MatrixXd &transposedJacobian) const
{
    const Eigen::Index rows = rowCount(crossings);
    values.resize(rows);
    transposedJacobian.setZero(arm_.dimension(), rows);
    Eigen::Index row = 0;
    for (const GapCrossing &crossing : crossings)
    {
        const Gap &gap = gapOf(crossing);
        const PlanarLink &link = arm_.links()[static_cast<std::size_t>(crossing.link)];
        const Vector2d &base = points[static_cast<std::size_t>(link.parent + 1)];
        const Vector2d along = (points[static_cast<std::size_t>(crossing.link + 1)] - base) / link.length;
        const Vector2d normal(-along.y(), along.x());
        const int joint = arm_.firstAngle() + crossing.link;
        values[row] = normal.dot(gap.middle - base);
        transposedJacobian(joint, row) = -along.dot(gap.middle - base);
        // Turning a link that carries this one shifts the base square to that link.
        for (int carrier = link.parent; carrier >= 0; carrier = arm_.links()[carrier].parent)
        {
            const Vector2d &from = points[static_cast<std::size_t>(arm_.links()[carrier].parent + 1)];
            const Vector2d arm = points[static_cast<std::size_t>(carrier + 1)] - from;
            transposedJacobian(arm_.firstAngle() + carrier, row) = normal.x() * arm.y() - normal.y() * arm.x();
        }
        if (arm_.slide())
            transposedJacobian(0, row) = -normal.dot(arm_.slide()->axis);
        ++row;
        if (!crossing.square)
            continue;
        values[row] = along.dot(gap.axis);
        transposedJacobian(joint, row) = normal.dot(gap.axis);
        ++row;
    }
}
}  // namespace narrows
