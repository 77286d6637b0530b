// SPDX-License-Identifier: BSD-3-Clause
// What is looked at side by side, in single precision, against double precision: places of links, what is claimed of
// shapes one at a time, and what is left open.
#include "validity/PlanarScreen.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "ScalarChecker.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

const double pi = std::acos(-1.0);

Eigen::MatrixXd randomRows(Eigen::Index rows, Eigen::Index columns, double range, unsigned seed)
{
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> value(-range, range);
    Eigen::MatrixXd result(rows, columns);
    for (double &entry : result.reshaped())
        entry = value(generator);
    return result;
}

TEST(PlanarScreen, PlacesLinksAsWellAsItSays)
{
    for (const double range : {3.2, 1e2, 9e4})
    {
        constexpr int blocks = 2000;
        const Eigen::MatrixXd angles = randomRows(blocks * lanes::count, 1, range, 1);
        lanes::Points points[2] = {};
        const lanes::Link link{2.0f, -1};
        double worst = 0.0;
        for (int block = 0; block < blocks; ++block)
        {
            lanes::Findings strange;
            const double *first = angles.data() + block * lanes::count;
            lanes::placeLinks(first, 0, &link, 1, points, strange);
            for (int l = 0; l < lanes::count; ++l)
            {
                EXPECT_EQ(strange.of[l], 0);
                worst = std::max({worst, std::abs(points[1].x[l] - 2.0 * std::cos(first[l])),
                                  std::abs(points[1].y[l] - 2.0 * std::sin(first[l]))});
            }
        }
        EXPECT_LT(worst, 2.0 / (1 << 22)) << range;
        EXPECT_GT(worst, 0.0);
    }
}

struct Outcome
{
    int clear = 0, touching = 0, open = 0, wrong = 0;
};

Outcome examine(const PlanarModel &model, const Eigen::MatrixXd &states)
{
    std::vector<LinkPair> pairs;
    for (int link = 0; model.selfCollision && link < model.arm.linkCount(); ++link)
        for (int other = 0; other < link; ++other)
            if (!model.arm.areNeighbours(link, other))
                pairs.emplace_back(link, other);
    const PlanarScreen screen(model, pairs);
    const ScalarChecker scalar(model);
    std::vector<Finding> findings;
    screen.examine(states, findings);
    EXPECT_EQ(findings.size(), static_cast<std::size_t>(states.rows()));
    Outcome outcome;
    for (Eigen::Index k = 0; k < states.rows(); ++k)
    {
        const Finding finding = findings[static_cast<std::size_t>(k)];
        ++(finding == Finding::Clear ? outcome.clear : finding == Finding::Touching ? outcome.touching : outcome.open);
        if (finding != Finding::Unsure)
            outcome.wrong += scalar.isFree(states.row(k)) != (finding == Finding::Clear);
    }
    return outcome;
}

PlanarArm threeLinks(double radius)
{
    return PlanarArm({0.1, -0.2}, {{0.7, -1}, {0.5, 0}, {0.6, 1}}, radius);
}

/// One shape at a time, thick links and thin: next to nothing is left open where there is a closed form.
TEST(PlanarScreen, DecidesNearlyAllStates)
{
    const Polygon arrow{{{0.8, 0.5}, {1.5, 0.1}, {1.1, 0.5}, {1.5, 0.9}}};
    const Polygon square{{{0.5, 0.5}, {1.0, 0.5}, {1.0, 1.0}, {0.5, 1.0}}};
    for (const auto &shape : std::vector<decltype(PlanarObstacle::shape)>{
             Circle{{0.9, 0.4}, 0.3}, Superellipse{{0.9, 0.4}, {0.4, 0.2}, 4.0}, arrow, square})
    {
        const Outcome thin = examine({threeLinks(0.0), {{"shape", shape}}}, randomRows(20005, 3, pi, 2));
        EXPECT_EQ(thin.wrong, 0) << shape.index();
        EXPECT_GT(thin.clear, 1000) << shape.index();
        EXPECT_GT(thin.touching, 800) << shape.index();
        // Where a superellipse bends most, its tangent is found less well.
        EXPECT_LT(thin.open, shape.index() == 1 ? 200 : 20) << shape.index();
        const Outcome thick = examine({threeLinks(0.03), {{"shape", shape}}}, randomRows(20005, 3, pi, 2));
        EXPECT_EQ(thick.wrong, 0) << shape.index();
        EXPECT_GT(thick.clear, 1000) << shape.index();
        // Thick links that come close to a superellipse but do not reach it are left open.
        EXPECT_LT(thick.open, shape.index() == 1 ? 600 : 20) << shape.index();
    }
}

