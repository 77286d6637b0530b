// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kernel/JointSchedule.h"
#include "kernel/Trace.h"

namespace narrows
{
/// All that decides which homotopy curve is followed between two configurations, in the paper's terms: the constants
/// a_{k,j} (as directions N_i with couplings c_i; any basis of what is orthogonal to N and D completes them to rows),
/// the strengths P and, for singular points, their number n.
struct CurveRecipe
{
    bool continuous = true;      ///< one pole per link and obstacle; else the paper's points
    int pointsPerLink = 10;      ///< n, without continuous poles
    Eigen::MatrixXd strengths;   ///< P: one row per row of W, one column per group of poles
    Eigen::MatrixXd directions;  ///< N_i in columns, one per row of W
    Eigen::VectorXd couplings;   ///< c_i
    Eigen::VectorXi turns;       ///< full turns added to the goal's joints, as the space counts them; empty: none
    bool fromGoal = false;       ///< the curve is traced from the goal
    JointSchedule schedule;      ///< from where it is traced to the other end
    TraceWindow window;          ///< where the curve may go

    /// As parameters of HPPM, which follow this curve again with search = paper.
    std::map<std::string, std::string> parameters() const;
};
}  // namespace narrows
