// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/Carriage.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "LeaderScenes.h"
#include "kernel/SegmentDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

const ChordObstacles<2> nothing({});
const Carrier rod{2.0, 1.0, 0.1};

/// Least room at dense times, from the definitions.
double sampledRoom(const std::vector<CarrierPose> &way, const Carrier &carrier, const ChordObstacles<2> &resting,
                   const std::vector<MovingDisc> &moving, double end)
{
    double least = 10.0;
    for (int k = 0; k <= 4000; ++k)
    {
        const double time = way.front().time + k / 4000.0 * (end - way.front().time);
        std::size_t i = 1;
        while (i < way.size() && way[i].time < time)
            ++i;
        CarrierPose pose = way.back();
        if (i < way.size())
        {
            const CarrierPose &a = way[i - 1], &b = way[i];
            const double share = (time - a.time) / (b.time - a.time);
            pose = {time, (1.0 - share) * a.place + share * b.place, (1.0 - share) * a.heading + share * b.heading};
        }
        const Vector2d along(std::cos(pose.heading), std::sin(pose.heading));
        const Vector2d rear = pose.place - carrier.behind * along, front = pose.place + carrier.ahead * along;
        least = std::min(least, resting.clearance(rear, front, 10.0) - carrier.radius);
        for (const MovingDisc &disc : moving)
            least =
                std::min(least, std::sqrt(squaredDistance(rear, front, disc.at(time))) - disc.radius - carrier.radius);
    }
    return least;
}

TEST(Carriage, GetsAwayFromADiscByItsClosedForm)
{
    // The rear end goes along x, at 2 t - 9, the disc down to x = 0, at 5 - t. As long as the rod lies across x = 0 the
    // disc is at least 0.5 away; then the rear end is nearest, at most so at t = 4.6: |(0.2, 0.4)| = sqrt(0.2).
    const std::vector<CarrierPose> way{{0.0, {-7.0, 0.0}, 0.0}, {6.0, {5.0, 0.0}, 0.0}};
    const auto passes = [&](double room)
    {
        const MovingDisc disc{std::sqrt(0.2) - rod.radius - room, {0.0, 6.0}, {{0.0, 5.0}, {0.0, -1.0}}};
        return certifyCarriage(way, rod, nothing, {disc});
    };
    const CarriageVerdict free = passes(1e-6);
    EXPECT_TRUE(free);
    EXPECT_NEAR(free.clearance, 1e-6, 1e-6);
    EXPECT_GE(free.clearance, 1e-6 - 1e-12);
    const CarriageVerdict touch = passes(-1e-6);
    EXPECT_FALSE(touch);
    EXPECT_NEAR(touch.time, 4.6, 0.01);
    EXPECT_EQ(touch.obstacle, 0);
}

TEST(Carriage, TurnsPastADiscUntilItIsInTheWay)
{
    // Seen from the rod's place, the disc is 2 away at a quarter turn behind it: the rear comes there at half a turn.
    const std::vector<MovingDisc> disc{{0.3, {0.0}, {{0.0, 2.0}}}};
    // Rear end at heading + pi. It meets the disc when it is asin((0.3 + 0.1) / 2) from it.
    const double meets = 1.5 * M_PI - std::asin(0.4 / 2.0);
    const auto turned = [&](double heading)
    {
        return certifyCarriage({{0.0, {0.0, 0.0}, 2.0}, {1.0, {0.0, 0.0}, heading}}, rod, nothing, disc);
    };
    EXPECT_TRUE(turned(meets - 1e-3));
    const CarriageVerdict touch = turned(meets + 1e-3);
    EXPECT_FALSE(touch);
    EXPECT_NEAR(touch.time, 1.0, 0.01);
}

TEST(Carriage, AgreesWithDenseSamples)
{
    const ChordObstacles<2> resting({solidBox("box", Vector2d(3.0, -4.0), Vector2d(4.0, 1.0))});
    int free = 0, touched = 0;
    for (unsigned seed = 1; seed <= 200; ++seed)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> draw(-5.0, 5.0);
        const auto point = [&]
        {
            return Vector2d(draw(random), draw(random));
        };
        std::vector<CarrierPose> way;
        for (int i = 0; i < 3; ++i)
            way.push_back({1.0 * i, point(), 0.6 * draw(random)});
        std::vector<MovingDisc> moving;
        for (int i = 0; i < 2; ++i)
            moving.push_back({0.4, {-1.0, 0.7, 3.0}, {point(), point(), point()}});
        const bool says = static_cast<bool>(certifyCarriage(way, rod, resting, moving));
        const double room = sampledRoom(way, rod, resting, moving, 3.0);
        EXPECT_TRUE(!says || room > 0.0) << seed;
        EXPECT_TRUE(says || room < 0.02) << seed << " " << room;
        free += says ? 1 : 0;
        touched += room < 0.0 ? 1 : 0;
    }
    EXPECT_GT(free, 20);
    EXPECT_GT(touched, 20);
}

CarriageOptions options()
{
    CarriageOptions all{};
    all.lower = {-10.0, -10.0};
    all.upper = {10.0, 10.0};
    all.spacing = 0.5;
    all.headings = 8;
    all.speed = std::sqrt(2.0) * 0.5;  // a tick is 1
    all.turnRate = 1.0;
    return all;
}

