// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "kernel/Repulsion.h"

namespace narrows
{
/// All that the homotopy needs to know of a robot that this library has never heard of: balls that move with it, by the
/// positions of their centers and the derivatives of these. The robot should lie within its balls.
struct ControlPoints
{
    int dimension;              ///< joints
    int workspace;              ///< coordinates of a point, e.g. 2 or 3
    std::vector<double> radii;  ///< of the balls, >= 0, one each

    /// Sets points to the centers at q, workspace x number of balls, and, unless null, jacobians[k] to the derivative
    /// of center k, workspace x dimension. Both come in the right sizes. Must be once continuously differentiable and
    /// safe to call from several threads.
    std::function<void(const Eigen::Ref<const Eigen::VectorXd> &q, Eigen::MatrixXd &points,
                       std::vector<Eigen::MatrixXd> *jacobians)>
        place;
};

/// A point that moves freely: its coordinates are its joints.
/// \param coordinates of the point, > 0 \param radius of a ball around it, >= 0
ControlPoints pointRobot(int coordinates, double radius = 0.0);

/// An obstacle, by a function that is positive outside, 0 on its boundary and negative inside: best its signed
/// distance.
struct DistanceFunction
{
    std::string name;  ///< unique
    /// The value at a point; unless null, `gradient` is set to its derivative there. It comes in the right size.
    std::function<double(const Eigen::Ref<const Eigen::VectorXd> &point, Eigen::VectorXd *gradient)> value;
};

/// Poles of such a robot among such obstacles, for HPPM: one group per obstacle, in it one pole C = value - radius per
/// ball, W = sum of P / C. points() is the same: control points are what the paper's singular points are.
/// \param length a distance that is ordinary between robot and obstacles, > 0: naturalStrength() of all groups
/// \throws std::invalid_argument if a number or a function is missing or out of range, or two obstacles share a name
std::shared_ptr<const RepulsionModel> controlPointModel(ControlPoints robot, std::vector<DistanceFunction> obstacles,
                                                        double length);
}  // namespace narrows
