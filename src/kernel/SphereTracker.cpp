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
    Spheres(const ArmHomotopy &homotopy, const SphereOptions &options, Trace &trace)
      : homotopy_(homotopy), options_(options), trace_(trace), n_(homotopy.dimension())
    {
    }

    void run(const std::function<bool()> &interrupt)
    {
        VectorXd previous, center(n_ + 1), next;
        center << homotopy_.start(), 0.0;
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

    void keep(const VectorXd &z)
    {
        trace_.configurations.push_back(z.head(n_));
        trace_.lambdas.push_back(z[n_]);
    }

    void sampleAt(const VectorXd &z)
    {
        homotopy_.repulsion().evaluate(z.head(n_), sample_);
        ++trace_.evaluations;
    }

    /// Turns `heading` into the unit tangent of the curve at z that points the same way.
    bool tangent(const VectorXd &z, VectorXd &heading)
    {
        sampleAt(z);
        homotopy_.jacobian(sample_, jacobian_);
        if (!jacobian_.allFinite())
            return false;
        const Eigen::ColPivHouseholderQR<MatrixXd> qr(jacobian_.transpose());
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
        sampleAt(z);
        homotopy_.residual(z.head(n_), z[n_], sample_, h_);
        f.resize(n_ + 1);
        f << h_, (z - center).squaredNorm() - options_.radius * options_.radius;
    }

    /// Broyden's good method, inverse update.
    bool correct(const VectorXd &center, const VectorXd &predicted, VectorXd &z)
    {
        z = predicted;
        VectorXd f, next;
        system(z, center, f);
        homotopy_.jacobian(sample_, jacobian_);
        MatrixXd full(n_ + 1, n_ + 1);
        full << jacobian_, 2.0 * (z - center).transpose();
        if (!full.allFinite())
            return false;
        MatrixXd inverse = full.partialPivLu().inverse();
        for (int i = 0; i < options_.maxCorrections; ++i)
        {
            const VectorXd step = -inverse * f;
            // Written so that a NaN is refused too. A point further off than this is another piece of the curve.
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

    bool crossed(const VectorXd &from, const VectorXd &to) const { return (from[n_] - 1.0) * (to[n_] - 1.0) <= 0.0; }

    /// Refines the root at lambda = 1 and says whether the trace is over.
    bool endGame(const VectorXd &from, const VectorXd &to)
    {
        const double t = (1.0 - from[n_]) / (to[n_] - from[n_]);
        VectorXd root = from + t * (to - from);
        root[n_] = 1.0;
        for (int i = 0; i < options_.maxCorrections; ++i)
        {
            sampleAt(root);
            homotopy_.residual(root.head(n_), 1.0, sample_, h_);
            homotopy_.jacobian(sample_, jacobian_);
            const VectorXd step = jacobian_.leftCols(n_).partialPivLu().solve(h_);
            if (!step.allFinite())
                break;
            root.head(n_) -= step;
            if (step.norm() <= options_.tolerance)
                break;
        }
        if ((root.head(n_) - homotopy_.goal()).norm() <= options_.window.goalTolerance)
        {
            root.head(n_) = homotopy_.goal();
            keep(root);
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
        const double deviation = (z.head(n_) - homotopy_.start()).norm();
        std::optional<TraceStatus> end = departure(options_.window, z[n_], deviation, trace_.wrongRoots);
        const double nearby = 0.5 * options_.radius;
        if (!end && trace_.steps > 3 && deviation < nearby && std::abs(z[n_]) < nearby)
            end = TraceStatus::ClosedLoop;
        if (end)
            stop(*end);
        return end.has_value();
    }

    const ArmHomotopy &homotopy_;
    const SphereOptions &options_;
    Trace &trace_;
    const int n_;
    ArmRepulsion::Sample sample_;
    VectorXd h_;
    MatrixXd jacobian_;
};
}  // namespace

Trace traceSpheres(const ArmHomotopy &homotopy, const SphereOptions &options, const std::function<bool()> &interrupt)
{
    if (!(options.radius > 0.0))
        throw std::invalid_argument("the hyperspheres' radius must be positive");
    if (options.maxSpheres < 1 || options.maxCorrections < 1 || !(options.tolerance > 0.0))
        throw std::invalid_argument("the numbers of spheres and corrections and the tolerance must be positive");
    checkWindow(options.window);
    if (homotopy.difference().norm() == 0.0)
        return standStill(homotopy.start());
    Trace trace;
    Spheres(homotopy, options, trace).run(interrupt);
    return trace;
}
}  // namespace narrows
