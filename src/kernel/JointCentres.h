// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kernel/PlanarArm.h"
#include "kernel/SpatialArm.h"

namespace narrows
{
/// What defines a universalChain() on a slide: the hyper-redundant manipulator of VDSM (Machines 10 (2022) 1030).
///
/// Its joint centres are O_1 .. O_{n+1}: O_1 moves along the slide, O_{i+1} ends link i (the paper's numbers; vectors
/// of centres begin with O_1), so that O_{n+1} is the tip. At zero all links point along x.
struct ChainGeometry
{
    Eigen::Vector3d origin;       ///< O_1 where the slide's value is 0
    Eigen::Matrix3d axes;         ///< right-handed; columns: the slide's direction, two normals of it (y, z if it is x)
    std::vector<double> lengths;  ///< L_1 .. L_n, > 0
    double radius;                ///< of all links
    double maxAngle;              ///< largest bend psi of every joint, below pi / 2; infinity without a limit
    Interval slide;               ///< permitted values of the slide
};

/// The geometry if the arm is such a chain (of at least one link), nothing if it is any other arm.
std::optional<ChainGeometry> chainGeometry(const SpatialArm &arm);

/// Where O_1 .. O_{n+1} are, by the arm's own forward kinematics.
/// \pre the arm is a universalChain, with or without a slide
void jointCentres(const SpatialArm &arm, ConfigurationRef q, std::vector<Eigen::Vector3d> &centres);

/// The joint values (slide, pitch 1, yaw 1, ...) that put the joint centres there: the inverse kinematics of Section
/// 5.1, Eq. 11-15, in closed form. The paper turns every joint by yaw first and pitch second, this chain by pitch first
/// and yaw second; centres and bends are the same. Of a link at right angles to its joint's pitch circle, whose pitch
/// is arbitrary, it is 0. Limits are not looked at: that is a checker's business.
///
/// \return false, and `values` is as it was, if the number of centres is not n + 1, O_1 is off the slide's line, two
/// neighbours are not the link's length apart (both within 1e-9 of all lengths together), or a number is not finite
bool valuesFromCentres(const ChainGeometry &chain, const std::vector<Eigen::Vector3d> &centres,
                       Eigen::VectorXd &values);

/// The same for an arm. Costs more than the rest: who asks often keeps the ChainGeometry.
/// \throws std::invalid_argument if the arm has no ChainGeometry
bool valuesFromCentres(const SpatialArm &arm, const std::vector<Eigen::Vector3d> &centres, Eigen::VectorXd &values);

/// Bend of a universal joint: psi = acos(cos(pitch) cos(yaw)) (Eq. 2), in [0, pi], exact for small angles too.
double bendAngle(double pitch, double yaw);
}  // namespace narrows
