// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/CurveTracker.h"

#include <stdexcept>

#include "kernel/CurveStepper.h"

namespace narrows
{
namespace
{
template <int Unknowns>
class Tracker
{
public:
    Tracker(const HomotopyCurve &curve, const TrackerOptions &options, Trace &trace)
      : curve_(curve),
        options_(options),
        trace_(trace),
        stepper_(curve, options),
        scale_(curve.lambdaScale()),
        goal_(curve.goalPoint())
    {
    }

    void run(const std::function<bool()> &interrupt)
    {
        trace_.status = follow(interrupt);
        trace_.evaluations = stepper_.evaluations;
        trace_.lastPole = static_cast<int>(stepper_.lastPole);
    }

private:
    using Vector = typename CurveStepper<Unknowns>::Vector;
    using Point = typename CurveStepper<Unknowns>::Point;

    TraceStatus follow(const std::function<bool()> &interrupt)
    {
        if (const std::optional<TraceStatus> fault = begin())
            return *fault;
        double length = std::min(options_.firstStep, options_.maxStep);
        double growth = 2.0;
        StepLimit limit = StepLimit::Growth;
        while (trace_.steps + trace_.rejected < options_.maxSteps)
        {
            if (interrupt && interrupt())
                return TraceStatus::Interrupted;
            bool arrives = false;
            const std::optional<StepLimit> refusal = step(length, arrives);
            record(length, refusal, limit);
            if (refusal)
            {
                length *= 0.5;
                if (length < shortest())
                    return TraceStatus::StepUnderflow;
                stepper_.settle(here_, length);
                limit = *refusal;
                growth = 1.0;  // what has just failed is not tried again at once
                continue;
            }
            trace_.folds += lambdaRate(here_) * lambdaRate(there_) < 0.0;
            std::swap(here_, there_);
            keep(here_);
            if (const std::optional<TraceStatus> end = arrives ? TraceStatus::ReachedGoal : left())
                return *end;
            length = nextLength(length, growth, limit);
            growth = 2.0;
        }
        return TraceStatus::MaxSteps;
    }

    std::optional<TraceStatus> begin()
    {
        here_.z = curve_.startPoint();
        here_.bend = Vector::Zero(here_.z.size());
        const bool regular = stepper_.evaluate(here_);
        start_ = here_.curve.w;
        keep(here_);
        for (const double pole : here_.curve.poles)
            if (!(pole > 0.0))
                return TraceStatus::InvalidStart;
        if (!regular)
            return TraceStatus::Singular;
        stepper_.takeTangent(here_);
        if ((lambdaRate(here_) < 0.0) != options_.window.decreasing)
            stepper_.side = -1.0;
        stepper_.takeTangent(here_);
        origin_ = here_.z;
        heading_ = here_.tangent;
        return std::nullopt;
    }

    double shortest() const
    {
        if (options_.endShare == 0.0)
            return options_.minStep;
        const double nearer = std::min((here_.z - origin_).norm(), (here_.z - goal_).norm());
        return std::max(options_.minStep, options_.endShare * nearer);
    }

    double lambda(const Point &point) const { return point.z[point.z.size() - 1] / scale_; }
    static double lambdaRate(const Point &point) { return point.tangent[point.z.size() - 1]; }

    void keep(const Point &point)
    {
        trace_.configurations.push_back(point.curve.w);
        trace_.lambdas.push_back(lambda(point));
    }

    void record(double length, std::optional<StepLimit> refusal, StepLimit limit)
    {
        if (refusal)
        {
            ++trace_.rejected;
            ++trace_.rejectedBy[static_cast<int>(*refusal)];
            trace_.lastRejection = refusal;
        }
        else
        {
            ++trace_.steps;
            ++trace_.limitedBy[static_cast<int>(limit)];
        }
        if (options_.log)
            trace_.log.push_back({there_.z, length, !refusal, refusal.value_or(limit), stepper_.corrections});
    }

