// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialNeighbours.h"

#include <algorithm>

#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

constexpr double coincidence = 1e-9;  // of the arm's reach: what counts as the same place

/// The joints between the bodies that two joints move, in no particular order.
std::vector<int> jointsBetween(const SpatialArm &arm, int one, int other)
{
    std::vector<int> between;
    while (one != other)
    {
        // The later one cannot be an ancestor of the earlier one.
        int &later = one > other ? one : other;
        between.push_back(later);
        later = arm.joints()[later].parent;
    }
    return between;
}

/// What the joints between two links leave in place in both: everything, a line, a point, or nothing.
class FixedSet
{
public:
    bool isEmpty() const { return kind_ == Kind::Nothing; }

    void turnAbout(const Vector3d &origin, const Vector3d &axis, double tolerance)
    {
        switch (kind_)
        {
            case Kind::Everything:
                kind_ = Kind::Line;
                origin_ = origin;
                axis_ = axis;
                return;
            case Kind::Line:
                meetLine(origin, axis, tolerance);
                return;
            case Kind::Point:
                if (axis.cross(origin_ - origin).norm() > tolerance)
                    kind_ = Kind::Nothing;
                return;
            case Kind::Nothing:
                return;
        }
    }

    /// Whether some point of the set belongs to both links.
    template <class Excess>
    bool isShared(const Excess &excess, double span, double tolerance) const
    {
        if (kind_ != Kind::Line)
            return kind_ == Kind::Everything || excess(origin_) <= tolerance;
        // How far a point is outside of the farther link: convex along the line.
        double low = -span, high = span;
        for (int i = 0; i < 200; ++i)
        {
            const double left = low + (high - low) / 3.0, right = high - (high - low) / 3.0;
            if (excess(origin_ + left * axis_) <= excess(origin_ + right * axis_))
                high = right;
            else
                low = left;
        }
        return excess(origin_ + 0.5 * (low + high) * axis_) <= tolerance;
    }

private:
    enum class Kind
    {
        Everything,
        Line,
        Point,
        Nothing
    };

    void meetLine(const Vector3d &origin, const Vector3d &axis, double tolerance)
    {
        const Vector3d across = axis_.cross(axis);
        const Vector3d between = origin - origin_;
        if (across.norm() < 1e-9)  // parallel: the same line, or no common point
        {
            if (axis_.cross(between).norm() > tolerance)
                kind_ = Kind::Nothing;
            return;
        }
        origin_ += between.cross(axis).dot(across) / across.squaredNorm() * axis_;
        kind_ = axis.cross(origin_ - origin).norm() <= tolerance ? Kind::Point : Kind::Nothing;
    }

    Kind kind_ = Kind::Everything;
    Vector3d origin_ = Vector3d::Zero();
    Vector3d axis_ = Vector3d::Zero();
};

/// Joints that leave a common point in place leave it there at every configuration, so that looking at one is enough.
bool meet(const SpatialArm &arm, const SpatialArm::Placement &atZero, int one, int other)
{
    const double tolerance = coincidence * arm.reach();
    FixedSet fixed;
    for (const int joint : jointsBetween(arm, arm.links()[one].joint, arm.links()[other].joint))
    {
        if (arm.joints()[joint].kind == SpatialJoint::Kind::Prismatic)
            return false;
        const Eigen::Isometry3d &frame = atZero.frames[joint];
        fixed.turnAbout(frame.translation(), frame.linear() * arm.joints()[joint].axis, tolerance);
    }
    if (fixed.isEmpty())
        return false;
    const auto outside = [&](int link, const Vector3d &point)
    {
        return nearness(atZero.points[2 * link], atZero.points[2 * link + 1], Sphere{point, arm.links()[link].radius})
            .distance;
    };
    const auto excess = [&](const Vector3d &point)
    {
        return std::max(outside(one, point), outside(other, point));
    };
    return fixed.isShared(excess, 4.0 * arm.reach(), tolerance);
}
}  // namespace

std::vector<bool> findNeighbours(const SpatialArm &arm, const SpatialArm::Placement &atZero)
{
    const int count = arm.linkCount();
    std::vector<bool> neighbours(static_cast<std::size_t>(count) * count);
    for (int one = 0; one < count; ++one)
        for (int other = 0; other <= one; ++other)
            neighbours[one * count + other] = neighbours[other * count + one] = meet(arm, atZero, one, other);
    return neighbours;
}
}  // namespace narrows
