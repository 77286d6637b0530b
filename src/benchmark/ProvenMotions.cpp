// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/ProvenMotions.h"

#include "validity/ArmValidityChecker.h"

namespace narrows
{
namespace
{
constexpr std::uint64_t proofEffort = 20'000;  // configurations; a motion that needs more passes too near

ProblemOptions optionsFor(const RunSpec &spec)
{
    const bool absolute = spec.scenario->isPlanar() && spec.scenario->planar().convention == AngleConvention::Absolute;
    return {spec.problem.checker, "continuous", absolute ? "absolute_line" : "relative_line"};
}

bool checksLinks(const Scenario &scenario)
{
    return scenario.isPlanar() ? scenario.planar().model->selfCollision : scenario.spatial().model->selfCollision;
}

TrajectoryCertificate certificateOf(const Problem &problem, const Scenario &scenario)
{
    const auto checker = std::dynamic_pointer_cast<ArmValidityChecker>(problem.si->getStateValidityChecker());
    return {*problem.space,
            [checker](ConfigurationRef q) { return checker->clearanceAt(q); },
            checksLinks(scenario),
            {0.0, proofEffort}};
}
}  // namespace

ProvenMotions::ProvenMotions(const RunSpec &spec)
  : scenario_(spec.scenario),
    problem_(makeProblem(*scenario_, optionsFor(spec))),
    certificate_(certificateOf(problem_, *scenario_))
{
}

bool ProvenMotions::isFree(const JointTrajectory &motion) const
{
    return certificate_.check(motion).status == CertificateStatus::Free;
}

bool ProvenMotions::isFree(const Eigen::MatrixXd &polyline) const
{
    for (Eigen::Index k = 1; k < polyline.cols(); ++k)
        if (!isFreeBetween(polyline.col(k - 1), polyline.col(k)))
            return false;
    return true;
}

bool ProvenMotions::isFreeBetween(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const
{
    ob::ScopedState<> first(problem_.space), last(problem_.space);
    problem_.space->fromConfiguration(fromFile(scenario_->world, from), first.get());
    problem_.space->fromConfiguration(fromFile(scenario_->world, to), last.get());
    return problem_.si->checkMotion(first.get(), last.get());
}

Eigen::MatrixXd ProvenMotions::withShortcuts(const Eigen::MatrixXd &vertices) const
{
    Eigen::MatrixXd kept(vertices.rows(), vertices.cols());
    Eigen::Index count = 0, here = 0;
    while (here < vertices.cols())
    {
        kept.col(count++) = vertices.col(here);
        // Twice as far as long as that is free, then back by halves: few proofs for long paths.
        Eigen::Index reached = here + 1, step = 1;
        const auto leads = [&](Eigen::Index to)
        {
            return to < vertices.cols() && isFreeBetween(vertices.col(here), vertices.col(to));
        };
        for (; leads(reached + step); step *= 2)
            reached += step;
        for (; step > 0; step /= 2)
            if (leads(reached + step))
                reached += step;
        here = reached;
    }
    return kept.leftCols(count);
}
}  // namespace narrows
