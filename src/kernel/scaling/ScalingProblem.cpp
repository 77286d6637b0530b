// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/scaling/ScalingProblem.h"

#include <numeric>

namespace narrows
{
double ScalingProblem::reach() const
{
    return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

std::vector<double> ScalingProblem::fractions() const
{
    std::vector<double> result{0.0};
    double sum = 0.0;
    for (const double length : lengths)
        result.push_back(sum += length);
    for (double &fraction : result)
        fraction /= sum;
    return result;
}

Eigen::Matrix3d slideAxes(const ChainGeometry &chain)
{
    Eigen::Matrix3d axes = chain.axes;
    // At zero all links point along the world's x.
    if (axes(0, 0) < 0.0)
    {
        axes.col(0) *= -1.0;
        axes.col(1) *= -1.0;
    }
    return axes;
}

ScalingProblem scalingProblem(const ChainGeometry &chain)
{
    const Eigen::Matrix3d axes = slideAxes(chain);
    ScalingProblem problem;
    problem.lengths = chain.lengths;
    problem.radius = chain.radius;
    problem.maxAngle = chain.maxAngle;
    const bool reversed = axes.col(0) != chain.axes.col(0);
    problem.slide = reversed ? Interval{-chain.slide.upper, -chain.slide.lower} : chain.slide;
    problem.forward = axes.transpose() * Eigen::Vector3d::UnitX();
    return problem;
}

std::string toText(ScalingFailure failure)
{
    switch (failure)
    {
        case ScalingFailure::None:
            break;
        case ScalingFailure::Reach:
            return "reach";
        case ScalingFailure::Slide:
            return "slide";
        case ScalingFailure::BaseBlocked:
            return "base_blocked";
        case ScalingFailure::TipBlocked:
            return "tip_blocked";
        case ScalingFailure::NoCandidate:
            return "no_candidate";
        case ScalingFailure::Span:
            return "span";
        case ScalingFailure::LinkAngle:
            return "link_angle";
        case ScalingFailure::LinkClearance:
            return "link_clearance";
        case ScalingFailure::Jump:
            return "jump";
        case ScalingFailure::Overlap:
            return "overlap";
    }
    return "";
}
}  // namespace narrows
