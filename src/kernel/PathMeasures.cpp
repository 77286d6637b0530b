// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PathMeasures.h"

#include <algorithm>
#include <cmath>

#include "kernel/JointCentres.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double moved = 1e-6;  // radians
constexpr int looks = 8;        // per motion

class Tip
{
public:
    Tip(const SpatialArm &arm, int link) : arm_(arm), link_(link) {}

    Vector3d at(ConfigurationRef q)
    {
        arm_.place(q, placement_);
        return placement_.points[2 * link_ + 1];
    }

private:
    const SpatialArm &arm_;
    int link_;
    SpatialArm::Placement placement_;
};

double distanceToSegment(const Vector3d &point, const Vector3d &from, const Vector3d &to)
{
    const Vector3d along = to - from;
    const double square = along.squaredNorm();
    const double share = square > 0.0 ? std::clamp(along.dot(point - from) / square, 0.0, 1.0) : 0.0;
    return (point - from - share * along).norm();
}

int linkOf(const SpatialArm &arm, const SpatialTask &task)
{
    if (const auto *tip = std::get_if<SpatialTipGoal>(&task.goal))
        return tip->link;
    if (const auto *tips = std::get_if<SpatialTipPath>(&task.goal))
        return tips->link;
    return arm.linkCount() - 1;
}

double largestBendOf(const SpatialArm &arm, const std::vector<VectorXd> &path)
{
    // What bends by at most some angle below pi / 2 is a convex set of angles: no motion bends more than both its ends.
    double largest = 0.0;
    for (const VectorXd &q : path)
        for (const UniversalLimit &joint : arm.universalLimits())
            largest = std::max(largest, bendAngle(q[joint.first], q[joint.second]));
    return largest;
}

/// Largest change of a joint from one configuration to another; 0 for joints that do not turn.
VectorXd turnsBetween(const SpatialArm &arm, ConfigurationRef from, ConfigurationRef to)
{
    VectorXd turns = (to - from).cwiseAbs();
    for (int i = 0; i < arm.dimension(); ++i)
        if (arm.joints()[i].kind != SpatialJoint::Kind::Revolute)
            turns[i] = 0.0;
    return turns;
}

int movedJointsOf(const SpatialArm &arm, const std::vector<VectorXd> &path)
{
    VectorXd most = VectorXd::Zero(arm.dimension());
    for (const VectorXd &q : path)
        most = most.cwiseMax(turnsBetween(arm, path.front(), q));
    return static_cast<int>((most.array() > moved).count());
}

double tipDeviationOf(Tip tip, const SpatialTipPath &tips, const std::vector<VectorXd> &path)
{
    double largest = 0.0;
    std::size_t next = 0;
    Vector3d from = tip.at(path.front());
    const auto passPoints = [&](const Vector3d &at)
    {
        while (next < tips.points.size() && (at - tips.points[next]).norm() <= tips.tolerance)
            from = tips.points[next++];
    };
    passPoints(from);
    for (std::size_t i = 1; i < path.size(); ++i)
    {
        const Vector3d &to = tips.points[std::min(next, tips.points.size() - 1)];
        for (int look = 1; look <= looks; ++look)
            largest = std::max(
                largest, distanceToSegment(tip.at(path[i - 1] + (path[i] - path[i - 1]) * look / looks), from, to));
        passPoints(tip.at(path[i]));
    }
    return largest;
}
}  // namespace

PathMeasures measurePath(const SpatialArm &arm, const SpatialTask &task, const std::vector<VectorXd> &path)
{
    PathMeasures measures;
    if (!arm.universalLimits().empty())
        measures.largestBend = largestBendOf(arm, path);
    measures.movedJoints = movedJointsOf(arm, path);
    Tip tip(arm, linkOf(arm, task));
    const Vector3d start = tip.at(path.front());
    Vector3d last = start;
    for (const VectorXd &q : path)
    {
        const Vector3d at = tip.at(q);
        measures.tipLength += (at - last).norm();
        last = at;
    }
    if (const auto *tips = std::get_if<SpatialTipPath>(&task.goal))
    {
        measures.tipDeviation = tipDeviationOf(tip, *tips, path);
        if ((tips->points.back() - start).norm() <= tips->tolerance)
            measures.closure = turnsBetween(arm, path.front(), path.back()).maxCoeff();
    }
    return measures;
}
}  // namespace narrows
