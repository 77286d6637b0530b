// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/RandomNumbers.h>

#include "planners/ModelPlanner.h"
#include "planners/TrajectorySmoother.h"
#include "spaces/JointCoordinates.h"

namespace narrows
{
/**
   @anchor ViaPointHomotopy
   @par Short description
   From the start through via points to the goal, and a motion in time along them that does not stop. Tried in turn: the
   straight motion; one via, drawn from a Gaussian around its middle; a chain of vias from two trees (OMPL's
   RRT-Connect, whose probabilistic completeness it inherits), shortened. The polyline of the vias is then deformed into
   a smooth motion: a homotopy that begins with stops at every via and goes as far as the motion can be certified to be
   free at all times (TrajectoryCertificate), searched for the least duration under limits of velocity, acceleration and
   jerk.
   @par External documentation
   Y. Quinonez et al., Appl. Sci. 13 (2023) 1142 has the via points. docs/iostv.md tells what of this is ours.

   Parameters: `mode` (smooth, polyline), `velocity`, `acceleration`, `jerk` (one number for all joints, or one for
   each; in the space's units per second, second^2, second^3), `evaluations` of the search for a short duration,
   `margin` of clearance that the smooth motion keeps, `via_attempts` (single vias that are tried), `range` of the trees
   (0: OMPL's choice).
*/
class ViaPointHomotopy : public ModelPlanner
{
public:
    /// \param selfCollision whether the state validity checker lets links not touch each other
    /// \param si of an ArmStateSpace or any other RealVectorStateSpace; see jointsOf(). Motions are certified and need
    /// not stop at vias where its state validity checker is an ArmValidityChecker.
    ViaPointHomotopy(const ob::SpaceInformationPtr &si, bool selfCollision);

    /// Besides OMPL's usual statuses ABORT when the trees give up. In mode `polyline` the path's states are the vias;
    /// in mode `smooth` they lie on the smooth motion, near enough to each other for the motion validator to accept
    /// what is between them. reason() is `timeout` or `no_chain`, or `space` with ABORT if the space is no
    /// RealVectorStateSpace. A later call goes on where this one stopped.
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override;
    using ob::Planner::solve;
    void clear() override;                                      ///< Forgets the search, not the parameters.
    void getPlannerData(ob::PlannerData &data) const override;  ///< What has been searched, starts and goals marked.

    /// How to drive along the solution: joints as the space counts them, without wrapping; keeps the limits at all
    /// times. In mode `polyline`, and where no deformation can be certified, it stops at every via. Null without an
    /// exact solution, or if start and goal are equal.
    const JointTrajectory *trajectory() const { return trajectory_ ? &*trajectory_ : nullptr; }
    /// The polyline that the trajectory was made from, one column per via; empty without a solution.
    const Eigen::MatrixXd &vias() const override { return vias_; }

    ///@{
    /// A parameter: meaning, unit and range are those of params() and the text above.
    /// \throws std::invalid_argument from every setter if the value is out of range.
    void setMode(const std::string &mode);
    std::string getMode() const { return smooth_ ? "smooth" : "polyline"; }
    void setVelocity(const std::string &limits);  ///< "1.5" or one number for each joint: "2, 1.5, 1"
    std::string getVelocity() const;
    void setAcceleration(const std::string &limits);
    std::string getAcceleration() const;
    void setJerk(const std::string &limits);
    std::string getJerk() const;
    void setEvaluations(int count);
    int getEvaluations() const { return evaluations_; }
    void setMargin(double margin);
    double getMargin() const { return margin_; }
    void setViaAttempts(int count);
    int getViaAttempts() const { return viaAttempts_; }
    void setRange(double range);
    double getRange() const { return range_; }
    ///@}

private:
    enum class Stage
    {
        Straight,
        OneVia,
        Chain,
        GaveUp
    };

    void declareParameters();
    Eigen::VectorXd limitsFrom(const std::string &text, const char *name) const;
    std::vector<MotionLimits> limits() const;

    /// A free polyline, or nothing if time is up or the trees gave up.
    std::optional<og::PathGeometric> polyline(const ob::PlannerTerminationCondition &ptc);
    std::optional<og::PathGeometric> throughOneVia();
    std::optional<og::PathGeometric> throughChain(const ob::PlannerTerminationCondition &ptc);
    void shorten(og::PathGeometric &path) const;
    void addTrajectory(const og::PathGeometric &polyline, const ob::PlannerTerminationCondition &ptc);
    /// States on the trajectory, if it is not the polyline itself, and the polyline's ends at its ends.
    og::PathGeometric sampled(og::PathGeometric polyline) const;
    /// Appends states up to a time, so many that the motions between them are accepted.
    bool sample(double from, double to, int depth, og::PathGeometric &path) const;

    std::shared_ptr<const ArmStateSpace> space_;  ///< null if there is nothing to plan in
    std::optional<JointCoordinates> coordinates_;
    bool selfCollision_;
    ompl::RNG rng_;

    bool smooth_ = true;
    Eigen::VectorXd velocity_, acceleration_, jerk_;  ///< per joint, or one for all
    int evaluations_ = 400;
    double margin_ = 0.0;
    int viaAttempts_ = 10;
    double range_ = 0.0;

    Stage stage_ = Stage::Straight;
    std::optional<ob::ScopedState<>> goal_;
    int attempts_ = 0;                       ///< at one via
    ob::PlannerPtr chain_;                   ///< grows the trees
    std::optional<og::PathGeometric> path_;  ///< the solution
    Eigen::MatrixXd vias_;
    std::optional<PolynomialTrajectory> trajectory_;
};
}  // namespace narrows
