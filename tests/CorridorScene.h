// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PaperScenes.h"
#include "validity/ArmChecker.h"

namespace narrows
{
/// The corridor of the paper's case 1 (Section 5.1), narrowed until the goal has the given clearance on both sides.
inline PlanarModel corridor(double clearance)
{
    PlanarModel model = paperScene(1).model;
    for (PlanarObstacle &obstacle : model.obstacles)
        std::get<Circle>(obstacle.shape).radius = 0.9 / std::sqrt(2.0) - clearance;
    return model;
}

/// The unit vector along which a configuration gains clearance from all obstacles alike.
inline Eigen::VectorXd wayOut(const PlanarModel &model, const Eigen::VectorXd &q)
{
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(q.size());
    for (const PlanarObstacle &obstacle : model.obstacles)
    {
        const auto checker = makeArmChecker("analytic", PlanarModel{model.arm, {obstacle}});
        Eigen::VectorXd gradient(q.size());
        for (int i = 0; i < q.size(); ++i)
        {
            const Eigen::VectorXd step = 1e-6 * Eigen::VectorXd::Unit(q.size(), i);
            gradient[i] = checker->clearance(q + step) - checker->clearance(q - step);
        }
        direction += gradient.normalized();
    }
    return direction.normalized();
}

/// The last motion into that corridor's goal, out of its widest direction.
struct CorridorMotion
{
    explicit CorridorMotion(double clearance) : model(corridor(clearance))
    {
        const Eigen::VectorXd goal = std::get<Eigen::VectorXd>(paperScene(1).task.goal);
        delta = -0.1 * wayOut(model, goal);
        q = goal - delta;
    }

    PlanarModel model;
    Eigen::VectorXd q, delta;
};
}  // namespace narrows
