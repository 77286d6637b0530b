// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarModel.h"
#include "validity/Confinement.h"

namespace narrows
{
/// A chain of links in the plane from the origin among obstacles, and a task for it: what the planar families draw.
/// Configurations are [slide,] absolute angles; joints turn freely.
struct ArmScene
{
    std::vector<double> lengths;
    std::vector<PlanarObstacle> obstacles;
    Eigen::VectorXd start;
    Eigen::VectorXd goal;
    std::vector<Eigen::VectorXd> witness;  ///< waypoints of a free path from start to goal; empty if none is known
    std::optional<Slide> slide = std::nullopt;
    double radius = 0.0;                                     ///< half-width of the links
    AngleConvention convention = AngleConvention::Absolute;  ///< how the file counts angles
    bool selfCollision = false;
    std::optional<Confinement> infeasible = std::nullopt;  ///< a proof that there is no way, if one is known
};

/// To so many decimals (<= 12). Files hold rounded numbers, so that the last bits of a machine's sine do not show.
double rounded(double value, int decimals);
Eigen::Vector2d rounded(const Eigen::Vector2d &point, int decimals);

/// Lengths of the pieces when rods are cut into `count` >= rods pieces in all, as evenly as can be, later rods into
/// more.
std::vector<double> cut(const std::vector<double> &rods, int count);

/// Adds an obstacle under a name of its own: C, E or P for its kind, and its number.
void addObstacle(ArmScene &scene, std::variant<Circle, Superellipse, Polygon> shape);

PlanarModel modelOf(const ArmScene &scene);

/// Least distance of any link to what it must not touch, negative or zero if something touches; +infinity if there is
/// nothing to touch.
double clearance(const ArmScene &scene, const Eigen::VectorXd &q);

enum class Motion
{
    Free,
    Blocked,
    Undecided  ///< it comes too close to tell
};

/// The motion along straight lines between configurations, judged by the verifier.
Motion judgePath(const ArmScene &scene, const std::vector<Eigen::VectorXd> &path);
Motion judgeMotion(const ArmScene &scene, const Eigen::VectorXd &from, const Eigen::VectorXd &to);

/// The scenario file of the scene.
std::string toYaml(const ArmScene &scene, const std::string &name, const std::string &source);
}  // namespace narrows
