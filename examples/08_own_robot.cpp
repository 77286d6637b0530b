// SPDX-License-Identifier: BSD-3-Clause
// HPPM for a robot and obstacles that this library does not know: an OMPL program that brings both (docs/reuse.md).
//
//   08_own_robot scara     a SCARA of two links on a mobile base drives and folds its way among round pillars
//   08_own_robot distance  the same robot among obstacles that are one signed distance function: a room's walls
//
// Prints the path's joints, and how near it comes to anything when it is looked at a thousand times per motion.
#include <cmath>
#include <iostream>
#include <string>

#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "kernel/ControlPoints.h"
#include "planners/HPPM.h"
#include "spaces/JointStateSpace.h"

namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double pi = 3.14159265358979323846;
constexpr double baseRadius = 0.3, linkRadius = 0.08, linkLength = 0.6;
constexpr int ballsPerLink = 4;

/// Joints: x, y and heading of the base, shoulder, elbow. Balls: the base, then along the links.
void place(const Eigen::Ref<const VectorXd> &q, Eigen::MatrixXd &points, std::vector<Eigen::MatrixXd> *jacobians)
{
    const Vector2d base(q[0], q[1]);
    points.col(0) = base;
    if (jacobians != nullptr)
        (*jacobians)[0] << Eigen::Matrix2d::Identity(), Eigen::MatrixXd::Zero(2, 3);
    Vector2d joint = base;
    double angle = q[2];
    Vector2d shoulderToJoint = Vector2d::Zero();
    for (int link = 0; link < 2; ++link)
    {
        angle += q[3 + link];
        const Vector2d along(std::cos(angle), std::sin(angle));
        for (int k = 1; k <= ballsPerLink; ++k)
        {
            const Vector2d onLink = linkLength * k / ballsPerLink * along;
            const int ball = link * ballsPerLink + k;
            points.col(ball) = joint + onLink;
            if (jacobians == nullptr)
                continue;
            const Vector2d lever = shoulderToJoint + onLink;
            Eigen::MatrixXd &jacobian = (*jacobians)[static_cast<std::size_t>(ball)];
            jacobian.setZero();
            jacobian.leftCols(2).setIdentity();
            jacobian.col(2) << -lever.y(), lever.x();  // heading and shoulder turn all of the arm
            jacobian.col(3) = jacobian.col(2);
            if (link == 1)
                jacobian.col(4) << -onLink.y(), onLink.x();
        }
        joint += linkLength * along;
        shoulderToJoint += linkLength * along;
    }
}

narrows::ControlPoints scara()
{
    std::vector<double> radii(1 + 2 * ballsPerLink, linkRadius);
    radii[0] = baseRadius;
    return {5, 2, radii, place};
}

narrows::DistanceFunction pillar(const std::string &name, const Vector2d &center, double radius)
{
    return {name, [=](const Eigen::Ref<const VectorXd> &point, VectorXd *gradient)
            {
                const Vector2d apart = point - center;
                if (gradient != nullptr)
                    *gradient = apart.normalized();
                return apart.norm() - radius;
            }};
}

/// Walls on both sides of a door at x = 0: how far a point is from either half-line, less their thickness.
double wallDistance(const Eigen::Ref<const VectorXd> &point, VectorXd *gradient)
{
    constexpr double door = 0.5, thickness = 0.1;
    const double side = point[1] < 0.0 ? -1.0 : 1.0;
    const double beyond = std::min(side * point[1] - door, 0.0);  // < 0: in line with the door
    const Vector2d apart(point[0], side * beyond);
    if (gradient != nullptr)
        *gradient = apart.norm() > 0.0 ? Vector2d(apart.normalized()) : Vector2d(1.0, 0.0);
    return apart.norm() - thickness;
}

std::vector<narrows::DistanceFunction> obstaclesOf(const std::string &scene)
{
    if (scene == "distance")
        return {{"walls", wallDistance}};
    return {pillar("left", {0.0, 0.9}, 0.45), pillar("right", {0.0, -0.9}, 0.45), pillar("far", {1.9, 0.7}, 0.3)};
}

ob::StateSpacePtr jointSpace()
{
    const narrows::ArmJoint place{false, narrows::Interval{-3.0, 3.0}};
    const narrows::ArmJoint turns{true, std::nullopt, true};
    const narrows::ArmJoint elbow{true, narrows::Interval{-2.8, 2.8}};
    return std::make_shared<narrows::JointStateSpace>(
        std::vector<narrows::ArmJoint>{place, place, turns, elbow, elbow});
}

int plan(const std::string &scene)
{
    const auto model = narrows::controlPointModel(scara(), obstaclesOf(scene), 0.5);
    og::SimpleSetup setup(jointSpace());
    const auto *space = setup.getStateSpace()->as<narrows::ArmStateSpace>();
    const auto clearance = [&](const ob::State *state)
    {
        VectorXd q, gradient;
        space->toConfiguration(state, q);
        return model->clearance(q, gradient);
    };
    setup.setStateValidityChecker([&](const ob::State *state)
                                  { return space->satisfiesBounds(state) && clearance(state) > 0.0; });
    setup.getSpaceInformation()->setStateValidityCheckingResolution(0.001);

    ob::ScopedState<narrows::JointStateSpace> start(setup.getStateSpace()), goal(setup.getStateSpace());
    space->fromConfiguration((VectorXd(5) << -1.8, -0.3, 0.0, pi / 2, 0.4).finished(), start.get());
    space->fromConfiguration((VectorXd(5) << 1.2, -0.2, 0.0, -0.8, 1.0).finished(), goal.get());
    setup.setStartAndGoalStates(start, goal);

    setup.setPlanner(std::make_shared<narrows::HPPM>(setup.getSpaceInformation(), model));
    if (setup.solve(10.0) != ob::PlannerStatus::EXACT_SOLUTION)
    {
        std::cout << scene << ": not solved\n";
        return 1;
    }
    og::PathGeometric path = setup.getSolutionPath();
    for (const ob::State *state : path.getStates())
        for (int j = 0; j < 5; ++j)
            std::cout << state->as<narrows::JointStateSpace::StateType>()->values[j] << (j < 4 ? ' ' : '\n');
    path.interpolate(static_cast<unsigned int>(1000 * path.getStateCount()));
    double least = clearance(path.getState(0));
    for (const ob::State *state : path.getStates())
        least = std::min(least, clearance(state));
    std::cout << scene << ": solved, least clearance " << least << '\n';
    return least > 0.0 ? 0 : 1;
}
}  // namespace

int main(int argc, char **argv)
{
    const std::string scene = argc == 2 ? argv[1] : "";
    if (scene != "scara" && scene != "distance")
    {
        std::cerr << "usage: 08_own_robot scara|distance\n";
        return 2;
    }
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    ompl::RNG::setSeed(1);
    return plan(scene);
}
