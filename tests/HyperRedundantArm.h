// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "kernel/JointCentres.h"

namespace narrows
{
/// The manipulator of VDSM: eight links on universal joints and a slide; millimetres.
inline std::vector<double> hyperRedundantLengths()
{
    return {486.0, 486.0, 486.0, 486.0, 486.0, 206.0, 206.0, 284.0};
}

inline constexpr double hyperRedundantBend = 42.5 * 3.14159265358979323846 / 180.0;

inline SpatialArm hyperRedundantArm()
{
    return universalChain({0.0, 0.0, 0.0}, hyperRedundantLengths(), 61.5,
                          std::make_pair(Eigen::Vector3d(Eigen::Vector3d::UnitX()), Interval{-1000.0, 1000.0}),
                          hyperRedundantBend);
}

/// Uniform over the slide and the permitted angles of every joint.
inline Eigen::VectorXd randomPose(const ChainGeometry &chain, std::mt19937 &generator)
{
    std::uniform_real_distribution<double> slide(chain.slide.lower, chain.slide.upper);
    std::uniform_real_distribution<double> angle(-chain.maxAngle, chain.maxAngle);
    Eigen::VectorXd q(static_cast<Eigen::Index>(2 * chain.lengths.size() + 1));
    q[0] = slide(generator);
    for (Eigen::Index i = 1; i < q.size(); i += 2)
        do
        {
            q[i] = angle(generator);
            q[i + 1] = angle(generator);
        } while (bendAngle(q[i], q[i + 1]) > chain.maxAngle);
    return q;
}
}  // namespace narrows