TEST(PlanarScreen, DecidesLinksThatMeetEachOther)
{
    const Outcome outcome = examine({threeLinks(0.04), {}, true}, randomRows(20000, 3, pi, 4));
    EXPECT_EQ(outcome.wrong, 0);
    EXPECT_GT(outcome.touching, 500);
    EXPECT_GT(outcome.clear, 10000);
    EXPECT_LT(outcome.open, 20);
}

TEST(PlanarScreen, LeavesOpenWhatTouchesExactly)
{
    // Links along the axes, on the line of an edge, beside it and into a corner.
    const PlanarModel model{PlanarArm({0, 0}, {{1.0, -1}, {1.0, 0}}),
                            {{"box", Polygon{{{1.0, 1.0}, {1.5, 1.0}, {1.5, 1.5}, {1.0, 1.5}}}}}};
    Eigen::MatrixXd states(4, 2);
    states << 0.0, pi / 2,  // its tip in the corner
        0.0, 0.0,           // far
        pi / 2, 0.0,        // its tip in the corner again
        0.7, 0.7;           // through the box
    std::vector<Finding> findings;
    PlanarScreen(model, {}).examine(states, findings);
    EXPECT_EQ(findings, (std::vector<Finding>{Finding::Unsure, Finding::Clear, Finding::Unsure, Finding::Touching}));
}

/// Far from every edge, but inside.
TEST(PlanarScreen, SeesLinksInsideAPolygon)
{
    const Polygon around{{{-3.0, -3.0}, {3.0, -3.0}, {3.0, 3.0}, {-3.0, 3.0}}};
    const Outcome outcome = examine({threeLinks(0.01), {{"around", around}}}, randomRows(320, 3, pi, 8));
    EXPECT_EQ(outcome.touching, 320);
    const Polygon beside{{{-9.0, -3.0}, {-3.0, -3.0}, {-3.0, 3.0}, {-6.0, 0.0}}};
    EXPECT_EQ(examine({threeLinks(0.01), {{"beside", beside}}}, randomRows(320, 3, pi, 8)).clear, 320);
}

TEST(PlanarScreen, LeavesOpenWhatHasNoClosedForm)
{
    const PlanarModel model{threeLinks(0.0), {{"shape", Superellipse{{0.9, 0.4}, {0.4, 0.2}, 3.0}}}};
    const Outcome outcome = examine(model, randomRows(20000, 3, pi, 5));
    EXPECT_EQ(outcome.wrong, 0);
    EXPECT_EQ(outcome.touching, 0);
    EXPECT_GT(outcome.open, 1000);
    EXPECT_GT(outcome.clear, 1000);
}

/// Angles that are no numbers or have turned too often, a base beyond its slide: open, and their neighbours are not
/// disturbed.
TEST(PlanarScreen, LeavesOpenWhatItCannotPlace)
{
    const PlanarModel model{PlanarArm({0, 0}, {{1.0, -1}, {0.5, 0}}, 0.0, Slide{{1.0, 0.0}, -1.0, 1.0}),
                            {{"post", Circle{{0.3, 0.6}, 0.2}}}};
    Eigen::MatrixXd states = randomRows(33, 3, 1.0, 6);
    states(0, 1) = std::numeric_limits<double>::quiet_NaN();
    states(3, 2) = std::numeric_limits<double>::infinity();
    states(17, 1) = 1e6;
    states(32, 0) = 1.5;
    states(20, 0) = std::numeric_limits<double>::quiet_NaN();
    std::vector<Finding> findings;
    PlanarScreen(model, {}).examine(states, findings);
    const ScalarChecker scalar(model);
    for (Eigen::Index k = 0; k < states.rows(); ++k)
        if (k == 0 || k == 3 || k == 17 || k == 20 || k == 32)
            EXPECT_EQ(findings[k], Finding::Unsure) << k;
        else
            EXPECT_EQ(findings[k], scalar.isFree(states.row(k)) ? Finding::Clear : Finding::Touching) << k;
}

TEST(PlanarScreen, LooksAtAnyNumber)
{
    const PlanarModel model{threeLinks(0.0), {{"post", Circle{{0.9, 0.4}, 0.3}}}};
    const Eigen::MatrixXd states = randomRows(50, 3, pi, 7);
    std::vector<Finding> all, few;
    const PlanarScreen screen(model, {});
    screen.examine(states, all);
    for (Eigen::Index count = 0; count <= states.rows(); ++count)
    {
        screen.examine(states.topRows(count), few);
        EXPECT_EQ(few, std::vector<Finding>(all.begin(), all.begin() + count)) << count;
    }
}
}  // namespace
}  // namespace narrows
