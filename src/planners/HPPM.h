// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>

#include "kernel/CurveTracker.h"
#include "kernel/Repulsion.h"
#include "kernel/SliceHomotopy.h"
#include "kernel/SphereTracker.h"
#include "planners/CurveRecipe.h"
#include "planners/ModelPlanner.h"
#include "planners/RecipeSampler.h"
#include "spaces/ArmStateSpace.h"

namespace narrows
{
/**
   @anchor HPPM
   @par Short description
   The homotopy path planning method: obstacles become poles of a Newton homotopy whose curve leads from start to goal;
   the curve is followed and then certified by the motion validator.

   `search=restarts` (the default) finds the homotopy itself: the straight motion, then curves in random slices of joint
   space with balanced strengths (RecipeSampler), until one arrives and is free. recipe() says which one it was.
   `search=paper` follows the one curve that the parameters describe, once per goal, as the paper does; where it does
   not reach the goal, reason() says how it ended.
   @par External documentation
   G. C. Velez-Lopez et al., A Novel Collision-Free Homotopy Path Planning for Planar Robotic Arms, Sensors 22 (2022)
   4022. docs/hppm.md lists the equations as implemented, the errata, and what is ours.

   Parameters of both searches: `max_step`, `max_steps` of a curve. Of the search for restarts: `tries`, `pole_rows`
   (rows of W), `goal_candidates`. Of the one curve: `form` (plane: the exact reduction to a slice, adaptive steps;
   full: hyperspheres of fixed `radius` as printed), `poles` (points, `points_per_link` of them, as printed; or
   continuous), `repulsion` P, `rows` (the constants a_{k,j}) or `direction` and `strength` (N and c of the slice),
   `turns`, `traced_from`, `held`, `held_share`, `orientation`, `lambda_min`, `lambda_max`, `max_deviation`. Without
   rows or direction, rows are the identity matrix.
*/
class HPPM : public ModelPlanner
{
public:
    /// \param si of an ArmStateSpace or of any other RealVectorStateSpace, whose values are then the configuration; see
    /// jointsOf(). All that is asked of its state validity checker are states within the space's bounds.
    /// \param model the robot and its obstacles: planarRepulsionModel(), spatialRepulsionModel(), controlPointModel()
    HPPM(const ob::SpaceInformationPtr &si, std::shared_ptr<const RepulsionModel> model);

    /// Besides OMPL's usual statuses: ABORT when everything has been tried in vain (see reason(): `tries` when the
    /// restarts are used up; with search=paper a name of `TraceStatus`, or `collision` when the curve reached the goal
    /// but the validator refuses it, or `no_points` when the paper has no function for an obstacle; `space` if the
    /// space is no RealVectorStateSpace or has not as many dimensions as the model has joints). A later call goes on
    /// with what has not been tried yet.
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override;
    using ob::Planner::solve;
    void clear() override;                                      ///< Forgets the search, not the parameters.
    void getPlannerData(ob::PlannerData &data) const override;  ///< What has been searched, starts and goals marked.
    /// The curve that solved, or the one that was tried last; empty if the straight motion did.
    std::map<std::string, std::string> recipe() const override;

    /// The slice that search=paper follows its curve in, from `start` to `goal` (from the goal, if traced_from says
    /// so), and how it follows it. \throws std::invalid_argument if there is no such curve: see SliceHomotopy
    SliceHomotopy slice(const ob::State *start, const ob::State *goal) const;
    /// How search=paper follows that curve.
    TrackerOptions trackerOptions() const { return trackerOptions(givenRecipe()); }

    ///@{
    /// A parameter: meaning, unit and range are those of params() and the text above.
    /// \throws std::invalid_argument from every setter if the value is out of range or does not fit the robot or scene.
    void setSearch(const std::string &search);
    std::string getSearch() const { return restarts_ ? "restarts" : "paper"; }
    void setTries(int tries);  ///< curves to follow before giving up; the straight motions do not count
    int getTries() const { return tries_; }
    void setPoleRows(int rows);
    int getPoleRows() const { return poleRows_; }
    void setGoalCandidates(int count);  ///< goals that are sampled, if there are many; the nearest is tried most
    int getGoalCandidates() const { return goalCandidates_; }

