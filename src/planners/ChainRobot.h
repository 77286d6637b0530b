// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "kernel/JointCentres.h"
#include "kernel/PlanarModel.h"
#include "kernel/SpatialModel.h"
#include "kernel/chain/ChainCertificate.h"
#include "kernel/chain/ChainMotion.h"
#include "spaces/PlanarArmStateSpace.h"
#include "spaces/SpatialArmStateSpace.h"

namespace narrows
{
/// A chain of equal links on a slide, in the plane or in space, as tight maneuvering wants it.
template <int D>
class ChainRobot
{
public:
    using Point = Eigen::Matrix<double, D, 1>;  ///< of the plane or of space
    /// robot and obstacles
    using Model = std::conditional_t<D == 2, PlanarModel, SpatialModel>;
    /// the states of the robot
    using Space = std::conditional_t<D == 2, PlanarArmStateSpace, SpatialArmStateSpace>;

    /// \pre whyNoChain() says nothing
    ChainRobot(const Model &model, const Space &space);

    const ChainSpec &spec() const { return spec_; }  ///< the chain alone
    const Point &axis() const { return axis_; }      ///< unit vector of the slide

    /// Ends of the links, the base first.
    std::vector<Point> centres(const Eigen::VectorXd &configuration) const;
    /// The configuration with these ends of the links, whose angles are the nearest to those of `before`.
    /// \return false if the base is off the slide
    bool configuration(const std::vector<Point> &centres, const Eigen::VectorXd &before, Eigen::VectorXd &found) const;

    /// The straight motion between two configurations.
    void motion(const Eigen::VectorXd &from, const Eigen::VectorXd &to, ChainMotion<D> &found) const;

private:
    const Model *model_;
    ChainSpec spec_;
    Point axis_;
    std::vector<ChainGeometry> geometry_;  ///< one in space, none in the plane
};

///@{
/// Why a robot is no chain of equal links on a slide; empty if it is.
std::string whyNoChain(const PlanarModel &model);
std::string whyNoChain(const SpatialModel &model);
///@}
}  // namespace narrows
