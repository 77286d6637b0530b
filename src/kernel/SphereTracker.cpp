// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SphereTracker.h"

#include <cmath>
#include <stdexcept>

#include <Eigen/LU>
#include <Eigen/QR>

namespace narrows
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
class Spheres
{
public:
    Spheres(const HomotopyCurve &curve, const SphereOptions &options, Trace &trace)
      : curve_(curve), options_(options), trace_(trace), n_(curve.equations()), goal_(curve.goalPoint())
    {
        curve.configuration(curve.startPoint(), start_);
    }

    void run(const std::function<bool()> &interrupt)
    {
        VectorXd previous, center = curve_.startPoint(), next;
        keep(center);
        VectorXd heading = VectorXd::Zero(n_ + 1);
        heading[n_] = options_.window.decreasing ? -1.0 : 1.0;
        while (trace_.steps < options_.maxSpheres)
        {
            if (interrupt && interrupt())
                return stop(TraceStatus::Interrupted);
            if (trace_.steps < 2)
            {
                if (!tangent(center, heading))
                    return stop(TraceStatus::Singular);
            }
            else
                heading = (center - previous).normalized();
            if (!correct(center, center + options_.radius * heading, next))
                return stop(TraceStatus::CorrectorFailed);
            ++trace_.steps;
            previous = center;
            center = next;
            if (crossed(previous, center) && endGame(previous, center))
                return;
            keep(center);
            if (left(center))
                return;
        }
        stop(TraceStatus::MaxSteps);
    }

private:
    void stop(TraceStatus status) { trace_.status = status; }

    double lambda(const VectorXd &z) const { return z[n_] / curve_.lambdaScale(); }

    void keep(const VectorXd &z)
    {
        trace_.configurations.emplace_back();
        curve_.configuration(z, trace_.configurations.back());
        trace_.lambdas.push_back(lambda(z));
    }

    void evaluate(const VectorXd &z)
    {
        point_.z = z;
        curve_.evaluate(point_);
        ++trace_.evaluations;
    }

    /// Turns `heading` into the unit tangent of the curve at z that points the
    /// same way.
    bool tangent(const VectorXd &z, VectorXd &heading)
    {
        evaluate(z);
        if (!point_.jacobian.allFinite())
            return false;
        const Eigen::ColPivHouseholderQR<MatrixXd> qr(point_.jacobian.transpose());
        if (qr.rank() < n_)
            return false;
        const MatrixXd basis = qr.householderQ();
        const VectorXd direction = basis.col(n_);
        heading = direction.dot(heading) < 0.0 ? VectorXd(-direction) : direction;
        return true;
    }

    /// H and the sphere's equation (Eq. 28) at z.
    void system(const VectorXd &z, const VectorXd &center, VectorXd &f)
    {
        evaluate(z);
        f.resize(n_ + 1);
        f << point_.residual, (z - center).squaredNorm() - options_.radius * options_.radius;
    }

    /// Broyden's good method, inverse update.
    bool correct(const VectorXd &center, const VectorXd &predicted, VectorXd &z)
    {
        z = predicted;
        VectorXd f, next;
        system(z, center, f);
        MatrixXd full(n_ + 1, n_ + 1);
        full << point_.jacobian, 2.0 * (z - center).transpose();
        if (!full.allFinite())
            return false;
        MatrixXd inverse = full.partialPivLu().inverse();
        for (int i = 0; i < options_.maxCorrections; ++i)
        {
            const VectorXd step = -inverse * f;
            // Written so that a NaN is refused too. A point further off than this is
            // another piece of the curve.
            if (!(step.norm() <= 4.0 * options_.radius))
                return false;
            z += step;
            if (step.norm() <= options_.tolerance)
                return true;
            system(z, center, next);
            const VectorXd update = inverse * (next - f);
            const double denominator = step.dot(update);
            if (denominator == 0.0)
                return false;
            inverse += (step - update) * (step.transpose() * inverse) / denominator;
            f = next;
        }
        return false;
    }

    bool crossed(const VectorXd &from, const VectorXd &to) const
    {
        return (lambda(from) - 1.0) * (lambda(to) - 1.0) <= 0.0;
    }

    /// Refines the root at lambda = 1 and says whether the trace is over.
    bool endGame(const VectorXd &from, const VectorXd &to)
    {
        const double t = (goal_[n_] - from[n_]) / (to[n_] - from[n_]);
        VectorXd root = from + t * (to - from);
        root[n_] = goal_[n_];
        for (int i = 0; i < options_.maxCorrections; ++i)
        {
            evaluate(root);
            const VectorXd step = point_.jacobian.leftCols(n_).partialPivLu().solve(point_.residual);
            if (!step.allFinite())
                break;
            root.head(n_) -= step;
            if (step.norm() <= options_.tolerance)
                break;
        }
        if ((root - goal_).norm() <= options_.window.goalTolerance)
        {
            keep(goal_);
            stop(TraceStatus::ReachedGoal);
            return true;
        }
        ++trace_.wrongRoots;
        if (options_.window.lambdaMax > 1.0)
            return false;
        keep(to);
        stop(TraceStatus::WrongRoot);
        return true;
    }

    bool left(const VectorXd &z)
    {
        const double deviation = (trace_.configurations.back() - start_).norm();
        std::optional<TraceStatus> end = departure(options_.window, lambda(z), deviation, trace_.wrongRoots);
        if (!end && trace_.steps > 3 && (z - curve_.startPoint()).norm() < 0.5 * options_.radius)
            end = TraceStatus::ClosedLoop;
        if (end)
            stop(*end);
        return end.has_value();
    }

    const HomotopyCurve &curve_;
    const SphereOptions &options_;
    Trace &trace_;
    const int n_;
    const VectorXd goal_;
    VectorXd start_;
    CurvePoint point_;
};
}  // namespace

Trace traceSpheres(const HomotopyCurve &curve, const SphereOptions &options, const std::function<bool()> &interrupt)
{
    if (!(options.radius > 0.0))
        throw std::invalid_argument("the hyperspheres' radius must be positive");
    if (options.maxSpheres < 1 || options.maxCorrections < 1 || !(options.tolerance > 0.0))
        throw std::invalid_argument(
            "the numbers of spheres and corrections and "
            "the tolerance must be positive");
    checkWindow(options.window);
    Trace trace;
    if (standsStill(curve, trace))
        return trace;
    Spheres(curve, options, trace).run(interrupt);
    return trace;
}
}  // namespace narrows
