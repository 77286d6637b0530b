// SPDX-License-Identifier: BSD-3-Clause
#include "planners/NloptProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/TipJacobian.h"

namespace narrows
{
namespace
{
using Eigen::VectorXd;
using Row = Eigen::Map<Eigen::VectorXd>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double atLimit = 1e-6;        // radians, or shares of the arm's reach
constexpr double firstChange = 0.01;    // of COBYLA, in units of the search
constexpr double permittedMiss = 1e-9;  // of limits, and of clearances in shares of the reach; 0 would never be met
}  // namespace

NloptProgram::NloptProgram(std::shared_ptr<const SpatialPoles> givenPoles, const TipSearchTask &task,
                           const NloptOptions &options)
  : poles(std::move(givenPoles)), link(task.link), margin(options.margin), units(jointUnits(poles->arm()))
{
    const unsigned n = static_cast<unsigned>(arm().dimension());
    optimizer = nlopt_create(options.withoutDerivatives ? NLOPT_LN_COBYLA : NLOPT_LD_SLSQP, n);
    const double tolerance = 0.5 * task.precision / arm().reach();
    nlopt_set_min_objective(optimizer, effort, this);
    nlopt_add_equality_mconstraint(optimizer, 3, atTarget, this, std::vector<double>(3, tolerance).data());
    if (inequalities() > 0)
        nlopt_add_inequality_mconstraint(optimizer, inequalities(), permitted, this,
                                         std::vector<double>(inequalities(), permittedMiss).data());
    nlopt_set_xtol_abs1(optimizer, 0.2 * tolerance);
    // Without derivatives one step costs as many evaluations as their differences would.
    nlopt_set_maxeval(optimizer, task.maxIterations * (options.withoutDerivatives ? static_cast<int>(n) + 1 : 1));
    if (options.withoutDerivatives)
        nlopt_set_initial_step1(optimizer, firstChange);
    forces.resize(static_cast<std::size_t>(arm().linkCount()));
}

void NloptProgram::begin(const Eigen::Vector3d &newTarget, const VectorXd &from)
{
    target = newTarget;
    origin = from;
    VectorXd lower = VectorXd::Constant(from.size(), -infinity);
    VectorXd upper = VectorXd::Constant(from.size(), infinity);
    for (int i = 0; i < arm().dimension(); ++i)
        if (const std::optional<Interval> &limits = arm().joints()[i].limits)
        {
            // Where the search begins must not be outside by rounding.
            lower[i] = std::min(0.0, (limits->lower - from[i]) / units[i]);
            upper[i] = std::max(0.0, (limits->upper - from[i]) / units[i]);
        }
    nlopt_set_lower_bounds(optimizer, lower.data());
    nlopt_set_upper_bounds(optimizer, upper.data());
}

void NloptProgram::place(const double *x)
{
    q = origin + Eigen::Map<const VectorXd>(x, origin.size()).cwiseProduct(units);
    arm().place(q, placement);
}

bool NloptProgram::touchesLimit() const
{
    for (int i = 0; i < arm().dimension(); ++i)
        if (const std::optional<Interval> &limits = arm().joints()[i].limits)
            if (std::min(q[i] - limits->lower, limits->upper - q[i]) < atLimit * units[i])
                return true;
    return std::any_of(
        arm().universalLimits().begin(), arm().universalLimits().end(),
        [this](const UniversalLimit &joint)
        { return std::cos(q[joint.first]) * std::cos(q[joint.second]) < std::cos(joint.maxAngle - atLimit); });
}

unsigned NloptProgram::inequalities() const
{
    return static_cast<unsigned>(arm().universalLimits().size() + poles->obstacles().size() * arm().links().size() +
                                 poles->pairs().size());
}

double NloptProgram::effort(unsigned n, const double *x, double *gradient, void *)
{
    if (gradient != nullptr)
        std::copy(x, x + n, gradient);
    return 0.5 * Eigen::Map<const VectorXd>(x, n).squaredNorm();
}

void NloptProgram::atTarget(unsigned, double *result, unsigned n, const double *x, double *gradient, void *program)
{
    NloptProgram &self = *static_cast<NloptProgram *>(program);
    self.place(x);
    const double reach = self.arm().reach();
    Eigen::Map<Eigen::Vector3d>{result} = (self.placement.points[2 * self.link + 1] - self.target) / reach;
    if (gradient == nullptr)
        return;
    tipJacobian(self.arm(), self.placement, self.link, self.jacobian);
    for (int i = 0; i < 3; ++i)
        Row(gradient + i * n, n) = self.jacobian.row(i).transpose().cwiseProduct(self.units) / reach;
}

void NloptProgram::permitted(unsigned, double *result, unsigned n, const double *x, double *gradient, void *program)
{
    NloptProgram &self = *static_cast<NloptProgram *>(program);
    self.place(x);
    const SpatialArm &arm = self.arm();
    for (const UniversalLimit &joint : arm.universalLimits())
    {
        const double first = self.q[joint.first], second = self.q[joint.second];
        *result++ = std::cos(joint.maxAngle) - std::cos(first) * std::cos(second);
        if (gradient == nullptr)
            continue;
        Row row(gradient, n);
        row.setZero();
        row[joint.first] = std::sin(first) * std::cos(second);
        row[joint.second] = std::cos(first) * std::sin(second);
        gradient += n;
    }
    for (const SpatialPole &obstacle : self.poles->obstacles())
        for (std::size_t i = 0; i < arm.links().size(); ++i)
        {
            const SpatialTerm term = obstacle.clearance(self.placement.points[2 * i], self.placement.points[2 * i + 1],
                                                        arm.links()[i].radius);
            self.forces[i] = term.slope;
            self.keepAway(term.value, result, gradient);
            self.forces[i] = {};
        }
    for (const auto &[first, second] : self.poles->pairs())
    {
        const SpatialPairTerm term = pairClearance(arm, self.placement, first, second);
        self.forces[first] = term.first;
        self.forces[second] = term.second;
        self.keepAway(term.value, result, gradient);
        self.forces[first] = self.forces[second] = {};
    }
}

void NloptProgram::keepAway(double clearance, double *&result, double *&gradient)
{
    *result++ = (margin - clearance) / arm().reach();
    if (gradient == nullptr)
        return;
    gatherGradient(arm(), placement, forces, slope);
    Row(gradient, slope.size()) = -slope.cwiseProduct(units) / arm().reach();
    gradient += slope.size();
}
}  // namespace narrows
