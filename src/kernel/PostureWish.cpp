// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PostureWish.h"

#include <algorithm>
#include <cmath>

#include "kernel/TipSearch.h"

namespace narrows
{
namespace
{
constexpr double longestRetreat = 0.1;  // in units of a search, for one link and one obstacle
}

PostureWish::PostureWish(std::shared_ptr<const SpatialPoles> poles, const PostureWishOptions &options)
  : poles_(std::move(poles)), options_(options), units_(jointUnits(poles_->arm()))
{
    const SpatialArm &arm = poles_->arm();
    const auto &pairs = arm.universalLimits();
    for (int i = 0; i < arm.dimension(); ++i)
        if (arm.joints()[i].kind == SpatialJoint::Kind::Revolute &&
            std::none_of(pairs.begin(), pairs.end(),
                         [i](const UniversalLimit &pair) { return pair.first == i || pair.second == i; }))
            alone_.push_back(i);
    forces_.resize(static_cast<std::size_t>(arm.linkCount()));
}

void PostureWish::operator()(ConfigurationRef q, const SpatialArm::Placement &placement, Eigen::VectorXd &motion)
{
    motion.setZero(q.size());
    if (options_.bendGain > 0.0)
        unbend(q, motion);
    if (options_.obstacleGain > 0.0 && options_.influence > 0.0)
        keepAway(placement, motion);
}

void PostureWish::unbend(ConfigurationRef q, Eigen::VectorXd &motion) const
{
    for (const UniversalLimit &pair : poles_->arm().universalLimits())
    {
        motion[pair.first] -= options_.bendGain * std::sin(q[pair.first]) * std::cos(q[pair.second]);
        motion[pair.second] -= options_.bendGain * std::cos(q[pair.first]) * std::sin(q[pair.second]);
    }
    for (const int joint : alone_)
    {
        const std::optional<Interval> &limits = poles_->arm().joints()[joint].limits;
        motion[joint] -= options_.bendGain * (q[joint] - (limits ? 0.5 * (limits->lower + limits->upper) : 0.0));
    }
}

void PostureWish::keepAway(const SpatialArm::Placement &placement, Eigen::VectorXd &motion)
{
    const std::vector<SpatialLink> &links = poles_->arm().links();
    for (const SpatialPole &obstacle : poles_->obstacles())
        for (std::size_t i = 0; i < links.size(); ++i)
        {
            const SpatialTerm term =
                obstacle.clearance(placement.points[2 * i], placement.points[2 * i + 1], links[i].radius);
            if (term.value >= options_.influence || links[i].joint < 0)
                continue;
            forces_[i] = term.slope;
            retreat(placement, term.value, motion);
            forces_[i] = {};
        }
}

void PostureWish::retreat(const SpatialArm::Placement &placement, double clearance, Eigen::VectorXd &motion)
{
    gatherGradient(poles_->arm(), placement, forces_, gradient_);
    gradient_ = gradient_.cwiseProduct(units_);
    const double slope = gradient_.norm();
    if (!(slope > 0.0))
        return;
    const double way = options_.obstacleGain * (options_.influence - clearance) / slope;
    motion += std::min(way, longestRetreat) / slope * gradient_.cwiseProduct(units_);
}
}  // namespace narrows
