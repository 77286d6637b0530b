// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "planners/NumberList.h"
#include "planners/Require.h"
#include "planners/ViaPointHomotopy.h"

namespace narrows
{
namespace
{
constexpr int mostEvaluations = 1'000'000;

std::string textOf(const Eigen::VectorXd &values)
{
    return toText(Eigen::MatrixXd(values.transpose()));
}
}  // namespace

void ViaPointHomotopy::declareParameters()
{
    declareParam<std::string>("mode", this, &ViaPointHomotopy::setMode, &ViaPointHomotopy::getMode, "smooth,polyline");
    declareParam<std::string>("velocity", this, &ViaPointHomotopy::setVelocity, &ViaPointHomotopy::getVelocity);
    declareParam<std::string>("acceleration", this, &ViaPointHomotopy::setAcceleration,
                              &ViaPointHomotopy::getAcceleration);
    declareParam<std::string>("jerk", this, &ViaPointHomotopy::setJerk, &ViaPointHomotopy::getJerk);
    declareParam<int>("evaluations", this, &ViaPointHomotopy::setEvaluations, &ViaPointHomotopy::getEvaluations,
                      "0:100:1000000");
    declareParam<double>("margin", this, &ViaPointHomotopy::setMargin, &ViaPointHomotopy::getMargin, "0.:1.:1000.");
    declareParam<int>("via_attempts", this, &ViaPointHomotopy::setViaAttempts, &ViaPointHomotopy::getViaAttempts,
                      "0:10:1000000");
    declareParam<double>("range", this, &ViaPointHomotopy::setRange, &ViaPointHomotopy::getRange, "0.:1.:10000.");
}

void ViaPointHomotopy::setMode(const std::string &mode)
{
    smooth_ = oneOf({"smooth", "polyline"}, mode, "mode") == "smooth";
}

Eigen::VectorXd ViaPointHomotopy::limitsFrom(const std::string &text, const char *name) const
{
    const Eigen::VectorXd values = parseVector(text);
    require(values.size() == 1 || values.size() == static_cast<Eigen::Index>(si_->getStateDimension()),
            std::string(name) + " takes one number, or one for each joint");
    require(values.allFinite() && (values.array() > 0.0).all(), std::string(name) + " must be positive and finite");
    return values;
}

void ViaPointHomotopy::setVelocity(const std::string &limits)
{
    velocity_ = limitsFrom(limits, "velocity");
}

std::string ViaPointHomotopy::getVelocity() const
{
    return textOf(velocity_);
}

void ViaPointHomotopy::setAcceleration(const std::string &limits)
{
    acceleration_ = limitsFrom(limits, "acceleration");
}

std::string ViaPointHomotopy::getAcceleration() const
{
    return textOf(acceleration_);
}

void ViaPointHomotopy::setJerk(const std::string &limits)
{
    jerk_ = limitsFrom(limits, "jerk");
}

std::string ViaPointHomotopy::getJerk() const
{
    return textOf(jerk_);
}

void ViaPointHomotopy::setEvaluations(int count)
{
    evaluations_ = within(0, count, mostEvaluations, "evaluations");
}

void ViaPointHomotopy::setMargin(double margin)
{
    margin_ = notNegative(margin, "margin");
}

void ViaPointHomotopy::setViaAttempts(int count)
{
    viaAttempts_ = within(0, count, mostEvaluations, "via_attempts");
}

void ViaPointHomotopy::setRange(double range)
{
    range_ = notNegative(range, "range");
}

std::vector<MotionLimits> ViaPointHomotopy::limits() const
{
    const auto of = [](const Eigen::VectorXd &values, Eigen::Index joint)
    {
        return values[values.size() == 1 ? 0 : joint];
    };
    std::vector<MotionLimits> result;
    for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(si_->getStateDimension()); ++i)
        result.push_back({of(velocity_, i), of(acceleration_, i), of(jerk_, i)});
    return result;
}
}  // namespace narrows
