// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>

#include "kernel/SpatialArm.h"

namespace narrows
{
/// Robots that between them have every feature of `SpatialArm`, for tests.

/// A snake of four links on a slide, with limited bends.
inline SpatialArm snake()
{
    return universalChain({0.1, -0.2, 0.3}, {0.5, 0.4, 0.6, 0.3}, 0.05,
                          std::make_pair(Eigen::Vector3d(0.6, 0.8, 0.0), Interval{-1.0, 2.0}), 0.75);
}

/// A six-joint arm with offsets at the shoulder and a spherical wrist.
inline SpatialArm sixAxisArm()
{
    const double right = std::acos(0.0);
    Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
    base.translation() << 0.2, 0.1, -0.4;
    base.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0));
    return denavitHartenbergArm(base, {{0.0, 0.45, 0.15, right, Interval{-2.9, 2.9}, 0.06},
                                       {right, 0.0, 0.6, 0.0, Interval{-2.0, 2.0}, 0.05},
                                       {0.0, 0.0, 0.12, right, Interval{-2.5, 2.5}, 0.05},
                                       {0.0, 0.62, 0.0, -right, std::nullopt, 0.04},
                                       {0.0, 0.0, 0.0, right, Interval{-2.0, 2.0}, 0.04},
                                       {0.0, 0.1, 0.0, 0.0, std::nullopt, 0.03}});
}

/// A gantry of two slides with a hand of two fingers that branch, a ball at one tip and a post fixed to the world.
inline SpatialArm gantryHand()
{
    using Kind = SpatialJoint::Kind;
    const auto shift = [](double x, double y, double z)
    {
        return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
    };
    Eigen::Isometry3d tilted = shift(0.2, 0.0, 0.1);
    tilted.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()));
    return SpatialArm({{Kind::Prismatic, -1, tilted, Eigen::Vector3d::UnitX(), Interval{-1.0, 1.0}},
                       {Kind::Prismatic, 0, shift(0.0, 0.1, 0.0), Eigen::Vector3d::UnitY(), Interval{-1.0, 1.0}},
                       {Kind::Revolute, 1, tilted, Eigen::Vector3d(0.0, 0.6, 0.8), std::nullopt},
                       {Kind::Revolute, 2, shift(0.4, 0.0, 0.0), Eigen::Vector3d::UnitZ(), Interval{-1.5, 1.5}},
                       {Kind::Revolute, 2, shift(0.4, 0.0, 0.0), Eigen::Vector3d::UnitZ(), Interval{-1.5, 1.5}}},
                      {{2, {0.0, 0.0, 0.0}, {0.4, 0.0, 0.0}, 0.03},
                       {3, {0.0, 0.0, 0.0}, {0.3, 0.1, 0.0}, 0.02},
                       {4, {0.0, 0.0, 0.0}, {0.3, -0.1, 0.1}, 0.0},
                       {4, {0.3, -0.1, 0.1}, {0.3, -0.1, 0.1}, 0.05},
                       {-1, {0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, 0.1}});
}

inline Eigen::VectorXd randomVector(int size, double range, std::mt19937 &generator)
{
    std::uniform_real_distribution<double> uniform(-range, range);
    Eigen::VectorXd q(size);
    for (double &value : q)
        value = uniform(generator);
    return q;
}
}  // namespace narrows
