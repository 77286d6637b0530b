// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/LinkTerm.h"

namespace narrows
{
using Eigen::Vector2d;

void gatherGradient(const PlanarArm &arm, const std::vector<Vector2d> &points, const std::vector<LinkForce> &forces,
                    std::vector<Vector2d> &carried, Eigen::VectorXd &gradient)
{
    const int first = arm.firstAngle();
    gradient.resize(arm.dimension());
    carried.assign(points.size(), Vector2d::Zero());
    for (int t = arm.linkCount() - 1; t >= 0; --t)
    {
        const int parent = arm.links()[t].parent + 1;
        const Vector2d along = points[t + 1] - points[parent];
        const Vector2d lever = carried[t + 1] + forces[t].lever;
        gradient[first + t] = along.x() * lever.y() - along.y() * lever.x();
        carried[parent] += carried[t + 1] + forces[t].force;
    }
    if (arm.slide())
        gradient[0] = arm.slide()->axis.dot(carried[0]);
}
}  // namespace narrows
