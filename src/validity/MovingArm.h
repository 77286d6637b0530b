// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/LinkMotion.h"
#include "kernel/PlanarArm.h"
#include "kernel/SpatialArm.h"
#include "kernel/BoxArrays.h"

namespace narrows
{
/// An arm on a straight motion through its joint space, link by link, for whoever does not care which kind of arm it
/// is. Keeps its memory from one motion to the next.
template <class Arm>
class MovingArm;

/// In the plane: all links have one radius, and each turns at its own constant rate.
template <>
class MovingArm<PlanarArm>
{
public:
    /// Puts the arm where it is at q; link() is valid afterwards.
    void rest(const PlanarArm &arm, ConfigurationRef q)
    {
        arm_ = &arm;
        arm.place(q, points_);
    }

    /// Chooses the motion q + t * delta; place() must follow.
    void begin(const PlanarArm &arm, ConfigurationRef q, ConfigurationRef delta)
    {
        arm_ = &arm;
        from_ = q;
        delta_ = delta;
        arm.motionBounds(delta_, ways_, bends_);
        baseWay_ = arm.slide() ? std::abs(delta_[0]) : 0.0;
    }

    /// Goes to a point of the motion; motion() is valid afterwards.
    void place(double t)
    {
        q_ = from_ + t * delta_;
        arm_->place(q_, points_);
        arm_->velocities(points_, delta_, velocities_);
    }

    /// Where a link is.
    Link<2> link(int i) const { return {points_[base(i)], points_[i + 1], arm_->radius()}; }

    /// The boxes around the links.
    void box(BoxArrays<2> &boxes) const
    {
        const int count = arm_->linkCount();
        const PlanarLink *links = arm_->links().data();
        const Eigen::Vector2d *points = points_.data();
        const double radius = arm_->radius();
        boxes.resize(count);
        for (int i = 0; i < count; ++i)
            boxes.set(i, points[links[i].parent + 1], points[i + 1], radius);
    }

    /// A link on a stretch around where the arm is, made `extra` thicker.
    LinkMotion<2> motion(int i, double half, double extra) const
    {
        return {point(base(i)), point(i + 1), arm_->radius() + extra, std::abs(delta_[arm_->firstAngle() + i]), half};
    }

private:
    int base(int link) const { return arm_->links()[link].parent + 1; }

    MovingPoint<2> point(int i) const
    {
        return {points_[i], velocities_[i], i > 0 ? ways_[i - 1] : baseWay_, i > 0 ? bends_[i - 1] : 0.0};
    }

    const PlanarArm *arm_ = nullptr;
    Eigen::VectorXd from_, delta_, ways_, bends_, q_;
    double baseWay_ = 0.0;
    std::vector<Eigen::Vector2d> points_, velocities_;
};

/// In space: members mean what they mean in the plane.
template <>
class MovingArm<SpatialArm>
{
public:
    /// Puts the arm where it is at q; link() is valid afterwards.
    void rest(const SpatialArm &arm, ConfigurationRef q)
    {
        arm_ = &arm;
        arm.place(q, placement_);
    }

    /// Chooses the motion q + t * delta; place() must follow.
    void begin(const SpatialArm &arm, ConfigurationRef q, ConfigurationRef delta)
    {
        arm_ = &arm;
        from_ = q;
        delta_ = delta;
        arm.motionBounds(delta_, ways_, bends_, turns_);
    }

    /// Goes to a point of the motion; motion() is valid afterwards.
    void place(double t)
    {
        q_ = from_ + t * delta_;
        arm_->place(q_, placement_);
        arm_->velocities(placement_, delta_, velocities_, spins_);
    }

    /// Where a link is.
    Link<3> link(int i) const
    {
        return {placement_.points[2 * i], placement_.points[2 * i + 1], arm_->links()[i].radius};
    }

    /// The boxes around the links.
    void box(BoxArrays<3> &boxes) const
    {
        boxes.resize(arm_->linkCount());
        for (int i = 0; i < arm_->linkCount(); ++i)
            boxes.set(i, placement_.points[2 * i], placement_.points[2 * i + 1], arm_->links()[i].radius);
    }

    /// A link on a stretch around where the arm is, made `extra` thicker.
    LinkMotion<3> motion(int i, double half, double extra) const
    {
        return {{placement_.points[2 * i], velocities_[2 * i], ways_[i], bends_[i]},
                {placement_.points[2 * i + 1], velocities_[2 * i + 1], ways_[i], bends_[i]},
                arm_->links()[i].radius + extra,
                turns_[i],
                half};
    }

private:
    const SpatialArm *arm_ = nullptr;
    Eigen::VectorXd from_, delta_, ways_, bends_, turns_, q_;
    SpatialArm::Placement placement_;
    std::vector<Eigen::Vector3d> velocities_, spins_;
};
}  // namespace narrows
