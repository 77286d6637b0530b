// SPDX-License-Identifier: BSD-3-Clause
// Motions that all but touch: the radius of the links is chosen so that the least clearance on the way is a given
// number of either sign, however small. A certificate that is not sound lets some of the touching ones through; one
// that is not sharp gives up on the others.
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "CorridorScene.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

class Random
{
public:
    explicit Random(unsigned seed) : generator_(seed) {}
    double between(double low, double high) { return low + (high - low) * uniform_(generator_); }
    int below(int count) { return static_cast<int>(between(0.0, count)); }
    /// Even on a logarithmic scale.
    double magnitude(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    VectorXd vector(int size, double extent)
    {
        VectorXd values(size);
        for (double &value : values)
            value = between(-extent, extent);
        return values;
    }

private:
    std::mt19937 generator_;
    std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

PlanarArm randomArm(Random &random, double radius = 0.0, int leastLinks = 1)
{
    std::vector<PlanarLink> links;
    const int count = leastLinks + random.below(4);
    for (int i = 0; i < count; ++i)
        links.push_back({random.between(0.3, 1.5), random.below(5) == 0 ? random.below(i + 1) - 1 : i - 1});
    std::optional<Slide> slide;
    if (random.below(3) == 0)
        slide = Slide{{0.6, 0.8}, -5.0, 5.0};
    return PlanarArm({0.1, -0.2}, links, radius, slide);
}

PlanarArm withRadius(const PlanarArm &arm, double radius)
{
    return PlanarArm(arm.base(), arm.links(), radius, arm.slide());
}

/// A polygon with a random number of corners around a point, not convex as a rule.
Polygon randomStar(Random &random, const Vector2d &center, double size)
{
    Polygon polygon;
    const int corners = 3 + random.below(5);
    const double turn = random.between(0.0, 1.0);
    for (int i = 0; i < corners; ++i)
    {
        const double angle = (i + turn) * 2.0 * M_PI / corners;
        polygon.vertices.push_back(center +
                                   size * random.between(0.3, 1.0) * Vector2d(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

enum class Kind
{
    Circles,
    Superellipses,
    Polygons,
    Walls,
    Nothing
};

PlanarObstacle randomObstacle(Random &random, Kind kind)
{
    const double size = random.between(0.1, 0.7);
    const double angle = random.between(-M_PI, M_PI);
    const Vector2d center = random.between(0.8, 3.0) * Vector2d(std::cos(angle), std::sin(angle));
    if (kind == Kind::Circles)
        return {"C", Circle{center, size}};
    if (kind == Kind::Superellipses)
        return {"E", Superellipse{center, {size, random.between(0.1, 0.7)}, random.below(2) == 0 ? 4.0 : 2.5}};
    if (kind == Kind::Polygons)
        return {"P", randomStar(random, center, size)};
    const Vector2d half(random.between(0.5, 3.0), 1e-3);
    return {"W", Polygon{{center - half, center + Vector2d(half.x(), -half.y()), center + half,
                          center - Vector2d(half.x(), -half.y())}}};
}

struct Trial
{
    PlanarModel model;
    VectorXd q, delta;
};

/// The least value near the middle one of three samples, none of which is less.
double refine(const std::function<double(double)> &value, double low, double high)
{
    const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
    double left = high - ratio * (high - low), right = low + ratio * (high - low);
    double atLeft = value(left), atRight = value(right);
    while (high - low > 1e-9)
        if (atLeft < atRight)
        {
            high = std::exchange(right, left);
            atRight = atLeft;
            atLeft = value(left = high - ratio * (high - low));
        }
        else
        {
            low = std::exchange(left, right);
            atLeft = atRight;
            atRight = value(right = low + ratio * (high - low));
        }
    return std::min(atLeft, atRight);
}

/// Least clearance on the way of links without radius, to about 1e-12: sampled, then refined around the least samples.
double leastClearance(const Trial &trial)
{
    constexpr int samples = 200;
    PlanarModel thin = trial.model;
    thin.arm = withRadius(thin.arm, 0.0);
    const auto checker = makeArmChecker("analytic", thin);
    const auto at = [&](double t)
    {
        return checker->clearance(trial.q + t * trial.delta);
    };
    std::vector<double> values;
    for (int i = 0; i <= samples; ++i)
        values.push_back(at(static_cast<double>(i) / samples));
    double least = *std::min_element(values.begin(), values.end());
    const double near = least + 0.05 * trial.delta.norm();
    for (int i = 0; i <= samples && least > 0.0; ++i)
    {
        const double before = values[std::max(i - 1, 0)], after = values[std::min(i + 1, samples)];
        const bool isFlat = values[i] == before && values[i] == after;  // the base is nearest
        if (!isFlat && values[i] <= std::min({before, after, near}))
            least = std::min(
                least, refine(at, std::max(i - 1, 0) * (1.0 / samples), std::min(i + 1, samples) * (1.0 / samples)));
    }
    return least;
}

Trial randomTrial(Random &random, Kind kind)
{
    const bool self = kind == Kind::Nothing;
    Trial trial{{randomArm(random, 0.0, self ? 3 : 1), {}, self}, {}, {}};
    const int obstacles = self ? 0 : 1 + random.below(3);
    for (int i = 0; i < obstacles; ++i)
        trial.model.obstacles.push_back(randomObstacle(random, kind));
    trial.q = random.vector(trial.model.arm.dimension(), M_PI);
    trial.delta = random.magnitude(0.003, 2.0) * random.vector(trial.model.arm.dimension(), 1.0);
    return trial;
}

struct Tally
{
    int accepted = 0;
    int refused = 0;
    int passes = 0;  ///< motions that are accepted where they are tight somewhere in between
};

/// \param resolution below which a checker may refuse what is free
Tally tryTightMotions(const std::string &name, Kind kind, unsigned seed, int trials, double finest, double resolution)
{
    Random random(seed);
    Tally tally;
    for (int i = 0; i < trials; ++i)
    {
        Trial trial = randomTrial(random, kind);
        const double least = leastClearance(trial);
        const double gap = random.magnitude(finest, 0.1) * (random.below(2) == 0 ? 1.0 : -1.0);
        // Both links of a pair are thick.
        const double radius = kind == Kind::Nothing ? 0.5 * (least - gap) : least - gap;
        if (!(least > 0.0) || !(radius >= 0.0) || !std::isfinite(radius))
            continue;
        trial.model.arm = withRadius(trial.model.arm, radius);
        const auto checker = makeArmChecker(name, trial.model);
        if (!checker->isFree(trial.q))
            continue;  // not what a motion check is for
        std::uint64_t placements = 0;
        const bool free = checker->isMotionFree(trial.q, trial.delta, placements);
        EXPECT_FALSE(free && gap < 0.0) << name << ", seed " << seed << ", trial " << i << ": touches by " << -gap;
        EXPECT_FALSE(!free && gap > resolution) << name << ", seed " << seed << ", trial " << i << ": clear by " << gap;
        ++(free ? tally.accepted : tally.refused);
        tally.passes += free && gap < 1e-4;
    }
    return tally;
}

class MotionCertificate : public testing::TestWithParam<Kind>
{
};

TEST_P(MotionCertificate, DecidesMotionsThatAllButTouch)
{
    // A radius cannot be subtracted from a clearance to better than the rounding of both, hence no gaps below 1e-8.
    const Tally tally = tryTightMotions("analytic", GetParam(), 7, 2000, 2e-8, 2e-8);
    EXPECT_GT(tally.accepted, 150);
    EXPECT_GT(tally.refused, 50);
    EXPECT_GT(tally.passes, 50);
}

TEST_P(MotionCertificate, FclDecidesThemUpToItsResolution)
{
    const double resolution = GetParam() == Kind::Superellipses ? 1e-3 : 1e-5;
    const Tally tally = tryTightMotions("fcl", GetParam(), 8, 400, 1e-4, resolution);
    EXPECT_GT(tally.accepted, 30);
    EXPECT_GT(tally.refused, 10);
}

INSTANTIATE_TEST_SUITE_P(Kinds, MotionCertificate,
                         testing::Values(Kind::Circles, Kind::Superellipses, Kind::Polygons, Kind::Walls,
                                         Kind::Nothing));
int placementsInto(double clearance)
{
    const CorridorMotion motion(clearance);
    std::uint64_t placements = 0;
    EXPECT_TRUE(makeArmChecker("analytic", motion.model)->isMotionFree(motion.q, motion.delta, placements))
        << clearance;
    return static_cast<int>(placements);
}

TEST(MotionCertificateCost, GrowsByTheLogarithmOfTheClearance)
{
    const int wide = placementsInto(0.05), narrow = placementsInto(4e-4), closed = placementsInto(1e-7);
    EXPECT_LE(wide, 2);
    EXPECT_LE(narrow, wide + 2 * std::log2(0.05 / 4e-4));
    EXPECT_LE(closed, narrow + 2 * std::log2(4e-4 / 1e-7));
}

TEST(MotionCertificateCost, IsOneLookForALinkThatGlidesAlongAWall)
{
    const PlanarArm arm({0, 0}, {{1.0, -1}}, 0.25, Slide{{1.0, 0.0}, 0.0, 9.0});
    const double below = -0.25 - 1e-7;
    const PlanarModel model{arm,
                            {{"wall", Polygon{{{-9.0, -1.0}, {9.0, -1.0}, {9.0, below}, {-9.0, below}}}},
                             {"disc", Circle{{3.0, 1.25 + 1e-7}, 1.0}}}};
    std::uint64_t placements = 0;
    EXPECT_TRUE(makeArmChecker("analytic", model)
                    ->isMotionFree(Eigen::Vector2d::Zero(), Eigen::Vector2d(6.0, 0.0), placements));
    EXPECT_EQ(placements, 1u);
}

/// Two links that swing alike keep their distance, however fast they swing.
TEST(MotionCertificateCost, KnowsWhatTwoLinksMoveAlike)
{
    const PlanarArm arm({0, 0}, {{1.0, -1}, {0.2, 0}, {0.9, 1}}, 0.1 - 1e-5);
    const Eigen::Vector3d hairpin(0.0, M_PI / 2.0, M_PI);
    std::uint64_t placements = 0;
    EXPECT_TRUE(
        makeArmChecker("analytic", {arm, {}, true})->isMotionFree(hairpin, 0.5 * Eigen::Vector3d::Ones(), placements));
    EXPECT_LE(placements, 400u);  // inverse to the root of the gap
    EXPECT_FALSE(
        makeArmChecker("analytic", {PlanarArm(arm.base(), arm.links(), 0.1 + 1e-5), {}, true})->isFree(hairpin));
}
}  // namespace
}  // namespace narrows
