// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/CurveTracker.h"
#include "kernel/TangentSpace.h"

namespace narrows
{
/// Single steps along a curve, with everything that can refuse one; when to take which is the tracker's business.
/// \tparam Unknowns n + 1, or Eigen::Dynamic
template <int Unknowns>
class CurveStepper
{
public:
    using Vector = typename TangentSpace<Unknowns>::Vector;

    struct Point
    {
        Vector z, tangent;
        Vector bend;             ///< the curve's second derivative over its length, as the step to this point shows it
        double determinant;      ///< augmented
        double turn = 0.0;       ///< radians, on the step to this point
        double poleRatio = 1.0;  ///< the least quotient of an obstacle function here and before that step
        double contraction = 0.0;  ///< of that step's second correction; 0: one was enough
        CurvePoint curve;
    };

    CurveStepper(const HomotopyCurve &curve, const TrackerOptions &options) : curve_(curve), options_(options) {}

    /// Evaluates the homotopy at point.z; false if the curve has no tangent there.
    bool evaluate(Point &point)
    {
        point.curve.z = point.z;
        curve_.evaluate(point.curve);
        ++evaluations;
        return space_.factor(point.curve.jacobian);
    }

    /// Of the point that was evaluated last.
    void takeTangent(Point &point)
    {
        space_.tangent(point.tangent);
        point.tangent *= side;
        point.determinant = space_.determinant();
    }

    /// A step of this length along the curve (back, if it is negative), or what refuses it.
    std::optional<StepLimit> advance(const Point &from, double length, Point &to)
    {
        to.z = from.z + length * (from.tangent + 0.5 * length * from.bend);
        if (const std::optional<StepLimit> refusal = correct(std::abs(length), to))
            return refusal;
        takeTangent(to);
        const double cosine = from.tangent.dot(to.tangent);
        to.bend = cosine * to.tangent - from.tangent;
        const double sine = to.bend.norm();
        to.turn = std::atan2(sine, cosine);
        if (!(to.turn <= options_.maxTurn))
            return StepLimit::Turn;
        to.bend *= (sine > 1e-9 ? to.turn / sine : 1.0) / length;
        const double ratio = to.determinant / from.determinant;
        if (!(std::max(ratio, 1.0 / ratio) <= options_.maxDeterminantRatio))
            return StepLimit::Determinant;
        return keepOffPoles(from, to);
    }

    /// Newton's method from point.z to the curve, as part of a step of this length. Jacobian and poles stay those of
    /// the last evaluation, before the last update.
    std::optional<StepLimit> correct(double length, Point &point)
    {
        Vector update;
        double corrected = 0.0, before = 0.0;
        point.contraction = 0.0;
        for (corrections = 1;; ++corrections)
        {
            if (!evaluate(point))
                return StepLimit::Correction;
            space_.solve(point.curve.residual, update);
            const double size = update.norm();
            corrected += size;
            // Written so that a NaN is refused too.
            if (!(corrected <= options_.maxCorrection * length))
                return StepLimit::Correction;
            if (corrections > 1 && size > options_.contraction * before)
                return StepLimit::Contraction;
            if (corrections == 2)
                point.contraction = size / before;
            point.z -= update;
            // A first correction has no other to show that the method converges: it must be far shorter to be trusted.
            if (size <= (corrections > 1 ? 1.0 : options_.tolerance * options_.tolerance) * options_.tolerance * length)
                break;
            before = size;
        }
        place(point);
        return std::nullopt;
    }

    /// Moves a point that is near the curve onto it, exactly enough for steps of this length: the step that led there
    /// may have been so long that what it left of error is long for them.
    void settle(Point &point, double length)
    {
        Vector update;
        for (int i = 0; i < 8; ++i)
        {
            if (!evaluate(point))
                return;
            space_.solve(point.curve.residual, update);
            const double size = update.norm();
            if (!(size <= options_.maxCorrection * length))
                return;
            takeTangent(point);
            point.z -= update;
            if (size <= options_.tolerance * length)
                break;
        }
        place(point);
    }

    /// Whether the curve, from one point to the next, leads through a solution of the homotopy, to within `tolerance`:
    /// follows it to the foot of `target`, again and again, under the same limits as every step.
    bool leadsThrough(const Point &from, const Point &to, const Vector &target, double tolerance)
    {
        const Vector chord = to.z - from.z;
        const double length = chord.norm();
        const double part = chord.dot(target - from.z) / (length * length);
        // A curve that turns by less than 0.7 stays within 0.09 of its chord.
        if (!(part > -0.1 && part < 1.1 && (from.z + part * chord - target).norm() < 0.25 * length))
            return false;
        const double near = std::min(tolerance, 0.01 * length);
        probe_ = from;
        for (int i = 0; i < 30; ++i)
        {
            const Vector rest = target - probe_.z;
            const double distance = rest.norm();
            if (distance <= near)
                return true;
            double along = probe_.tangent.dot(rest);
            if (std::abs(along) < 0.5 * distance)
                return false;
            while (advance(probe_, along, next_))
                if (std::abs(along *= 0.5) < options_.minStep)
                    return false;
            std::swap(probe_, next_);
        }
        return false;
    }

    double side = 1.0;  ///< sign of the augmented determinant: which way is forward
    int evaluations = 0;
    int corrections = 0;         ///< of the last step
    Eigen::Index lastPole = -1;  ///< that refused a step

private:
    void place(Point &point)
    {
        point.curve.z = point.z;
        curve_.configuration(point.curve.z, point.curve.w);
    }

    /// A pole is infinite on the obstacle's boundary but thin where its strength is small: a step must not jump over
    /// it.
    std::optional<StepLimit> keepOffPoles(const Point &from, Point &to)
    {
        const auto count = static_cast<Eigen::Index>(to.curve.poles.size());
        to.poleRatio = 1.0;
        if (count == 0)
            return std::nullopt;
        const Eigen::Map<const Eigen::ArrayXd> now(to.curve.poles.data(), count), then(from.curve.poles.data(), count);
        const double least = (now / then).minCoeff();
        if (!(least >= options_.poleShrink && now.minCoeff() > 0.0))
        {
            (now / then).minCoeff(&lastPole);
            return StepLimit::Pole;
        }
        to.poleRatio = std::min(1.0, least);
        return std::nullopt;
    }

    const HomotopyCurve &curve_;
    const TrackerOptions &options_;
    TangentSpace<Unknowns> space_;
    Point probe_, next_;
};
}  // namespace narrows
