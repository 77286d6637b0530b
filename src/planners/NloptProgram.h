// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <nlopt.h>

#include "planners/NloptTipSearch.h"

namespace narrows
{
/// What NLopt minimizes for NloptTipSearch, |x|^2, and under which constraints. x are the changes of the joints since
/// the search began, counted in units of the search (jointUnits()), so that all numbers are of one size.
struct NloptProgram
{
    NloptProgram(std::shared_ptr<const SpatialPoles> givenPoles, const TipSearchTask &task,
                 const NloptOptions &options);
    ~NloptProgram() { nlopt_destroy(optimizer); }
    NloptProgram(const NloptProgram &) = delete;
    NloptProgram &operator=(const NloptProgram &) = delete;

    const SpatialArm &arm() const { return poles->arm(); }
    void begin(const Eigen::Vector3d &newTarget, const Eigen::VectorXd &from);
    void place(const double *x);  ///< sets q and placement
    double tipError() const { return (target - placement.points[2 * link + 1]).norm(); }
    /// Is some joint, or universal joint, at a limit in q?
    bool touchesLimit() const;
    unsigned inequalities() const;  ///< universal joints, links and obstacles, pairs of links
    /// Writes the next constraint, that a clearance is at least the margin.
    void keepAway(double clearance, double *&result, double *&gradient);

    // As NLopt calls them; `gradient` is null where it wants none.
    static double effort(unsigned n, const double *x, double *gradient, void *program);
    static void atTarget(unsigned m, double *result, unsigned n, const double *x, double *gradient, void *program);
    static void permitted(unsigned m, double *result, unsigned n, const double *x, double *gradient, void *program);

    std::shared_ptr<const SpatialPoles> poles;
    int link;
    double margin;
    Eigen::VectorXd units;
    nlopt_opt optimizer;

    Eigen::Vector3d target;
    Eigen::VectorXd origin;  ///< x = 0
    Eigen::VectorXd q;
    SpatialArm::Placement placement;  ///< of q
    std::vector<EndForces> forces;    ///< zero between constraints
    Eigen::VectorXd slope;
    Eigen::Matrix3Xd jacobian;
};
}  // namespace narrows
