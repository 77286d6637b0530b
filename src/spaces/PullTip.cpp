// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/PullTip.h"

#include <algorithm>

#include "kernel/DampedStep.h"
#include "kernel/TipJacobian.h"

namespace narrows
{
namespace
{
constexpr double longestMove = 0.5;  ///< per step; radians, and reaches of the arm for joints that slide
constexpr double relativeDamping = 1e-4;
constexpr int mostSteps = 50;

/// Where a tip is and how it moves with the joints of the arm's configuration.
class PlanarTip
{
public:
    PlanarTip(const PlanarArm &arm, int link) : arm_(arm), link_(link) {}

    Eigen::Vector2d place(ConfigurationRef q, Eigen::Matrix2Xd &jacobian)
    {
        arm_.place(q, points_);
        tipJacobian(arm_, q, link_, jacobian);
        return points_[link_ + 1];
    }

private:
    const PlanarArm &arm_;
    int link_;
    std::vector<Eigen::Vector2d> points_;
};

class SpatialTip
{
public:
    SpatialTip(const SpatialArm &arm, int link) : arm_(arm), link_(link) {}

    Eigen::Vector3d place(ConfigurationRef q, Eigen::Matrix3Xd &jacobian)
    {
        arm_.place(q, placement_);
        tipJacobian(arm_, placement_, link_, jacobian);
        return placement_.points[2 * link_ + 1];
    }

private:
    const SpatialArm &arm_;
    int link_;
    SpatialArm::Placement placement_;
};

/// What one unit of the search is for each joint: a radian, or a reach of the arm, which moves a tip as far.
Eigen::VectorXd unitsOf(const ArmStateSpace &space, double reach)
{
    Eigen::VectorXd units(space.getDimension());
    for (unsigned int i = 0; i < space.getDimension(); ++i)
        units[i] = space.joints()[i].turns ? 1.0 : reach;
    return units;
}

template <int Dim, typename Space, typename Tip, typename Goal>
bool pull(const Space &space, Tip tip, const Goal &goal, ob::State *state)
{
    const double reach = space.arm().reach();
    const Eigen::VectorXd units = unitsOf(space, reach);
    const double damping = relativeDamping * reach * reach;
    Eigen::VectorXd q;
    Eigen::Matrix<double, Dim, Eigen::Dynamic> jacobian;
    for (int step = 0; step < mostSteps; ++step)
    {
        space.toConfiguration(state, q);
        const Eigen::Matrix<double, Dim, 1> error = goal.point - tip.place(q, jacobian);
        if (error.norm() <= 0.1 * goal.tolerance)
            return true;
        jacobian = jacobian * units.asDiagonal();
        const Eigen::VectorXd move = dampedStep<Dim>(jacobian, error, damping);
        // Near singular postures the full step would wind joints round and round.
        q += std::min(1.0, longestMove / move.norm()) * move.cwiseProduct(units);
        space.fromConfiguration(q, state);
        space.enforceBounds(state);
    }
    return false;
}
}  // namespace

bool pullTip(const PlanarArmStateSpace &space, const TipGoal &goal, ob::State *state)
{
    return pull<2>(space, PlanarTip(space.arm(), goal.link), goal, state);
}

bool pullTip(const SpatialArmStateSpace &space, const SpatialTipGoal &goal, ob::State *state)
{
    return pull<3>(space, SpatialTip(space.arm(), goal.link), goal, state);
}
}  // namespace narrows
