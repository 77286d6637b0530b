// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <ompl/geometric/PathGeometric.h>

#include "planners/ModelPlanner.h"
#include "planners/TightRun.h"

namespace narrows
{
/**
   @anchor TightManeuvering
   @par Short description
   For chains of equal links on a slide, in the plane and in space, fed straight into an environment whose passages are
   hardly wider than the links are long: all joints follow the tip along one path. The path is bent until a certificate
   says that every link at any time is free (mode relax), or made by the paper's beams. Deterministic. Every motion is
   proven to be free, by its own margins or by the motion validator.

   Goals: a tip of the last link, or joint values (their tip, then a motion to the values). The start must be the
   straight chain along its slide.
   @par External documentation
   O. Minnetoglu and E. S. Conkur, Tight Maneuvering for Path Planning of Hyper-Redundant Manipulators in
   Three-Dimensional Environments, Applied Sciences 12 (2022) 8882. docs/tight.md lists its gaps, and what is ours.

   Parameters: `mode` (relax, middle, beams), `field` of the middle path (corridor, laplace), `spacing` of its grid (0:
   a twelfth of a link in space, a fortieth in the plane), `corridors` that are tried at most, `refinements` of the grid
   where there is no way through it, `rounds` of relaxation per try, `couples` of beams in space.
*/
class TightManeuvering : public ModelPlanner
{
public:
    /// \param si of the arm that the model describes; solve() says so elsewhere
    /// \param planar, spatial robot and obstacles; that of the other kind of robot is null
    TightManeuvering(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarModel> planar,
                     std::shared_ptr<const SpatialModel> spatial);

    /// Why the method is not for this robot; empty if it is.
    static std::string whyUnsupported(const PlanarModel *planar, const SpatialModel *spatial);

    /// Besides OMPL's usual statuses: ABORT when everything has been tried in vain. reason() is then what stopped the
    /// last try that got as far as a path: a name of `ChainFailure`, or no_corridor, start_not_straight, slide_limit,
    /// motion (the validator refuses what the certificate accepts), goal_motion, a failure of the beams or of the
    /// field; `timeout` if there was more to try. ABORT with `space` if the space is not that of the model's robot or
    /// whyUnsupported() says something. A later call goes on.
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override;
    using ob::Planner::solve;
    void clear() override;                                      ///< Forgets the search, not the parameters.
    void getPlannerData(ob::PlannerData &data) const override;  ///< What has been searched, starts and goals marked.

    ///@{
    /// A parameter: meaning, unit and range are those of params() and the text above.
    /// \throws std::invalid_argument from every setter if the value is out of range.
    void setMode(const std::string &mode);
    std::string getMode() const;
    void setField(const std::string &field);
    std::string getField() const;
    void setSpacing(double spacing);
    double getSpacing() const { return settings_.grid.spacing; }
    void setCorridors(int count);
    int getCorridors() const { return settings_.grid.corridors; }
    void setRefinements(int count);
    int getRefinements() const { return settings_.grid.refinements; }
    void setRounds(int rounds);
    int getRounds() const { return settings_.rounds; }
    void setCouples(int couples);
    int getCouples() const { return settings_.couples; }
    ///@}

private:
    void declareParameters();
    bool canWork() const;
    ob::PlannerStatus takeGoals(const ob::PlannerTerminationCondition &ptc);
    void addRun(const ob::State *goal);
    /// Makes the next try; true if it solved.
    bool tryNext(const ob::PlannerTerminationCondition &ptc);
    void keep(const TightOutcome &outcome);
    void collectMeasures();

    std::shared_ptr<const PlanarModel> planar_;
    std::shared_ptr<const SpatialModel> spatial_;
    TightSettings settings_;

    Eigen::VectorXd start_;
    std::vector<std::unique_ptr<TightRun>> runs_;  ///< one per goal
    std::size_t current_ = 0;
    std::shared_ptr<og::PathGeometric> path_;  ///< the solution, or how far the last try got
};
}  // namespace narrows