    void setForm(const std::string &form);
    std::string getForm() const { return full_ ? "full" : "plane"; }
    void setPoles(const std::string &poles);
    std::string getPoles() const { return given_.continuous ? "continuous" : "points"; }
    void setPointsPerLink(int points);
    int getPointsPerLink() const { return given_.pointsPerLink; }
    /// "0.01", or one number per obstacle or group of poles: "-0.1, 0.1"; several rows of W are separated by ";"
    void setRepulsion(const std::string &lists);
    std::string getRepulsion() const;
    void setRows(const std::string &rows);  ///< "1, 3, 2; 1, -1, 4; 1, 1, -2"; empty for the identity
    std::string getRows() const;
    void setDirection(const std::string &lists);  ///< replaces rows; empty to use rows again; ";" between rows of W
    std::string getDirection() const;
    void setStrength(const std::string &list);  ///< "1", or one number per row of W
    std::string getStrength() const;
    void setTurns(const std::string &list);  ///< full turns added to the goal, one number per joint; empty for none
    std::string getTurns() const;
    void setTracedFrom(const std::string &end);  ///< start | goal
    std::string getTracedFrom() const { return given_.fromGoal ? "goal" : "start"; }
    /// Per joint 0, or -1 to hold it where the trace begins, or 1 where it ends; empty for none
    void setHeld(const std::string &list);
    std::string getHeld() const;
    void setHeldShare(double share);
    double getHeldShare() const { return given_.schedule.share; }
    void setRadius(double radius);
    double getRadius() const { return spheres_.radius; }
    void setOrientation(const std::string &orientation);  ///< increasing | decreasing
    std::string getOrientation() const { return given_.window.decreasing ? "decreasing" : "increasing"; }
    void setLambdaMin(double lambda);
    double getLambdaMin() const { return given_.window.lambdaMin; }
    void setLambdaMax(double lambda);
    double getLambdaMax() const { return given_.window.lambdaMax; }
    void setMaxDeviation(double deviation);
    double getMaxDeviation() const { return given_.window.maxDeviation; }
    /// 0: a third of a radian for three joints, growing with the root of their number; what counts as a radian where
    /// the space is no ArmStateSpace is the longest side of its bounds / pi
    void setMaxStep(double step);
    double getMaxStep() const { return maxStep_; }
    void setMaxSteps(int steps);  ///< 0: 5000 with search=paper, 200 with restarts
    int getMaxSteps() const { return maxSteps_; }
    ///@}

private:
    /// A goal and what is being tried to reach it.
    struct Target
    {
        ob::ScopedState<> state;
        double distance;
        CurveEnds ends;
        std::optional<RecipeSampler> sampler;  ///< made when the first curve is drawn
    };

    void declareParameters();
    /// The length in joint space that counts as a radian.
    double unit() const;
    Eigen::Index joints() const { return model_->dimension(); }
    ob::PlannerStatus followGiven(const ob::PlannerTerminationCondition &ptc);
    ob::PlannerStatus restart(const ob::PlannerTerminationCondition &ptc);
    /// The status when nothing is left to try: a solution of an earlier call still stands.
    ob::PlannerStatus giveUp() const;
    bool solvedBefore() const { return pdef_->hasExactSolution(); }
    /// Adds the last trace as a solution.
    ob::PlannerStatus succeed();

    bool takeTargets(const ob::PlannerTerminationCondition &ptc);
    Target makeTarget(const ob::State *goal) const;
    bool goStraight(const Target &target);
    Target &nextTarget();
    bool tryCurve(Target &target, const ob::PlannerTerminationCondition &ptc);

    /// What came of following a curve.
    struct Attempt
    {
        std::shared_ptr<og::PathGeometric> path;
        bool reached;        ///< the path ends in the goal
        std::string reason;  ///< why the path is no solution; empty if it is one
    };
    /// Follows the recipe's curve. Where its chords are not free although it arrives, it is followed once more in steps
    /// whose chords are.
    Attempt attempt(const CurveRecipe &recipe, const ob::State *goal, const ob::PlannerTerminationCondition &ptc);
    Attempt attemptFull(const CurveRecipe &recipe, const ob::State *goal, const ob::PlannerTerminationCondition &ptc);
    Attempt judge(const Trace &trace, bool fromGoal, const ob::State *goal);

    /// The goal as a configuration, with the recipe's turns.
    Eigen::VectorXd turned(const ob::State *goal, const Eigen::VectorXi &turns) const;
    SliceHomotopy makeSlice(const CurveRecipe &recipe, const Eigen::VectorXd &start, const Eigen::VectorXd &goal) const;
    TrackerOptions trackerOptions(const CurveRecipe &recipe) const;
    std::vector<std::shared_ptr<const Repulsion>> repulsions(const CurveRecipe &recipe) const;
    CurveRecipe givenRecipe() const;
    Eigen::MatrixXd givenRows() const;

    /// The trace as states, from start to `goal` and exact at both ends; null if the trace does not join them.
    std::shared_ptr<og::PathGeometric> toPath(const Trace &trace, bool fromGoal, const ob::State *goal) const;
    bool isFree(const og::PathGeometric &path) const;
    /// Is the straight motion between two states, or two configurations, within the bounds and free?
    bool isFree(const ob::State *from, const ob::State *to) const;
    bool isFree(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const;
    void keep(std::shared_ptr<og::PathGeometric> path, bool reached);
    void measure(const Trace &trace);

    std::shared_ptr<const RepulsionModel> model_;
    std::shared_ptr<const ArmStateSpace> space_;  ///< null if there is nothing to plan in

    bool restarts_ = true;
    int tries_ = 100000;
    int poleRows_ = 1;
    int goalCandidates_ = 8;
    bool full_ = false;
    CurveRecipe given_;     ///< of search = paper; without rows or columns where nothing is given
    Eigen::MatrixXd rows_;  ///< empty: identity, unless given_ has directions
    double maxStep_ = 0.0;
    int maxSteps_ = 0;
    SphereOptions spheres_;

    ompl::RNG random_;
    Eigen::VectorXd start_;
    std::vector<Target> targets_;  ///< nearest first
    int attempts_ = 0;
    std::optional<CurveRecipe> last_;                         ///< that was followed; none for straight motions
    std::vector<std::shared_ptr<og::PathGeometric>> traces_;  ///< all of search = paper; the solutions of restarts
    std::vector<bool> reached_;                               ///< per trace: does it end in its goal?
};
}  // namespace narrows
