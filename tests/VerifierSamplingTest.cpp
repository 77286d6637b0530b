// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "validity/Verifier.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

/// Against distances to circles in closed form at states close together.
TEST(VerifierSampling, ClearanceIsThatOfDenseSampling)
{
    std::mt19937 generator(29);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    int accepted = 0;
    for (int trial = 0; trial < 200; ++trial)
    {
        const Circle circle{{2.5 * uniform(generator), 2.5 * uniform(generator)}, 0.3};
        const PlanarModel model{PlanarArm({0, 0}, {{1.0, -1}, {0.8, 0}, {0.6, 0}}, 0.05), {{"C", circle}}};
        std::vector<Eigen::VectorXd> path(4, Eigen::VectorXd(3));
        for (Eigen::VectorXd &row : path)
            for (double &angle : row)
                angle = 2.0 * uniform(generator);
        double least = std::numeric_limits<double>::infinity();
        constexpr int samples = 2000;
        for (int k = 0; k < 3 * samples; ++k)
        {
            const double t = static_cast<double>(k % samples) / (samples - 1);
            const Eigen::VectorXd q = (1 - t) * path[k / samples] + t * path[k / samples + 1];
            for (int link = 0; link < 3; ++link)
            {
                Vector2d from(0, 0);
                for (int parent = 0; parent < (link == 2 ? 1 : link); ++parent)
                    from += Vector2d(std::cos(q[parent]), std::sin(q[parent]));
                const double length = model.arm.links()[link].length;
                const Vector2d direction(std::cos(q[link]), std::sin(q[link]));
                const double along = std::min(std::max((circle.center - from).dot(direction), 0.0), length);
                least = std::min(least, (from + along * direction - circle.center).norm() - 0.35);
            }
        }
        VerifierOptions options;
        options.clearanceTolerance = 1e-6;
        const Verdict verdict = verify(model, {path.front(), path.back(), {}}, path, options);
        SCOPED_TRACE("seed 29, trial " + std::to_string(trial));
        EXPECT_EQ(verdict.accepted, least > 0.0);
        if (verdict.accepted)
        {
            ++accepted;
            EXPECT_LE(verdict.clearance, least);
            EXPECT_GE(verdict.clearance, least - 1e-5);
        }
    }
    EXPECT_GT(accepted, 30);
}
}  // namespace
}  // namespace narrows
