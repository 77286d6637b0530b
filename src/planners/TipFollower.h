// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <ompl/geometric/PathGeometric.h>

#include "kernel/SpatialModel.h"
#include "kernel/TipSearch.h"
#include "planners/ModelPlanner.h"
#include "spaces/SpatialArmStateSpace.h"

namespace narrows
{
/**
   @anchor TipFollower
   @par Short description
   Follows a tip path (or goes straight to the one point of a tip goal) by numerical inverse kinematics: dense waypoints
   along the straight lines between the points, each solved from the posture at the one before, every motion between two
   of them checked by the motion validator. What is not free is not gone around: the posture that the iteration finds is
   the only one that is tried.

   Parameters: `step`, `precision`, `max_iterations`, and those of the method.
   Measures: `waypoints` reached, `iterations` in all, `most_iterations` of one waypoint, `points_reached`.
*/
class TipFollower : public ModelPlanner
{
public:
    /// Besides OMPL's usual statuses: APPROXIMATE_SOLUTION with the waypoints that were reached, whose difference is
    /// the length of tip path that is left, or ABORT if there are none. Then reason() is `no_convergence` (the
    /// iteration did not get the tip there), `limit` (the same, and a joint was at its limit) or `collision` (the
    /// motion there is not free); after a TIMEOUT it is empty, and a later call goes on.
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override;
    using ob::Planner::solve;
    void clear() override;                                      ///< Forgets the way so far, not the parameters.
    void getPlannerData(ob::PlannerData &data) const override;  ///< The way so far, from the start on.

    ///@{
    /// Largest distance of two waypoints of the tip, at least a millionth of all links' lengths, of which it is a 625th
    /// if not set. \throws std::invalid_argument from every setter if the value is out of range
    void setStep(double step);
    double getStep() const { return step_; }
    ///@}
    ///@{
    /// How near the tip has to come, as a share in (0, 1] of the goal's tolerance.
    void setPrecision(double share);
    double getPrecision() const { return precision_; }
    ///@}
    ///@{
    /// For one waypoint, in [1, 1000].
    void setMaxIterations(int iterations);
    int getMaxIterations() const { return maxIterations_; }
    ///@}

protected:
    /// \param si of a SpatialArmStateSpace \param model its arm is that of this space
    /// \param name of the planner
    TipFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model, const std::string &name);

    /// The method: called once for a problem, when its goal is known.
    virtual std::unique_ptr<TipSearch> makeSearch(const TipSearchTask &task) const = 0;

    const SpatialModel &model() const { return *model_; }  ///< robot and obstacles
    double length() const { return length_; }              ///< of all links together

private:
    /// A place for the tip, and how many points of the tip path have been reached there.
    struct Waypoint
    {
        Eigen::Vector3d place;
        int points;
    };

    bool begin(const SpatialTipPath &path);
    void layWaypoints(const SpatialTipPath &path, const Eigen::Vector3d &from);
    TipSearchTask taskFor(const SpatialTipPath &path) const;
    bool isDone() const { return next_ == waypoints_.size(); }
    /// Takes the arm to the next waypoint, or sets the reason why not.
    void advance();
    /// \pre a waypoint has been reached
    double remaining() const;
    ob::PlannerStatus conclude(bool expired);

    std::shared_ptr<const SpatialModel> model_;
    const SpatialArmStateSpace *space_;
    double length_;
    double step_;
    double precision_ = 0.1;
    int maxIterations_ = 100;

    std::unique_ptr<TipSearch> search_;  ///< null before the start is known
    std::vector<Waypoint> waypoints_;
    std::size_t next_ = 0;
    Eigen::VectorXd q_;                        ///< where the arm is
    std::shared_ptr<og::PathGeometric> path_;  ///< how it has got there
};
}  // namespace narrows
