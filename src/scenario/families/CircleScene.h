// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// A chain of links from the origin among circles, and a task for it: what the families draw. Angles are absolute.
struct CircleScene
{
    std::vector<double> lengths;
    std::vector<Circle> circles;
    Eigen::VectorXd start;
    Eigen::VectorXd goal;
    std::vector<Eigen::VectorXd> witness;  ///< waypoints of a free path from start to goal; empty if none is known
};

/// To so many decimals (<= 12). Files hold rounded numbers, so that the last bits of a machine's sine do not show.
double rounded(double value, int decimals);

/// Lengths of the pieces when rods are cut into `count` >= rods pieces in all, as evenly as can be, later rods into
/// more.
std::vector<double> cut(const std::vector<double> &rods, int count);

PlanarModel modelOf(const CircleScene &scene);

/// Least distance of links `first`, first + 1, ... to the circles; +infinity without circles.
double clearance(const CircleScene &scene, const Eigen::VectorXd &q, int first = 0);

enum class Motion
{
    Free,
    Blocked,
    Undecided  ///< it comes too close to tell
};

/// The straight motion between two configurations, judged by the verifier.
Motion judgeMotion(const CircleScene &scene, const Eigen::VectorXd &from, const Eigen::VectorXd &to);

/// The scenario file of the scene.
std::string toYaml(const CircleScene &scene, const std::string &name, const std::string &source);
}  // namespace narrows