    /// As long as no limit should come close, if the curve goes on as it went on the last step. Turns and the fall of
    /// obstacle functions grow with the length, the corrector's contraction with its cube, as does the prediction's
    /// error.
    double nextLength(double last, double growth, StepLimit &limit) const
    {
        limit = StepLimit::Growth;
        double length = growth * last;
        const auto cut = [&](double most, StepLimit reason)
        {
            if (most < length)
            {
                length = most;
                limit = reason;
            }
        };
        cut(options_.maxStep, StepLimit::Longest);
        cut(0.6 * options_.maxTurn / std::max(here_.turn, 1e-9) * last, StepLimit::Turn);
        cut((1.0 - options_.poleShrink) * last / std::max(1.0 / here_.poleRatio - 1.0, 1e-9), StepLimit::Pole);
        if (here_.contraction > 0.0)
            cut(std::cbrt(0.25 * options_.contraction / here_.contraction) * last, StepLimit::Contraction);
        return length;
    }

    /// The next point of the curve in there_, which is the goal if the curve leads through it on the way.
    std::optional<StepLimit> step(double length, bool &arrives)
    {
        if (const std::optional<StepLimit> refusal = stepper_.advance(here_, length, there_))
            return refusal;
        arrives = stepper_.leadsThrough(here_, there_, goal_, options_.window.goalTolerance);
        if (arrives)
        {
            there_.curve.z = there_.z = goal_;
            curve_.configuration(there_.curve.z, there_.curve.w);
        }
        if (options_.guard && !options_.guard(here_.curve.w, there_.curve.w))
            return StepLimit::Guard;
        return std::nullopt;
    }

    /// After a step: here_ is the new point, there_ the one before.
    std::optional<TraceStatus> left()
    {
        const double now = lambda(here_);
        if ((now < 1.0) != (lambda(there_) < 1.0))
        {
            ++trace_.wrongRoots;
            if (!(options_.window.lambdaMax > 1.0))
                return TraceStatus::WrongRoot;
        }
        const double deviation = (here_.curve.w - start_).norm();
        const std::optional<TraceStatus> end = departure(options_.window, now, deviation, trace_.wrongRoots);
        if (!end && trace_.steps >= 3 && here_.tangent.dot(heading_) > 0.0 &&
            stepper_.leadsThrough(here_, there_, origin_, options_.window.goalTolerance))
            return TraceStatus::ClosedLoop;
        return end;
    }

    const HomotopyCurve &curve_;
    const TrackerOptions &options_;
    Trace &trace_;
    CurveStepper<Unknowns> stepper_;
    const double scale_;
    const Vector goal_;
    Vector origin_, heading_;  ///< z and tangent at the start
    Eigen::VectorXd start_;
    Point here_, there_;
};

void checkOptions(const TrackerOptions &o)
{
    if (!(o.minStep > 0.0 && o.firstStep >= o.minStep && o.maxStep >= o.minStep))
        throw std::invalid_argument("steps must be positive, and none smaller than the smallest");
    for (const double part : {o.contraction, o.poleShrink, o.tolerance})
        if (!(part > 0.0 && part < 1.0))
            throw std::invalid_argument("contraction, poleShrink and tolerance must lie between 0 and 1");
    if (!(o.maxCorrection > 0.0 && o.maxTurn > 0.0 && o.maxSteps > 0))
        throw std::invalid_argument(
            "the largest correction, the largest turn and the number of steps must be positive");
    if (!(o.endShare >= 0.0 && o.endShare < 1.0))
        throw std::invalid_argument("endShare must lie from 0 to less than 1");
    if (!(o.maxDeterminantRatio > 1.0))
        throw std::invalid_argument("the determinant must be allowed to change: maxDeterminantRatio > 1");
    checkWindow(o.window);
}
}  // namespace

Trace track(const HomotopyCurve &curve, const TrackerOptions &options, const std::function<bool()> &interrupt)
{
    checkOptions(options);
    Trace trace;
    if (standsStill(curve, trace))
        return trace;
    if (curve.equations() == 1)
        Tracker<2>(curve, options, trace).run(interrupt);
    else if (curve.equations() == 2)
        Tracker<3>(curve, options, trace).run(interrupt);
    else
        Tracker<Eigen::Dynamic>(curve, options, trace).run(interrupt);
    return trace;
}
}  // namespace narrows
