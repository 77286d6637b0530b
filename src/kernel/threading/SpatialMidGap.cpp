// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/SpatialMidGap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/SpatialBounds.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

constexpr double linkPart = 0.25;  ///< of a link's length, the least size of its gaps

/// A link as its line: base and direction.
struct Line
{
    Vector3d base;
    Vector3d direction;
};

/// A function of a line, and its derivatives.
struct LineTerm
{
    double value;
    Vector3d byBase;
    Vector3d byDirection;
};

/// F1 where the gap has a line.
LineTerm distanceFromLine(const Line &link, const SpatialGap &gap)
{
    const Vector3d across = link.direction.cross(gap.along), apart = gap.middle - link.base;
    const double norm = across.norm(), value = across.dot(apart) / norm;
    return {value, -across / norm, (gap.along.cross(apart) - value / norm * gap.along.cross(across)) / norm};
}

/// F1 where it has none.
LineTerm distanceFromMiddle(const Line &link, const SpatialGap &gap)
{
    const double slope = gap.axis.dot(link.direction);
    const Vector3d across = gap.axis - slope * link.direction, apart = gap.middle - link.base;
    const double norm = across.norm(), value = across.dot(apart) / norm;
    const Vector3d byDirection = -link.direction.dot(apart) * gap.axis - slope * apart + value / norm * slope * across;
    return {value, -across / norm, byDirection / norm};
}

/// By the ends of a link of that length.
EndForces byEnds(const LineTerm &term, const Vector3d &direction, double length)
{
    const Vector3d turning = (term.byDirection - direction.dot(term.byDirection) * direction) / length;
    return {term.byBase - turning, turning};
}

/// Derivatives by the configuration, one column after the other.
class Gatherer
{
public:
    Gatherer(const SpatialArm &arm, const SpatialArm::Placement &placement)
      : arm_(arm), placement_(placement), forces_(static_cast<std::size_t>(arm.linkCount()))
    {
    }

    void gather(int link, const EndForces &forces, Eigen::MatrixXd::ColXpr result)
    {
        forces_[static_cast<std::size_t>(link)] = forces;
        gatherGradient(arm_, placement_, forces_, gradient_);
        forces_[static_cast<std::size_t>(link)] = {};
        result = gradient_;
    }

private:
    const SpatialArm &arm_;
    const SpatialArm::Placement &placement_;
    std::vector<EndForces> forces_;
    Eigen::VectorXd gradient_;
};

double thinnestLink(const SpatialArm &arm)
{
    double thinnest = std::numeric_limits<double>::infinity();
    for (const SpatialLink &link : arm.links())
        thinnest = std::min(thinnest, link.radius);
    return thinnest;
}

const SpatialArm::Placement &placed(const SpatialArm &arm, const GapEquations::Configuration &q)
{
    static thread_local SpatialArm::Placement placement;
    arm.place(q, placement);
    return placement;
}
}  // namespace

SpatialMidGap::SpatialMidGap(const SpatialArm &arm, std::vector<SpatialGap> gaps) : arm_(arm), gaps_(std::move(gaps))
{
    for (const SpatialLink &link : arm_.links())
        lengths_.push_back((link.to - link.from).norm());
}

SpatialMidGap::SpatialMidGap(const SpatialModel &model, double widest)
  : SpatialMidGap(model.arm, findGaps(model.obstacles, thinnestLink(model.arm), widest, farthestFromOrigin(model.arm)))
{
}

double SpatialMidGap::roomOf(const GapCrossing &crossing) const
{
    return gapOf(crossing).halfDistance - arm_.links()[static_cast<std::size_t>(crossing.link)].radius;
}

double SpatialMidGap::size(const GapCrossing &crossing) const
{
    const double length = lengths_[static_cast<std::size_t>(crossing.link)];
    return std::max(std::min(gapOf(crossing).size, 0.5 * length), linkPart * length);
}

bool SpatialMidGap::crosses(const SpatialArm::Placement &placement, const GapCrossing &crossing,
                            double lengthening) const
{
    const auto link = static_cast<std::size_t>(crossing.link);
    const SpatialGap &gap = gapOf(crossing);
    const double length = lengths_[link], room = roomOf(crossing);
    if (!(length > 0.0) || !(room > 0.0))
        return false;
    const Vector3d &base = placement.points[2 * link];
    const Vector3d direction = (placement.points[2 * link + 1] - base) / length;
    const double slope = direction.dot(gap.axis);
    if (1.0 - slope * slope < leastSquareness * leastSquareness)
        return false;
    const bool isSlot = gap.halfLength > 0.0;
    const Vector3d along = isSlot ? gap.along : gap.axis.cross(direction).normalized();
    const Vector3d through = along.cross(gap.axis);
    const double speed = direction.dot(through);
    if (std::abs(speed) < leastSquareness)
        return false;
    const double way = through.dot(gap.middle - base) / speed, extent = size(crossing), extra = lengthening * extent;
    if (way < -extra || way > length + extra)
        return false;
    const Vector3d off = base + way * direction - gap.middle;
    const double slack = throatPart * extent;
    // Without a line the narrow part is as broad as it is thick.
    const double beside = isSlot ? gap.halfLength + slack : gap.size + slack;
    return std::abs(off.dot(gap.axis)) <= room + slack && std::abs(off.dot(along)) <= beside;
}

void SpatialMidGap::crossings(const Configuration &q, double lengthening, std::vector<GapCrossing> &result) const
{
    result.clear();
    const SpatialArm::Placement &placement = placed(arm_, q);
    for (int link = 0; link < arm_.linkCount(); ++link)
        for (int gap = 0; gap < gapCount(); ++gap)
            if (crosses(placement, {link, gap, true}, lengthening))
                result.push_back({link, gap, true});
}

void SpatialMidGap::evaluate(const Configuration &q, const std::vector<GapCrossing> &crossings, Eigen::VectorXd &values,
                             Eigen::MatrixXd &transposedJacobian) const
{
    const SpatialArm::Placement &placement = placed(arm_, q);
    Gatherer gatherer(arm_, placement);
    const Eigen::Index rows = rowCount(crossings);
    values.resize(rows);
    transposedJacobian.resize(arm_.dimension(), rows);
    Eigen::Index row = 0;
    for (const GapCrossing &crossing : crossings)
    {
        const auto link = static_cast<std::size_t>(crossing.link);
        const SpatialGap &gap = gapOf(crossing);
        const Vector3d &base = placement.points[2 * link];
        const Line line{base, (placement.points[2 * link + 1] - base) / lengths_[link]};
        const auto add = [&](const LineTerm &term)
        {
            values[row] = term.value;
            gatherer.gather(crossing.link, byEnds(term, line.direction, lengths_[link]), transposedJacobian.col(row));
            ++row;
        };
        add(gap.halfLength > 0.0 ? distanceFromLine(line, gap) : distanceFromMiddle(line, gap));
        if (crossing.square)
            add({line.direction.dot(gap.axis), Vector3d::Zero(), gap.axis});
    }
}
}  // namespace narrows
