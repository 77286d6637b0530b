// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <ompl/base/Planner.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>
#include <Eigen/Core>

#include "spaces/Ompl.h"

namespace narrows
{
/// A planner that says why it stopped and what work it did. Most see robot and obstacles, not only whether states are
/// free.
class ModelPlanner : public ob::Planner
{
public:
    using ob::Planner::Planner;

    /// Why no exact solution has been found, in one word (wrong_root, turned_back, ...); empty if one has, or after
    /// clear().
    const std::string &reason() const { return reason_; }

    /// Machine-free measures of the work since clear(), by name (homotopy_evaluations, hyperspheres, rejected_steps,
    /// ...).
    const std::map<std::string, double> &measures() const { return measures_; }

    /// Parameters with which the planner does at once what has led to its solution or, without one, what it tried last;
    /// empty if there is nothing to say.
    virtual std::map<std::string, std::string> recipe() const { return {}; }

    /// The corners of the free polyline that a smooth solution was made from, one column each, joints as the space
    /// counts them, without wrapping; empty if the solution is the polyline.
    virtual const Eigen::MatrixXd &vias() const
    {
        static const Eigen::MatrixXd none;
        return none;
    }

    void clear() override;  ///< Forgets the search, as ob::Planner says; measures and reason with it.

protected:
    /// What comes before any search: the goal's type, the start, a solution that the problem has already. UNKNOWN if a
    /// search may begin or go on; anything else is what solve() returns. The reason is timeout from here on.
    ob::PlannerStatus open(const ob::PlannerTerminationCondition &ptc);

    /// What solve() returns where the planner has nothing to go by: ABORT, with this reason().
    /// \throws ompl::Exception as checkValidity() does, where there is no problem to solve
    ob::PlannerStatus refuse(const std::string &reason);

    /// Takes the problem's first valid start, once. False if there is none.
    bool takeStart();

    /// A solution's states and motions for getPlannerData(), the first state as a start.
    /// \param path at least one state \param data that they are added to
    /// \param reached whether the last one is a goal
    static void addPath(const og::PathGeometric &path, bool reached, ob::PlannerData &data);

    std::optional<ob::ScopedState<>> startState_;  ///< after takeStart()
    std::string reason_;                           ///< what reason() says
    std::map<std::string, double> measures_;       ///< what measures() says
};
}  // namespace narrows
