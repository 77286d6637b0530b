// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PlaneTracker.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace narrows
{
using Eigen::Vector2d;

namespace
{
/// A point of the curve: where, which way Phi grows, and the obstacle functions there.
struct CurvePoint
{
    Vector2d x;         ///< (|D| lambda, s)
    Vector2d gradient;  ///< of Phi over x
    double residual;    ///< Phi
    ArmRepulsion::Sample sample;
    Eigen::VectorXd w;
};

class Plane
{
public:
    Plane(const ArmHomotopy &homotopy, const PlaneOptions &options, Trace &trace)
      : homotopy_(homotopy), options_(options), trace_(trace), scale_(homotopy.difference().norm())
    {
    }

    void run(const std::function<bool()> &interrupt)
    {
        evaluate(Vector2d::Zero(), here_);
        keep(here_);
        // Turned by +90 or -90 degrees, the gradient is the tangent; which one is settled here and never again.
        side_ = (here_.gradient.y() > 0.0) != options_.window.decreasing ? 1.0 : -1.0;
        if (!(here_.gradient.norm() > 0.0))
            return stop(TraceStatus::Singular);

        double step = std::min(options_.firstStep, options_.maxStep);
        while (trace_.steps + trace_.rejected < options_.maxSteps)
        {
            if (interrupt && interrupt())
                return stop(TraceStatus::Interrupted);
            double turn;
            if (!advance(step, turn))
            {
                ++trace_.rejected;
                step *= 0.5;
                if (step < options_.minStep)
                    return stop(TraceStatus::StepUnderflow);
                continue;
            }
            ++trace_.steps;
            curvature_ = turn / step;
            if (crossed() && endGame())
                return;
            std::swap(here_, there_);
            keep(here_);
            if (left())
                return;
            // As long as the next turn should be well within what is allowed, if the curve goes on bending like this.
            const double wanted = 0.6 * options_.maxTurn / std::max(std::abs(curvature_), 1e-9);
            step = std::min({wanted, 2.0 * step, options_.maxStep});
        }
        stop(TraceStatus::MaxSteps);
    }

private:
    void stop(TraceStatus status) { trace_.status = status; }

    void keep(const CurvePoint &point)
    {
        trace_.configurations.push_back(point.w);
        trace_.lambdas.push_back(point.x.x() / scale_);
    }

    void move(CurvePoint &point, const Vector2d &x)
    {
        point.x = x;
        homotopy_.planePoint(x.x() / scale_, x.y(), point.w);
    }

    void evaluate(const Vector2d &x, CurvePoint &point)
    {
        move(point, x);
        homotopy_.repulsion().evaluate(point.w, point.sample);
        ++trace_.evaluations;
        point.residual = homotopy_.planeResidual(x.x() / scale_, x.y(), point.sample);
        point.gradient = homotopy_.planeGradient(point.sample);
        point.gradient.x() /= scale_;
    }

    Vector2d tangent(const CurvePoint &point) const
    {
        return side_ * Vector2d(point.gradient.y(), -point.gradient.x()).normalized();
    }

    /// Tries a step from here_ to there_; `turn` becomes the angle between the tangents.
    bool advance(double step, double &turn)
    {
        const Vector2d heading = tangent(here_);
        const Vector2d across(-heading.y(), heading.x());
        evaluate(here_.x + step * (heading + 0.5 * step * curvature_ * across), there_);
        double corrected = 0.0;
        double limit = options_.maxCorrection * step;
        while (true)
        {
            const Vector2d update = there_.residual / there_.gradient.squaredNorm() * there_.gradient;
            const double size = update.norm();
            corrected += size;
            // Written so that a NaN is refused too.
            if (!(size <= limit && corrected <= options_.maxCorrection * step))
                return false;
            if (size <= options_.tolerance * step)
            {
                move(there_, there_.x - update);
                break;
            }
            evaluate(there_.x - update, there_);
            limit = options_.contraction * size;
        }
        const Vector2d after = tangent(there_);
        turn = std::atan2(across.dot(after), heading.dot(after));
        return std::abs(turn) <= options_.maxTurn && keepsOffPoles();
    }

    /// A pole is infinite on the obstacle's boundary but thin where its strength is small: a step must not jump over
    /// it.
    bool keepsOffPoles() const
    {
        for (std::size_t i = 0; i < there_.sample.poles.size(); ++i)
            if (there_.sample.poles[i] < options_.poleShrink * here_.sample.poles[i])
                return false;
        return true;
    }

    bool crossed() const { return (here_.x.x() - scale_) * (there_.x.x() - scale_) <= 0.0; }

    /// Finds s on the crossing of lambda = 1 between here_ and there_, by the secant of Phi kept within the step's
    /// length, and says whether the trace is over.
    bool endGame()
    {
        const double t = (scale_ - here_.x.x()) / (there_.x.x() - here_.x.x());
        const double guess = here_.x.y() + t * (there_.x.y() - here_.x.y());
        const double reach = (there_.x - here_.x).norm();  // a root further off than this is another crossing's
        double s = guess;
        for (int i = 0; i < 30 && std::abs(guess) <= reach; ++i)
        {
            evaluate(Vector2d(scale_, s), root_);
            const double update = root_.residual / root_.gradient.y();
            if (!std::isfinite(update))
                break;
            s -= update;
            if (std::abs(update) <= 1e-12)
                break;
        }
        if (std::abs(s - guess) <= reach && std::abs(s) <= options_.window.goalTolerance)
        {
            trace_.configurations.push_back(homotopy_.goal());
            trace_.lambdas.push_back(1.0);
            stop(TraceStatus::ReachedGoal);
            return true;
        }
        ++trace_.wrongRoots;
        if (options_.window.lambdaMax > 1.0)
            return false;
        keep(there_);
        stop(TraceStatus::WrongRoot);
        return true;
    }

    bool left()
    {
        const double deviation = (here_.w - homotopy_.start()).norm();
        std::optional<TraceStatus> end = departure(options_.window, here_.x.x() / scale_, deviation, trace_.wrongRoots);
        if (!end && passedStart())
            end = TraceStatus::ClosedLoop;
        if (end)
            stop(*end);
        return end.has_value();
    }

    /// Does the last step lead through the start again?
    bool passedStart() const
    {
        if (trace_.steps < 3)
            return false;
        const Vector2d step = here_.x - there_.x;  // swapped: there_ is the point before
        const double along = -there_.x.dot(step) / step.squaredNorm();
        return along >= 0.0 && along <= 1.0 && (there_.x + along * step).norm() < 0.1 * step.norm();
    }

    const ArmHomotopy &homotopy_;
    const PlaneOptions &options_;
    Trace &trace_;
    const double scale_;  ///< |D|
    double side_ = 1.0;
    double curvature_ = 0.0;  ///< of the last step, radians per length, positive to the left
    CurvePoint here_, there_, root_;
};

void checkOptions(const PlaneOptions &o)
{
    if (!(o.minStep > 0.0 && o.firstStep >= o.minStep && o.maxStep >= o.minStep))
        throw std::invalid_argument("steps must be positive, and none smaller than the smallest");
    for (const double part : {o.contraction, o.poleShrink, o.tolerance})
        if (!(part > 0.0 && part < 1.0))
            throw std::invalid_argument("contraction, poleShrink and tolerance must lie between 0 and 1");
    if (!(o.maxCorrection > 0.0 && o.maxTurn > 0.0 && o.maxSteps > 0))
        throw std::invalid_argument(
            "the largest correction, the largest turn and the number of steps must be positive");
    checkWindow(o.window);
}
}  // namespace

Trace tracePlane(const ArmHomotopy &homotopy, const PlaneOptions &options, const std::function<bool()> &interrupt)
{
    checkOptions(options);
    if (homotopy.difference().norm() == 0.0)
        return standStill(homotopy.start());
    Trace trace;
    Plane(homotopy, options, trace).run(interrupt);
    return trace;
}
}  // namespace narrows
