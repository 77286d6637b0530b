// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ChainRobot.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
namespace
{
constexpr double rounding = 1e-9;  ///< of the length of a link, or of a unit vector

bool allEqual(const std::vector<double> &lengths)
{
    return std::all_of(lengths.begin(), lengths.end(),
                       [&](double length) { return std::abs(length - lengths[0]) <= rounding * lengths[0]; });
}

std::vector<double> lengthsOf(const PlanarArm &arm)
{
    std::vector<double> lengths;
    for (const PlanarLink &link : arm.links())
        lengths.push_back(link.length);
    return lengths;
}

/// Angles against the parent link are limited to the smallest of what joints allow to either side; angles against the x
/// axis are the checker's business.
double maxAngleOf(const PlanarArmStateSpace &space)
{
    double most = std::numeric_limits<double>::infinity();
    if (space.convention() == AngleConvention::Absolute)
        return most;
    for (std::size_t i = space.arm().firstAngle() + 1; i < space.joints().size(); ++i)
        if (const std::optional<Interval> &limits = space.joints()[i].limits)
            most = std::min({most, limits->upper, -limits->lower});
    return std::max(most, rounding);
}

std::vector<ChainGeometry> geometryOf(const PlanarModel &)
{
    return {};
}

std::vector<ChainGeometry> geometryOf(const SpatialModel &model)
{
    return {*chainGeometry(model.arm)};
}
}  // namespace

std::string whyNoChain(const PlanarModel &model)
{
    if (!model.arm.slide())
        return "tight maneuvering needs a chain on a slide";
    for (int i = 0; i < model.arm.linkCount(); ++i)
        if (model.arm.links()[i].parent != i - 1)
            return "tight maneuvering needs a chain, not a tree of links";
    return allEqual(lengthsOf(model.arm)) ? "" : "tight maneuvering needs links of one length";
}

std::string whyNoChain(const SpatialModel &model)
{
    const std::optional<ChainGeometry> chain = chainGeometry(model.arm);
    if (!chain)
        return "tight maneuvering needs a chain of universal joints with one limit, on a slide";
    return allEqual(chain->lengths) ? "" : "tight maneuvering needs links of one length";
}

template <>
ChainRobot<2>::ChainRobot(const PlanarModel &model, const PlanarArmStateSpace &space)
  : model_(&model), axis_(model.arm.slide()->axis), geometry_(geometryOf(model))
{
    spec_ = {model.arm.linkCount(), model.arm.links()[0].length, model.arm.radius(), maxAngleOf(space),
             model.selfCollision};
}

template <>
ChainRobot<3>::ChainRobot(const SpatialModel &model, const SpatialArmStateSpace &)
  : model_(&model), axis_(Eigen::Vector3d::Zero()), geometry_(geometryOf(model))
{
    const ChainGeometry &chain = geometry_[0];
    axis_ = chain.axes.col(0);
    spec_ = {static_cast<int>(chain.lengths.size()), chain.lengths[0], chain.radius, chain.maxAngle,
             model.selfCollision};
}

template <>
std::vector<Eigen::Vector2d> ChainRobot<2>::centres(const Eigen::VectorXd &configuration) const
{
    std::vector<Eigen::Vector2d> points;
    model_->arm.place(configuration, points);
    return points;
}

template <>
std::vector<Eigen::Vector3d> ChainRobot<3>::centres(const Eigen::VectorXd &configuration) const
{
    std::vector<Eigen::Vector3d> points;
    jointCentres(model_->arm, configuration, points);
    return points;
}

template <>
bool ChainRobot<2>::configuration(const std::vector<Eigen::Vector2d> &centres, const Eigen::VectorXd &before,
                                  Eigen::VectorXd &found) const
{
    const Eigen::Vector2d away = centres[0] - model_->arm.base();
    const double slide = away.dot(axis_);
    if ((away - slide * axis_).norm() > rounding * spec_.length * spec_.links)
        return false;
    found.resize(before.size());
    found[0] = slide;
    for (std::size_t i = 1; i < centres.size(); ++i)
    {
        const Eigen::Vector2d along = centres[i] - centres[i - 1];
        const Eigen::Index joint = static_cast<Eigen::Index>(i);
        found[joint] = before[joint] + std::remainder(std::atan2(along.y(), along.x()) - before[joint], 2.0 * M_PI);
    }
    return true;
}

template <>
bool ChainRobot<3>::configuration(const std::vector<Eigen::Vector3d> &centres, const Eigen::VectorXd &before,
                                  Eigen::VectorXd &found) const
{
    found.resize(before.size());
    return valuesFromCentres(geometry_[0], centres, found);
}

template <>
void ChainRobot<2>::motion(const Eigen::VectorXd &from, const Eigen::VectorXd &to, ChainMotion<2> &found) const
{
    chainMotion(model_->arm, from, to, found);
}

template <>
void ChainRobot<3>::motion(const Eigen::VectorXd &from, const Eigen::VectorXd &to, ChainMotion<3> &found) const
{
    chainMotion(geometry_[0], from, to, found);
}

template class ChainRobot<2>;
template class ChainRobot<3>;
}  // namespace narrows
