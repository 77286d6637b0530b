// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "planners/HPPM.h"
#include "planners/NumberList.h"

namespace narrows
{
namespace
{
void require(bool condition, const std::string &message)
{
    if (!condition)
        throw std::invalid_argument(message);
}
}  // namespace

void HPPM::declareParameters()
{
    declareParam<std::string>("form", this, &HPPM::setForm, &HPPM::getForm, "plane,full");
    declareParam<int>("points_per_link", this, &HPPM::setPointsPerLink, &HPPM::getPointsPerLink, "1:1:200");
    declareParam<std::string>("repulsion", this, &HPPM::setRepulsion, &HPPM::getRepulsion);
    declareParam<std::string>("rows", this, &HPPM::setRows, &HPPM::getRows);
    declareParam<std::string>("direction", this, &HPPM::setDirection, &HPPM::getDirection);
    declareParam<double>("strength", this, &HPPM::setStrength, &HPPM::getStrength, "-100.:0.01:100.");
    declareParam<double>("radius", this, &HPPM::setRadius, &HPPM::getRadius, "0.0001:0.0001:1.");
    declareParam<std::string>("orientation", this, &HPPM::setOrientation, &HPPM::getOrientation,
                              "increasing,decreasing");
    declareParam<double>("lambda_min", this, &HPPM::setLambdaMin, &HPPM::getLambdaMin, "-10.:0.01:-0.001");
    declareParam<double>("lambda_max", this, &HPPM::setLambdaMax, &HPPM::getLambdaMax, "1.:0.01:10.");
    declareParam<double>("max_step", this, &HPPM::setMaxStep, &HPPM::getMaxStep, "0.0001:0.0001:1.");
}

void HPPM::setForm(const std::string &form)
{
    require(form == "plane" || form == "full", "form is plane or full, not \"" + form + "\"");
    form_ = form;
}

void HPPM::setPointsPerLink(int points)
{
    require(points >= 1 && points <= 200, "points_per_link must lie between 1 and 200");
    pointsPerLink_ = points;
}

void HPPM::setRepulsion(const std::string &list)
{
    const Eigen::VectorXd values = parseVector(list);
    const auto obstacles = static_cast<Eigen::Index>(model_->obstacles.size());
    require(values.size() == 1 || (values.size() > 0 && values.size() == obstacles),
            fmt::format("repulsion needs one number for all obstacles or one for each of the {}", obstacles));
    repulsion_ = values;
}

std::string HPPM::getRepulsion() const
{
    return toText(repulsion_.transpose());
}

void HPPM::setRows(const std::string &rows)
{
    const Eigen::MatrixXd values = parseMatrix(rows);
    const auto n = static_cast<Eigen::Index>(model_->arm.dimension());
    require(values.size() == 0 || (values.rows() == n && values.cols() == n),
            fmt::format("rows needs {0} rows of {0} numbers, not {1} of {2}", n, values.rows(), values.cols()));
    rows_ = values;
    direction_.resize(0);
}

std::string HPPM::getRows() const
{
    return toText(rows_);
}

void HPPM::setDirection(const std::string &list)
{
    const Eigen::VectorXd values = parseVector(list);
    const auto n = static_cast<Eigen::Index>(model_->arm.dimension());
    require(values.size() == 0 || values.size() == n,
            fmt::format("direction needs {} numbers, not {}", n, values.size()));
    require(values.size() == 0 || values.norm() > 0.0, "direction must not vanish");
    direction_ = values;
}

std::string HPPM::getDirection() const
{
    return toText(direction_.transpose());
}

void HPPM::setStrength(double strength)
{
    require(std::abs(strength) > 0.0 && std::abs(strength) <= 100.0, "strength must be neither 0 nor beyond +-100");
    strength_ = strength;
}

void HPPM::setRadius(double radius)
{
    require(radius >= 1e-4 && radius <= 1.0, "radius must lie between 0.0001 and 1");
    spheres_.radius = radius;
}

void HPPM::setOrientation(const std::string &orientation)
{
    require(orientation == "increasing" || orientation == "decreasing",
            "orientation is increasing or decreasing, not \"" + orientation + "\"");
    window_.decreasing = orientation == "decreasing";
}

void HPPM::setLambdaMin(double lambda)
{
    require(lambda >= -10.0 && lambda <= -0.001, "lambda_min must lie between -10 and -0.001");
    window_.lambdaMin = lambda;
}

void HPPM::setLambdaMax(double lambda)
{
    require(lambda >= 1.0 && lambda <= 10.0, "lambda_max must lie between 1 and 10");
    window_.lambdaMax = lambda;
}

void HPPM::setMaxStep(double step)
{
    require(step >= 1e-4 && step <= 1.0, "max_step must lie between 0.0001 and 1");
    plane_.maxStep = step;
}
}  // namespace narrows
