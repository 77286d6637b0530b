// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "HyperRedundantArm.h"
#include "kernel/scaling/PathScaling.h"
#include "kernel/scaling/PoseRules.h"
#include "kernel/scaling/TipPath.h"

namespace narrows
{
/// The task of the VDSM paper: the tip draws a square of 1500 mm on the plane x = 3126 (its Section 4).
class PaperSquare
{
public:
    static constexpr double reach = 3126.0;
    static constexpr double retraction = 100.0;  ///< of the tip between A1 and A2, A4 and A5, A9 and A10

    /// \param circles the way A4 -> A5 once around the danger circle of the first obstacle
    /// \param step at most between neighbours
    PaperSquare(bool circles, double step) : step_(step), tips_{{reach, 0.0, 0.0}}
    {
        go({0.0, -200.0}, retraction);
        go({1000.0, -200.0});
        a4_ = go({1000.0, 600.0});
        a5_ = circles ? goAround() : a4_;
        a6_ = go({1000.0, 1300.0});
        go({-500.0, 1300.0});
        go({-500.0, -200.0});
        go({0.0, -200.0});
        go({0.0, 0.0}, retraction);
    }

    const std::vector<Eigen::Vector3d> &tips() const { return tips_; }
    std::size_t a4() const { return a4_; }
    std::size_t a5() const { return a5_; }
    std::size_t a6() const { return a6_; }

private:
    std::size_t go(const Eigen::Vector2d &to, double depth = 0.0)
    {
        appendLeg({tips_.back().tail<2>(), to}, reach, step_, depth, tips_);
        return tips_.size() - 1;
    }

    std::size_t goAround()
    {
        const int count = static_cast<int>(std::ceil(2.0 * std::acos(-1.0) * 300.0 / step_));
        std::vector<Eigen::Vector2d> corners;
        for (int i = 0; i <= count; ++i)
        {
            const double angle = -2.0 * std::acos(-1.0) * i / count;
            corners.emplace_back(700.0 + 300.0 * std::cos(angle), 600.0 + 300.0 * std::sin(angle));
        }
        corners.back() = corners.front();
        appendLeg(corners, reach, step_, retraction, tips_);
        return tips_.size() - 1;
    }

    double step_;
    std::vector<Eigen::Vector3d> tips_;
    std::size_t a4_, a5_, a6_;
};

/// The arm of the paper, in its slide frame.
inline ScalingProblem paperProblem()
{
    return scalingProblem(*chainGeometry(hyperRedundantArm()));
}

/// With its first obstacle, a cylinder along x.
inline ScalingProblem paperObstacle1()
{
    ScalingProblem problem = paperProblem();
    problem.sections.emplace_back(std::vector<Eigen::Vector2d>{{700.0, 600.0}}, 200.0);
    return problem;
}

/// With its third obstacle, a cylinder along z.
inline ScalingProblem paperObstacle3()
{
    ScalingProblem problem = paperProblem();
    problem.crossbars.push_back({2126.0, 600.0, Eigen::Vector2d::UnitX(), 200.0});
    return problem;
}

inline double degrees(double radians)
{
    return radians * 180.0 / std::acos(-1.0);
}

/// What the paper tells of a path of poses.
struct PathFigures
{
    double largestAngle = 0.0;   ///< of all psi, in degrees
    std::vector<double> angles;  ///< largest psi_1 .. psi_n, in degrees
    double lowestSlide = 0.0, highestSlide = 0.0;
    double clearance = 1e300;  ///< least distance of the links' axes from the sections
};

inline PathFigures figuresOf(const ScalingProblem &problem, const ScalingResult &result)
{
    PathFigures figures;
    figures.angles.assign(problem.links(), 0.0);
    for (std::size_t p = 0; p < result.poses(); ++p)
    {
        const Eigen::Vector3d *pose = result.pose(p);
        const std::vector<double> angles = linkAngles(problem, pose);
        for (std::size_t i = 0; i < angles.size(); ++i)
            figures.angles[i] = std::max(figures.angles[i], degrees(angles[i]));
        figures.lowestSlide = std::min(figures.lowestSlide, pose[0].x());
        figures.highestSlide = std::max(figures.highestSlide, pose[0].x());
        for (const ConvexSection &section : problem.sections)
            for (std::size_t i = 0; i < problem.links(); ++i)
                figures.clearance =
                    std::min(figures.clearance, section.distance(pose[i].tail<2>(), pose[i + 1].tail<2>()));
    }
    for (const double angle : figures.angles)
        figures.largestAngle = std::max(figures.largestAngle, angle);
    return figures;
}
}  // namespace narrows
