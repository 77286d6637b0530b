// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "kernel/SpatialDistance.h"

namespace narrows
{
/// The derivative of some function of where a link lies, by the two ends of its segment.
struct EndForces
{
    Eigen::Vector3d a = Eigen::Vector3d::Zero();  ///< by the base
    Eigen::Vector3d b = Eigen::Vector3d::Zero();  ///< by the tip

    /// The function's derivative has this part by the point at `fraction` of the way from a to b.
    void push(double fraction, const Eigen::Vector3d &part)
    {
        a += (1.0 - fraction) * part;
        b += fraction * part;
    }
    /// Adds the derivative of another function times a constant.
    void add(double factor, const EndForces &other)
    {
        a += factor * other.a;
        b += factor * other.b;
    }
};

/// A function of where a link lies, and its derivative.
struct SpatialTerm
{
    double value = 0.0;  ///< of the function
    EndForces slope;     ///< its derivative
};

/// Distance of a link's surface from a shape.
inline SpatialTerm clearanceOf(const Nearness &near, double linkRadius)
{
    SpatialTerm term{near.distance - linkRadius, {}};
    term.slope.push(near.fraction, near.normal);
    return term;
}

/// The derivative by the joints of a function whose derivatives by the links are `forces`, one for each link.
void gatherGradient(const SpatialArm &arm, const SpatialArm::Placement &placement, const std::vector<EndForces> &forces,
                    Eigen::VectorXd &gradient);
}  // namespace narrows
