// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

#include "kernel/LinkTerm.h"

namespace narrows
{
/// A function of where two links lie, and its derivative.
struct PairTerm
{
    double value = 0.0;  ///< of the function
    LinkForce first;     ///< its derivative by the first link
    LinkForce second;    ///< its derivative by the second
};

/// A stand-in for the least of several distances d_k, less a radius: e with
///   e (e + 2 radius) = (sum of F_k^-2)^(-1/2),   F_k = d_k^2 - radius^2.
/// It is smooth where the minimum has kinks, never more than the minimum, and 0 with it.
class SmoothMinimum
{
public:
    /// \param radius by which both sides of the minimum are thicker than they are drawn
    explicit SmoothMinimum(double radius) : radius_(radius) {}

    /// \param apart from a resting point to that of the link at `fraction`
    void add(const Eigen::Vector2d &apart, double fraction) { push(apart, fraction); }
    /// \param apart from the point of the second link, at `other` of it, to that of the first link, at `fraction`
    void add(const Eigen::Vector2d &apart, double fraction, double other)
    {
        otherLever_ -= other * push(apart, fraction);
    }

    /// Have all distances been more than the radius?
    bool positive() const { return least_ > 0.0; }

    /// e, provided that it is positive, and its derivative by the first link.
    LinkTerm value() const
    {
        double factor;
        const double value = scale(factor);
        return {value, first_.times(factor)};
    }

    /// The same by both links.
    PairTerm pairValue() const
    {
        double factor;
        const double value = scale(factor);
        return {value, first_.times(factor), LinkForce{-first_.force, otherLever_}.times(factor)};
    }

private:
    Eigen::Vector2d push(const Eigen::Vector2d &apart, double fraction)
    {
        const double excess = apart.squaredNorm() - radius_ * radius_;
        least_ = std::min(least_, excess);
        const double inverse = 1.0 / excess;
        const double square = inverse * inverse;
        sum_ += square;
        const Eigen::Vector2d pull = square * inverse * apart;
        first_.push(fraction, pull);
        return pull;
    }

    /// e, and what turns the sums of F_k^-3 dF_k / 2 into its derivative.
    double scale(double &factor) const
    {
        const double excess = 1.0 / std::sqrt(sum_);
        const double root = std::sqrt(excess + radius_ * radius_);
        factor = excess * excess * excess / root;
        return excess / (root + radius_);
    }

    double radius_;
    double sum_ = 0.0;
    double least_ = std::numeric_limits<double>::infinity();
    LinkForce first_;
    Eigen::Vector2d otherLever_ = Eigen::Vector2d::Zero();
};
}  // namespace narrows
