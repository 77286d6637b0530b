// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "kernel/PlanarModel.h"
#include "kernel/SpatialModel.h"
#include "validity/ArmChecker.h"
#include "validity/Verifier.h"

namespace narrows
{
/// A robot in the plane, its obstacles and its task.
struct PlanarWorld
{
    std::shared_ptr<const PlanarModel> model;                ///< robot and obstacles; never null
    PlanarTask task;                                         ///< absolute angles, whatever the file uses
    AngleConvention convention = AngleConvention::Absolute;  ///< how the file writes its angles
};

/// A robot in space, its obstacles and its task. Files write joint values as the kernel counts them.
struct SpatialWorld
{
    std::shared_ptr<const SpatialModel> model;  ///< robot and obstacles; never null
    SpatialTask task;                           ///< start and goal
};

/// What a scenario is about, in the plane or in space.
using World = std::variant<PlanarWorld, SpatialWorld>;

/// Number of joints.
int dimensionOf(const World &world);

///@{
/// A configuration from the values of a file that belongs to the world (a path, a database), and back.
Eigen::VectorXd fromFile(const World &world, ConfigurationRef row);
Eigen::VectorXd toFile(const World &world, ConfigurationRef q);
///@}

/// How far any point of the robot can get over a motion of its configuration, at most.
double longestWay(const World &world, ConfigurationRef delta);

/// A checker of the world's robot among its obstacles, by its name. \throws std::invalid_argument as for the model
std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const World &world);

/// Judges a path by the verifier for the world's model and task.
/// \param world is what is to be solved \param path configurations, unwrapped \param options of the verifier
Verdict verify(const World &world, const std::vector<Eigen::VectorXd> &path, const VerifierOptions &options = {});
}  // namespace narrows
