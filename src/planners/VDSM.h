// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>

#include "kernel/SpatialModel.h"
#include "kernel/scaling/PathScaling.h"
#include "planners/ModelPlanner.h"
#include "planners/ScalingSearch.h"
#include "spaces/SpatialArmStateSpace.h"

namespace narrows
{
/**
   @anchor VDSM
   @par Short description
   The variable-dimension scaling method for chains of universal joints on a slide: obstacles are projected along the
   slide, the tip goes straight or round them, and the joint centres follow by scaling the tip's way (taut: along the
   string that is taut around the obstacles). Deterministic. Every motion is checked by the motion validator; where one
   is refused, the tip goes round obstacles on other sides, then the margin is changed.

   Goals: a tip path (all points in order), a tip, or joint values (their tip, then a motion to the values).
   @par External documentation
   L. Jia et al., Variable Dimensional Scaling Method, Machines 10 (2022) 1030. docs/vdsm.md lists what of it was wrong,
   and what is ours.

   Parameters: `mode` (paper_nearest, paper_vertical, branch, taut), `margin` of the danger regions (0: 1.63 radii),
   `margins` (factors of it, tried in this order), `side_search` (ways of passing obstacles left or right that are tried
   per margin, cheapest first), `step` of the tip (0: reach / 625), `max_jump` of a joint per step (0: 6 steps),
   `easing` (rounds of pushing links out of corners), `retraction` of the tip along the slide on bypasses.
*/
class VDSM : public ModelPlanner
{
public:
    /// \param si of the arm that the model describes; solve() says so elsewhere
    /// \param model robot and obstacles
    VDSM(const ob::SpaceInformationPtr &si, const std::shared_ptr<const SpatialModel> &model);

    /// Why the method is not for this robot; empty if it is.
    static std::string whyUnsupported(const SpatialModel *model);

    /// Besides OMPL's usual statuses: ABORT when everything has been tried in vain, APPROXIMATE_SOLUTION if at least a
    /// part of the tip's way was found (its difference is the length of the rest). reason() is that of the longest
    /// part: a name of `ScalingFailure`, or `start_motion`, `motion`, `goal_motion` when the validator refuses the
    /// motion to the first pose, between poses, or to the goal's joint values; `timeout`. ABORT with `space` if the
    /// space is not that of the model's robot or whyUnsupported() says something. A later call goes on with what has
    /// not been tried yet.
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override;
    using ob::Planner::solve;
    void clear() override;                                      ///< Forgets the search, not the parameters.
    void getPlannerData(ob::PlannerData &data) const override;  ///< What has been searched, starts and goals marked.
    std::map<std::string, std::string> recipe() const override;

    ///@{
    /// A parameter: meaning, unit and range are those of params() and the text above.
    /// \throws std::invalid_argument from every setter if the value is out of range.
    void setMode(const std::string &mode);
    std::string getMode() const;
    void setMargin(double margin);
    double getMargin() const { return settings_.margin; }
    void setMargins(const std::string &factors);  ///< "1, 1.4, 0.75, 1.8"
    std::string getMargins() const;
    void setSideSearch(int count);
    int getSideSearch() const { return settings_.sideSearch; }
    void setStep(double step);
    double getStep() const { return settings_.step; }
    void setMaxJump(double jump);
    double getMaxJump() const { return settings_.maxJump; }
    void setEasing(int rounds);
    int getEasing() const { return settings_.easing; }
    void setRetraction(double depth);
    double getRetraction() const { return settings_.retraction; }
    ///@}

private:
    void declareParameters();
    std::optional<ob::PlannerStatus> takeGoal(const ob::PlannerTerminationCondition &ptc);
    void addSearch(const std::vector<Eigen::Vector3d> &tips, std::optional<Eigen::VectorXd> target);
    ob::PlannerStatus finish(bool timeout);

    /// Tries the next way of scaling; true if it solved.
    bool tryNext(const ob::PlannerTerminationCondition &ptc);
    /// What has come of one way of scaling.
    struct Attempt
    {
        std::vector<Eigen::VectorXd> states;  ///< from the start on, all joined by free motions
        std::string reason;                   ///< empty if the goal was reached
        double rest;                          ///< length of the tip's way that is left
    };
    /// The ways to a goal.
    struct Search
    {
        std::unique_ptr<ScalingSearch> ways;
        std::optional<Eigen::VectorXd> target;  ///< joint values to end in
        bool followsPath;                       ///< the tip's way matters, not only where it ends
        bool coarse;                            ///< few poses: tried for speed, no measure of how far the tip gets
    };
    Attempt follow(const ScaledWay &way, const Search &search, const ob::PlannerTerminationCondition &ptc) const;
    bool join(const Eigen::VectorXd &from, const Eigen::VectorXd &to, Attempt &attempt) const;
    bool isFree(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const;
    std::shared_ptr<og::PathGeometric> toPath(const Attempt &attempt) const;

    std::shared_ptr<const SpatialModel> model_;
    const SpatialArmStateSpace *space_;   ///< null if the space is another
    std::optional<ChainGeometry> chain_;  ///< none if the robot is another
    ScalingSettings settings_;

    Eigen::VectorXd start_;
    std::vector<Search> searches_;  ///< one per goal
    std::size_t current_ = 0;
    std::optional<Attempt> best_;              ///< that left the least of the tip's way
    std::shared_ptr<og::PathGeometric> path_;  ///< of it
    std::map<std::string, std::string> recipe_;
};
}  // namespace narrows