TEST(CarriagePlan, TakesTheFewestTicks)
{
    const CarriagePlan plan = planCarriage({3.0, {-5.1, 2.1}, 0.1}, {1.0, 0.0}, M_PI_2, rod, nothing, {}, options());
    ASSERT_EQ(plan.failure, CarriageFailure::None);
    // One tick to the lattice (12 to the left, 4 up), 12 steps, 2 turns.
    EXPECT_NEAR(plan.way.back().time, 3.0 + 1.0 + 12.0 + 2.0, 1e-12);
    EXPECT_EQ(plan.way.size(), 16U);
    EXPECT_LT((plan.way.back().place - Vector2d(1.0, 0.0)).norm(), 1e-12);
    EXPECT_NEAR(std::remainder(plan.way.back().heading - M_PI_2, 2.0 * M_PI), 0.0, 1e-12);
}

/// A wall with a door in it, wide enough for the rod lengthwise.
ChordObstacles<2> wallWithDoor()
{
    return ChordObstacles<2>({solidBox("below", Vector2d(-0.2, -20.0), Vector2d(0.2, -0.4)),
                              solidBox("above", Vector2d(-0.2, 0.4), Vector2d(0.2, 20.0))});
}

TEST(CarriagePlan, WaitsUntilTheDoorIsFree)
{
    const ChordObstacles<2> wall = wallWithDoor();
    const CarrierPose start{0.0, {-4.0, 0.0}, 0.0};
    const auto plan = [&](const std::vector<MovingDisc> &moving)
    {
        return planCarriage(start, {4.0, 0.0}, 0.0, rod, wall, moving, options());
    };
    const CarriagePlan open = plan({});
    ASSERT_EQ(open.failure, CarriageFailure::None);
    EXPECT_NEAR(open.way.back().time, 17.0, 1e-12) << "one tick to begin, 16 steps";
    // A disc in the door that leaves along the wall, far side, from t = 20 to 30.
    const std::vector<MovingDisc> guard{{0.3, {20.0, 22.0, 30.0}, {{0.0, 0.0}, {1.5, 0.0}, {1.5, 9.0}}}};
    const CarriagePlan waited = plan(guard);
    ASSERT_EQ(waited.failure, CarriageFailure::None);
    EXPECT_GT(waited.way.back().time, 22.0);
    EXPECT_LT(waited.way.back().time, 40.0);
    EXPECT_TRUE(certifyCarriage(waited.way, rod, wall, guard));
    EXPECT_GT(sampledRoom(waited.way, rod, wall, guard, 50.0), 0.0);
    // At the times of the other plan it would have met it.
    EXPECT_FALSE(certifyCarriage(open.way, rod, wall, guard));
    const CarriagePlan again = plan(guard);
    ASSERT_EQ(again.way.size(), waited.way.size());
    for (std::size_t i = 0; i < again.way.size(); ++i)
        EXPECT_EQ(again.way[i].place, waited.way[i].place);
    EXPECT_EQ(again.states, waited.states);
}

TEST(CarriagePlan, DoesNotEndWhereADiscComesLater)
{
    // It comes to the goal, stays a while and goes.
    const std::vector<MovingDisc> visitor{{0.3, {30.0, 40.0, 50.0}, {{4.0, 9.0}, {4.0, 0.0}, {4.0, 9.0}}}};
    const CarriagePlan plan = planCarriage({0.0, {2.0, 0.0}, 0.0}, {4.0, 0.0}, 0.0, rod, nothing, visitor, options());
    ASSERT_EQ(plan.failure, CarriageFailure::None);
    EXPECT_GT(plan.way.back().time, 40.0);
    EXPECT_TRUE(certifyCarriage(plan.way, rod, nothing, visitor));
}

TEST(CarriagePlan, NamesWhyThereIsNone)
{
    const ChordObstacles<2> wall({solidBox("wall", Vector2d(-0.2, -20.0), Vector2d(0.2, 20.0))});
    const auto failure =
        [&](const Vector2d &from, const Vector2d &to, const std::vector<MovingDisc> &moving, int most = 100'000)
    {
        CarriageOptions all = options();
        all.maxStates = most;
        return planCarriage({0.0, from, 0.0}, to, 0.0, rod, wall, moving, all).failure;
    };
    EXPECT_EQ(failure({-4.0, 0.0}, {4.0, 0.0}, {}), CarriageFailure::NoWay);
    EXPECT_EQ(failure({-4.0, 0.0}, {4.0, 0.0}, {}, 10), CarriageFailure::TooMany);
    EXPECT_EQ(failure({-4.0, 0.0}, {0.5, 0.0}, {}), CarriageFailure::GoalBlocked);
    EXPECT_EQ(failure({0.5, 0.0}, {4.0, 0.0}, {}), CarriageFailure::StartBlocked);
    EXPECT_EQ(failure({4.0, 0.0}, {6.0, 0.0}, {{0.5, {9.0}, {{6.0, 0.2}}}}), CarriageFailure::GoalBlocked);
    EXPECT_EQ(toText(CarriageFailure::NoWay), "no_way");
}

TEST(Carriage, RefusesWhatIsOutOfRange)
{
    const std::vector<CarrierPose> way{{0.0, {0.0, 0.0}, 0.0}};
    EXPECT_THROW(certifyCarriage({}, rod, nothing, {}), std::invalid_argument);
    EXPECT_THROW(certifyCarriage({way[0], way[0]}, rod, nothing, {}), std::invalid_argument);
    EXPECT_THROW(certifyCarriage(way, {0.0, 0.0, 0.1}, nothing, {}), std::invalid_argument);
    EXPECT_THROW(certifyCarriage(way, rod, nothing, {{0.1, {0.0, 1.0}, {{0.0, 0.0}}}}), std::invalid_argument);
    CarriageOptions all = options();
    all.spacing = 0.0;
    EXPECT_THROW(planCarriage(way[0], {0.0, 0.0}, 0.0, rod, nothing, {}, all), std::invalid_argument);
}
}  // namespace
}  // namespace narrows
