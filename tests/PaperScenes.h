// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// A case study of HPPM-PRA, Tables 1-3 in the reading of docs/hppm.md, built without the scenario reader.
struct PaperScene
{
    PlanarModel model;
    PlanarTask task;
};

inline PlanarObstacle paperCircle(const std::string &name, double x, double y, double radius)
{
    return {name, Circle{{x, y}, radius}};
}

inline PlanarObstacle paperEllipsoid(const std::string &name, double x, double y, double alpha, double beta)
{
    return {name, Superellipse{{x, y}, {std::pow(alpha, 0.25), std::pow(beta, 0.25)}, 4.0}};
}

inline Eigen::VectorXd anglesOf(const std::vector<double> &angles)
{
    return Eigen::Map<const Eigen::VectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size()));
}

inline PaperScene paperScene1()
{
    const double quarter = std::atan(1.0);
    return {{PlanarArm({0, 0}, {{std::sqrt(5.0), -1}, {std::sqrt(2.0), 0}, {std::sqrt(0.5), 1}}),
             {paperCircle("C1", 2.4, 2.5, 0.58), paperCircle("C2", 1.6, 3.5, 0.58)}},
            {anglesOf({std::atan2(1, 2), -quarter, quarter}), anglesOf({std::atan2(2, 1), quarter, quarter}), {}}};
}

inline PaperScene paperScene2()
{
    const double quarter = std::atan(1.0);
    std::vector<PlanarLink> links;
    for (int i = 0; i < 6; ++i)
        links.push_back({std::sqrt(2.0), i - 1});
    links.push_back({std::sqrt(0.5), 5});
    links.push_back({std::sqrt(0.5), 5});
    const double sixth = std::asin((6.5 - 3.0 * std::sqrt(2.0) - 2.0) / std::sqrt(2.0));
    const double finger = std::asin(0.25 / std::sqrt(0.5));
    return {{PlanarArm({0, 0}, links),
             {paperCircle("C1", 4.0, 6.5, 0.2), paperEllipsoid("E1", 4.5, 5.5, 15.0, 0.05),
              paperEllipsoid("E2", 4.5, 7.5, 15.0, 0.05)}},
            {anglesOf({quarter, quarter, quarter, -quarter, -quarter, -quarter, quarter, quarter}),
             anglesOf({2 * quarter, 2 * quarter, 2 * quarter, quarter, quarter, sixth, finger, -finger}),
             {}}};
}

inline PaperScene paperScene3()
{
    const double quarter = std::atan(1.0);
    std::vector<PlanarLink> links;
    for (int i = 0; i < 20; ++i)
        links.push_back({std::sqrt(0.5), i - 1});
    std::vector<double> goal;
    for (const int eighths : {2, 2, 2, 2, 2, 2, 1, 0, 0, 0, -1, -1, -1, 0, 1, 1, 1, 1, -1, -3})
        goal.push_back(eighths * quarter);
    return {{PlanarArm({0, 0}, links),
             {paperCircle("C1", 6.84, 4.75, 0.15), paperCircle("C2", -3.0, 8.0, 0.5),
              paperEllipsoid("E1", 4.5, 7.5, 300.0, 0.01), paperEllipsoid("E2", 4.5, 5.9, 0.02, 15.0),
              paperEllipsoid("E3", 8.5, 2.1, 0.02, 15.0), paperEllipsoid("E4", 4.5, 0.5, 300.0, 0.01),
              paperEllipsoid("E5", 0.5, 1.7, 0.02, 8.0)}},
            {Eigen::VectorXd::Constant(20, 3 * quarter), anglesOf(goal), {}}};
}

inline PaperScene paperScene(int number)
{
    switch (number)
    {
        case 1:
            return paperScene1();
        case 2:
            return paperScene2();
        case 3:
            return paperScene3();
        default:
            throw std::invalid_argument("no such case");
    }
}
}  // namespace narrows
