// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>

#include "planners/HPPM.h"
#include "planners/NumberList.h"
#include "planners/Require.h"

namespace narrows
{
namespace
{
/// Whole numbers, one per joint, or none.
Eigen::VectorXi readPerJoint(const std::string &name, const std::string &list, Eigen::Index joints, int largest)
{
    const Eigen::VectorXd values = parseVector(list);
    require(values.size() == 0 || values.size() == joints,
            fmt::format("{} needs {} numbers, not {}", name, joints, values.size()));
    const Eigen::VectorXi whole = values.cast<int>();
    require(whole.cast<double>() == values && (whole.size() == 0 || whole.cwiseAbs().maxCoeff() <= largest),
            fmt::format("{} takes whole numbers from -{} to {}", name, largest, largest));
    return whole;
}
}  // namespace

void HPPM::declareParameters()
{
    declareParam<std::string>("search", this, &HPPM::setSearch, &HPPM::getSearch, "restarts,paper");
    declareParam<int>("tries", this, &HPPM::setTries, &HPPM::getTries, "1:1:1000000");
    declareParam<int>("pole_rows", this, &HPPM::setPoleRows, &HPPM::getPoleRows, "1:1:4");
    declareParam<int>("goal_candidates", this, &HPPM::setGoalCandidates, &HPPM::getGoalCandidates, "1:1:100");
    declareParam<double>("max_step", this, &HPPM::setMaxStep, &HPPM::getMaxStep, "0:0.0001:1.");
    declareParam<int>("max_steps", this, &HPPM::setMaxSteps, &HPPM::getMaxSteps, "0:1:1000000");

    declareParam<std::string>("form", this, &HPPM::setForm, &HPPM::getForm, "plane,full");
    declareParam<std::string>("poles", this, &HPPM::setPoles, &HPPM::getPoles, "points,continuous");
    declareParam<int>("points_per_link", this, &HPPM::setPointsPerLink, &HPPM::getPointsPerLink, "1:1:200");
    declareParam<std::string>("repulsion", this, &HPPM::setRepulsion, &HPPM::getRepulsion);
    declareParam<std::string>("rows", this, &HPPM::setRows, &HPPM::getRows);
    declareParam<std::string>("direction", this, &HPPM::setDirection, &HPPM::getDirection);
    declareParam<std::string>("strength", this, &HPPM::setStrength, &HPPM::getStrength);
    declareParam<std::string>("turns", this, &HPPM::setTurns, &HPPM::getTurns);
    declareParam<std::string>("traced_from", this, &HPPM::setTracedFrom, &HPPM::getTracedFrom, "start,goal");
    declareParam<std::string>("held", this, &HPPM::setHeld, &HPPM::getHeld);
    declareParam<double>("held_share", this, &HPPM::setHeldShare, &HPPM::getHeldShare, "0.:0.01:0.99");
    declareParam<double>("radius", this, &HPPM::setRadius, &HPPM::getRadius, "0.0001:0.0001:1.");
    declareParam<std::string>("orientation", this, &HPPM::setOrientation, &HPPM::getOrientation,
                              "increasing,decreasing");
    declareParam<double>("lambda_min", this, &HPPM::setLambdaMin, &HPPM::getLambdaMin, "-10.:0.01:-0.001");
    declareParam<double>("lambda_max", this, &HPPM::setLambdaMax, &HPPM::getLambdaMax, "1.:0.01:10.");
    declareParam<double>("max_deviation", this, &HPPM::setMaxDeviation, &HPPM::getMaxDeviation, "0.1:0.1:1000.");
}

void HPPM::setSearch(const std::string &search)
{
    restarts_ = oneOf({"restarts", "paper"}, search, "search") == "restarts";
}

void HPPM::setTries(int tries)
{
    tries_ = within(1, tries, 1000000, "tries");
}

void HPPM::setPoleRows(int rows)
{
    require(rows >= 1 && rows <= 4 && rows < joints(),
            "pole_rows must lie between 1 and 4, and below the number of joints");
    poleRows_ = rows;
}

void HPPM::setGoalCandidates(int count)
{
    goalCandidates_ = within(1, count, 100, "goal_candidates");
}

void HPPM::setForm(const std::string &form)
{
    full_ = oneOf({"plane", "full"}, form, "form") == "full";
}

void HPPM::setPoles(const std::string &poles)
{
    given_.continuous = oneOf({"points", "continuous"}, poles, "poles") == "continuous";
}

void HPPM::setPointsPerLink(int points)
{
    given_.pointsPerLink = within(1, points, 200, "points_per_link");
}

void HPPM::setRepulsion(const std::string &lists)
{
    const Eigen::MatrixXd values = parseMatrix(lists);
    const auto obstacles = static_cast<Eigen::Index>(model_->obstacleCount());
    const auto groups = static_cast<Eigen::Index>(model_->groups().size());
    require(values.size() > 0 && (values.cols() == 1 || values.cols() == obstacles || values.cols() == groups),
            fmt::format("repulsion needs one number for all obstacles or one for each of the {}", obstacles));
    given_.strengths = values;
}

std::string HPPM::getRepulsion() const
{
    return toText(given_.strengths);
}

void HPPM::setRows(const std::string &rows)
{
    const Eigen::MatrixXd values = parseMatrix(rows);
    require(values.size() == 0 || (values.rows() == joints() && values.cols() == joints()),
            fmt::format("rows needs {0} rows of {0} numbers, not {1} of {2}", joints(), values.rows(), values.cols()));
    rows_ = values;
    given_.directions.resize(0, 0);
}

std::string HPPM::getRows() const
{
    return toText(rows_);
}

void HPPM::setDirection(const std::string &lists)
{
    const Eigen::MatrixXd values = parseMatrix(lists);
    require(values.size() == 0 || values.cols() == joints(),
            fmt::format("direction needs {} numbers, not {}", joints(), values.cols()));
    require(values.size() == 0 || (values.rowwise().norm().array() > 0.0).all(), "direction must not vanish");
    given_.directions = values.transpose();
}

std::string HPPM::getDirection() const
{
    return toText(given_.directions.transpose());
}

void HPPM::setStrength(const std::string &list)
{
    const Eigen::VectorXd values = parseVector(list);
    require(values.size() > 0, "strength needs a number");
    require((values.array().abs() > 0.0).all() && (values.array().abs() <= 100.0).all(),
            "strength must be neither 0 nor beyond +-100");
    given_.couplings = values;
}

std::string HPPM::getStrength() const
{
    return toText(given_.couplings.transpose());
}

void HPPM::setTurns(const std::string &list)
{
    given_.turns = readPerJoint("turns", list, joints(), 100);
}

std::string HPPM::getTurns() const
{
    return toText(given_.turns.transpose().cast<double>());
}

void HPPM::setTracedFrom(const std::string &end)
{
    given_.fromGoal = oneOf({"start", "goal"}, end, "traced_from") == "goal";
}

void HPPM::setHeld(const std::string &list)
{
    const Eigen::VectorXi values = readPerJoint("held", list, joints(), 1);
    given_.schedule.held.assign(values.data(), values.data() + values.size());
}

std::string HPPM::getHeld() const
{
    const std::vector<int> &held = given_.schedule.held;
    const Eigen::Map<const Eigen::VectorXi> values(held.data(), static_cast<Eigen::Index>(held.size()));
    return toText(values.transpose().cast<double>());
}

void HPPM::setHeldShare(double share)
{
    require(share >= 0.0 && share < 1.0, "held_share must lie from 0 to less than 1");
    given_.schedule.share = share;
}

void HPPM::setRadius(double radius)
{
    spheres_.radius = within(1e-4, radius, 1.0, "radius");
}

void HPPM::setOrientation(const std::string &orientation)
{
    given_.window.decreasing = oneOf({"increasing", "decreasing"}, orientation, "orientation") == "decreasing";
}

void HPPM::setLambdaMin(double lambda)
{
    given_.window.lambdaMin = within(-10.0, lambda, -0.001, "lambda_min");
}

void HPPM::setLambdaMax(double lambda)
{
    given_.window.lambdaMax = within(1.0, lambda, 10.0, "lambda_max");
}

void HPPM::setMaxDeviation(double deviation)
{
    given_.window.maxDeviation = within(0.1, deviation, 1000.0, "max_deviation");
}

void HPPM::setMaxStep(double step)
{
    require(step == 0.0 || (step >= 1e-4 && step <= 1.0), "max_step must be 0 or lie between 0.0001 and 1");
    maxStep_ = step;
}

void HPPM::setMaxSteps(int steps)
{
    maxSteps_ = within(0, steps, 1000000, "max_steps");
}
}  // namespace narrows
