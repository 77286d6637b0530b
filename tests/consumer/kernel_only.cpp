// SPDX-License-Identifier: BSD-3-Clause
// The mathematics alone, which needs Eigen and nothing else.
#include <iostream>

#include "kernel/PlanarArm.h"

int main()
{
    const narrows::PlanarArm arm({0, 0}, {{1.0, -1}, {1.0, 0}});
    std::vector<Eigen::Vector2d> points;
    arm.place(Eigen::Vector2d(0.0, 1.5707963267948966), points);
    std::cout << "tip at " << points.back().x() << ' ' << points.back().y() << '\n';
}
