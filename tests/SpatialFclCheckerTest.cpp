// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "SpatialScenes.h"
#include "validity/SpatialChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

/// FCL may say "no" where there is a gap of up to 2e-6, and never "yes" where there is none.
TEST(SpatialFclChecker, ErrsOnTheSafeSideAndByLittle)
{
    std::mt19937 generator(21);
    int clear = 0, touching = 0;
    for (int trial = 0; trial < 12000; ++trial)
    {
        const SpatialModel model{snake(), {randomObstacle(trial % obstacleKinds, generator)}, false};
        const auto analytic = makeAnalyticChecker(model);
        const auto fcl = makeFclChecker(model);
        Link<3> link{randomPoint(1.5, generator), randomPoint(1.5, generator), 0.0};
        if (trial % 7 == 0)
            link.b = link.a;
        // As close to contact as it takes to see the difference, on either side of it.
        const double distance = analytic->clearance(link);
        if (distance <= 1e-5)
        {
            ++touching;
            ASSERT_FALSE(fcl->clears(link)) << "trial " << trial << ", " << model.obstacles[0].name;
            continue;
        }
        link.radius = distance - 2.1e-6;
        const bool says = fcl->clears(link);
        clear += says;
        EXPECT_TRUE(says) << "trial " << trial << ", " << model.obstacles[0].name << ", distance " << distance;
        link.radius = distance;
        EXPECT_FALSE(fcl->clears(link)) << "trial " << trial << ", " << model.obstacles[0].name << ", distance "
                                        << distance;
    }
    EXPECT_GT(clear, 4000);
    EXPECT_GT(touching, 1000);
}

TEST(SpatialFclChecker, ClearanceIsTheDistance)
{
    std::mt19937 generator(22);
    int apart = 0;
    for (int trial = 0; trial < 3000; ++trial)
    {
        const SpatialModel model{snake(), {randomObstacle(trial % obstacleKinds, generator)}, false};
        const Link<3> link{randomPoint(1.5, generator), randomPoint(1.5, generator), 0.03};
        const double exact = makeAnalyticChecker(model)->clearance(link);
        const double measured = makeFclChecker(model)->clearance(link);
        if (exact <= 0.0)
        {
            ASSERT_LE(measured, 0.0) << model.obstacles[0].name;
            continue;
        }
        ++apart;
        ASSERT_LE(measured, exact + 1e-8) << model.obstacles[0].name;
        ASSERT_GE(measured, exact - 1.5e-5) << model.obstacles[0].name;
    }
    EXPECT_GT(apart, 1000);
}

TEST(SpatialFclChecker, LinksAgainstLinks)
{
    std::mt19937 generator(23);
    const SpatialModel model{snake(), {}, true};
    const auto analytic = makeAnalyticChecker(model);
    const auto fcl = makeFclChecker(model);
    for (int trial = 0; trial < 20000; ++trial)
    {
        Link<3> link{randomPoint(1.0, generator), randomPoint(1.0, generator), 0.0};
        const Link<3> other{randomPoint(1.0, generator), randomPoint(1.0, generator), 0.1};
        const double distance = analytic->clearance(link, other);
        if (distance < 1e-5)
            continue;
        link.radius = distance - 3.1e-6;
        EXPECT_TRUE(fcl->clears(link, other)) << trial;
        link.radius = distance;
        EXPECT_FALSE(fcl->clears(link, other)) << trial;
    }
}
}  // namespace
}  // namespace narrows
