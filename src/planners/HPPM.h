// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>

#include "kernel/PlaneTracker.h"
#include "kernel/SphereTracker.h"
#include "planners/ModelPlanner.h"
#include "spaces/PlanarArmStateSpace.h"

namespace narrows
{
/**
   @anchor HPPM
   @par Short description
   The homotopy path planning method for planar robotic arms: obstacles become poles of a Newton homotopy whose curve
   leads from start to goal; the curve is followed and then certified by the motion validator. One curve per goal, no
   search: where the recipe's curve does not reach the goal, reason() says how it ended.
   @par External documentation
   G. C. Velez-Lopez et al., A Novel Collision-Free Homotopy Path Planning for Planar Robotic Arms, Sensors 22 (2022)
   4022. docs/hppm.md lists the equations as implemented and the errata.

   Parameters: `form` (plane: the exact two-dimensional reduction, adaptive steps; full: hyperspheres of fixed radius as
   printed), `points_per_link` n, `repulsion` P per obstacle and point (one number for all, or one per obstacle), `rows`
   (the constants a_{k,j}) or `direction` and `strength` (N and c of the plane), `radius` of the hyperspheres,
   `orientation`, `lambda_min`, `lambda_max`, `max_step` of the plane form. Without rows or direction, rows are the
   identity matrix.
*/
class HPPM : public ModelPlanner
{
public:
    HPPM(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarModel> model);

    /// One attempt per goal; a later call goes on with goals not yet tried. Besides OMPL's usual statuses: ABORT when
    /// every goal has been tried in vain (see reason(): a name of `TraceStatus`, or `collision` when the curve reached
    /// the goal but the validator refuses it, or `polygon` when the scene has obstacles that the paper has no function
    /// for).
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override;
    using ob::Planner::solve;
    void clear() override;
    void getPlannerData(ob::PlannerData &data) const override;

    /// \throws std::invalid_argument from every setter if the value is out of range or does not fit the robot or scene.
    void setForm(const std::string &form);
    const std::string &getForm() const { return form_; }
    void setPointsPerLink(int points);
    int getPointsPerLink() const { return pointsPerLink_; }
    void setRepulsion(const std::string &list);  ///< "0.01", or one number per obstacle: "-0.1, 0.1"
    std::string getRepulsion() const;
    void setRows(const std::string &rows);  ///< "1, 3, 2; 1, -1, 4; 1, 1, -2"; empty for the identity
    std::string getRows() const;
    void setDirection(const std::string &list);  ///< replaces rows; empty to use rows again
    std::string getDirection() const;
    void setStrength(double strength);
    double getStrength() const { return strength_; }
    void setRadius(double radius);
    double getRadius() const { return spheres_.radius; }
    void setOrientation(const std::string &orientation);  ///< increasing | decreasing
    std::string getOrientation() const { return window_.decreasing ? "decreasing" : "increasing"; }
    void setLambdaMin(double lambda);
    double getLambdaMin() const { return window_.lambdaMin; }
    void setLambdaMax(double lambda);
    double getLambdaMax() const { return window_.lambdaMax; }
    void setMaxStep(double step);
    double getMaxStep() const { return plane_.maxStep; }

private:
    void declareParameters();
    ArmHomotopy makeHomotopy(const Eigen::VectorXd &goal) const;
    /// Follows the curve to one goal and keeps it; true if it arrives there and is free.
    bool attempt(const ob::State *goal, const ob::PlannerTerminationCondition &ptc);
    /// Moves the trace into traces_, exact at both ends.
    void keep(const Trace &trace, const ob::State *goal);
    bool isFree(const og::PathGeometric &path) const;
    void measure(const Trace &trace);
    /// The status once every goal has been tried: a solution of an earlier call still stands.
    ob::PlannerStatus giveUp() const;
    bool solvedBefore() const;

    const PlanarArmStateSpace *space_;
    std::string form_ = "plane";
    int pointsPerLink_ = 10;
    Eigen::VectorXd repulsion_;  ///< one for all or one per obstacle
    Eigen::MatrixXd rows_;       ///< empty: identity
    Eigen::VectorXd direction_;  ///< empty: rows count
    double strength_ = 1.0;
    TraceWindow window_;
    PlaneOptions plane_;
    SphereOptions spheres_;

    Eigen::VectorXd start_;  ///< empty until a start has been taken
    ob::ScopedState<> startState_;
    std::vector<std::shared_ptr<og::PathGeometric>> traces_;  ///< one per goal that was tried
    std::vector<bool> reached_;                               ///< per trace: does it end in its goal?
};
}  // namespace narrows
