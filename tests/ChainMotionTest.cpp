// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "kernel/chain/ChainMotionProof.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double radius = 0.05;
const double share = std::sqrt(3.0) / 216.0;

PlanarArm planarChain(int links)
{
    std::vector<PlanarLink> all;
    for (int i = 0; i < links; ++i)
        all.push_back({1.0, i - 1});
    return {{0.0, 0.0}, all, radius, Slide{{0.0, 1.0}, -100.0, 100.0}};
}

SpatialArm spatialChain(int links)
{
    return universalChain({0.1, 0.2, 0.3}, std::vector<double>(links, 1.0), radius,
                          std::make_pair(Vector3d(0.6, 0.0, 0.8), Interval{-100.0, 100.0}));
}

/// A chain of unit links, its motions and where its joints are.
template <int D>
struct Chain;

template <>
struct Chain<2>
{
    explicit Chain(int links) : arm(planarChain(links)) {}
    void motion(const VectorXd &from, const VectorXd &to, ChainMotion<2> &found) const
    {
        chainMotion(arm, from, to, found);
    }
    void centres(const VectorXd &q, std::vector<Vector2d> &found) const { arm.place(q, found); }
    int dimension() const { return arm.dimension(); }

    PlanarArm arm;
};

template <>
struct Chain<3>
{
    explicit Chain(int links) : arm(spatialChain(links)), geometry(*chainGeometry(arm)) {}
    void motion(const VectorXd &from, const VectorXd &to, ChainMotion<3> &found) const
    {
        chainMotion(geometry, from, to, found);
    }
    void centres(const VectorXd &q, std::vector<Vector3d> &found) const { jointCentres(arm, q, found); }
    int dimension() const { return arm.dimension(); }

    SpatialArm arm;
    ChainGeometry geometry;
};

PlanarObstacle obstacleAt(const Vector2d &place, double size)
{
    return {"disc", Circle{place, size}};
}

SpatialObstacle obstacleAt(const Vector3d &place, double size)
{
    Eigen::Isometry3d pose(Eigen::AngleAxisd(place.x(), Vector3d(0.6, 0.0, 0.8)));
    pose.translation() = place;
    return {"box", Box{pose, {size, 0.7 * size, 1.3 * size}}};
}

class Random
{
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double draw(double most) { return std::uniform_real_distribution<double>(-most, most)(engine_); }
    VectorXd vector(int size, double most)
    {
        return VectorXd::NullaryExpr(size, [&] { return draw(most); });
    }

private:
    std::mt19937 engine_;
};

template <int D>
struct In
{
    static constexpr int value = D;
};

template <class Where>
class ChainMotions : public testing::Test
{
};
using Spaces = testing::Types<In<2>, In<3>>;
TYPED_TEST_SUITE(ChainMotions, Spaces);

TYPED_TEST(ChainMotions, RemaindersCoverAllOfTheWay)
{
    constexpr int D = TypeParam::value;
    constexpr int links = 12;
    const Chain<D> chain(links);
    double most = 0.0;
    for (unsigned seed = 1; seed <= 60; ++seed)
    {
        Random random(seed);
        const double size = std::pow(10.0, -random.draw(1.0) - 1.0);
        const VectorXd from = random.vector(chain.dimension(), 1.5);
        const VectorXd delta = random.vector(chain.dimension(), size);
        ChainMotion<D> motion;
        chain.motion(from, from + delta, motion);
        ASSERT_EQ(motion.remainder.size(), links + 1U);
        EXPECT_EQ(motion.remainder[0], 0.0);
        std::vector<Eigen::Matrix<double, D, 1>> centres;
        for (int step = 0; step <= 64; ++step)
        {
            const double t = step / 64.0;
            chain.centres(from + t * delta, centres);
            for (int i = 0; i <= links; ++i)
            {
                const auto parabola = (2.0 * (t - 0.5) * (t - 1.0) * motion.begin[i] +
                                       4.0 * t * (1.0 - t) * motion.middle[i] + 2.0 * t * (t - 0.5) * motion.end[i])
                                          .eval();
                const double away = (centres[i] - parabola).norm();
                EXPECT_LE(away, motion.remainder[i] + 1e-13 * links) << seed << " " << t << " " << i;
                if (size < 0.1 && i > 0)
                    most = std::max(most, away / motion.remainder[i]);
            }
        }
    }
    EXPECT_GT(most, 0.7) << "no larger than necessary";
}

TYPED_TEST(ChainMotions, FreeMeansThatNoSampleTouches)
{
    constexpr int D = TypeParam::value;
    using Point = Eigen::Matrix<double, D, 1>;
    constexpr int links = 6;
    const Chain<D> chain(links);
    int free = 0, proven = 0;
    for (unsigned seed = 1; seed <= 400; ++seed)
    {
        Random random(seed);
        std::vector<typename ChordObstacles<D>::Obstacle> all;
        for (int i = 0; i < 4 * (D - 1) * (D - 1); ++i)
        {
            Point place;
            for (int axis = 0; axis < D; ++axis)
                place[axis] = random.draw(4.0);
            all.push_back(obstacleAt(place, 0.5 + random.draw(0.3)));
        }
        const ChordObstacles<D> obstacles(all);
        const ChainSpec spec{links, 1.0, radius, 3.0, true};
        const VectorXd from = random.vector(chain.dimension(), 1.0);
        const VectorXd delta = random.vector(chain.dimension(), 0.1);
        ChainMotion<D> motion;
        chain.motion(from, from + delta, motion);
        const bool says = ChainMotionProof<D>(obstacles, spec).isFree(motion);

        double clearance = 1.0;
        std::vector<Point> centres;
        for (int step = 0; step <= 100; ++step)
        {
            chain.centres(from + 0.01 * step * delta, centres);
            for (int i = 0; i < links; ++i)
            {
                clearance = std::min(clearance, obstacles.clearance(centres[i], centres[i + 1], 1.0) - radius);
                for (int j = 0; j + 1 < i; ++j)
                    for (int k = 0; k <= 20; ++k)
                    {
                        const Point on = centres[j] + 0.05 * k * (centres[j + 1] - centres[j]);
                        const Point along = centres[i + 1] - centres[i];
                        const double t = std::clamp((on - centres[i]).dot(along), 0.0, 1.0);
                        clearance = std::min(clearance, (centres[i] + t * along - on).norm() - 2.0 * radius);
                    }
            }
        }
        EXPECT_TRUE(!says || clearance > 0.0) << seed << " " << clearance;
        free += clearance > 0.02 ? 1 : 0;
        proven += says ? 1 : 0;
    }
    EXPECT_GT(free, 100);
    EXPECT_LT(free, 350);
    EXPECT_GT(proven, 0.9 * free);
}

TEST(ChainMotion, OneJointByItsClosedForm)
{
    for (const double turn : {0.02, 0.3, 1.0})
    {
        ChainMotion<2> flat;
        chainMotion(planarChain(1), Vector2d(0.0, 0.4), Vector2d(2.0, 0.4 + turn), flat);
        EXPECT_NEAR(flat.remainder[1], share * std::pow(turn, 3), 1e-15);
        EXPECT_LT((flat.middle[1] - Vector2d(std::cos(0.4 + 0.5 * turn), 1.0 + std::sin(0.4 + 0.5 * turn))).norm(),
                  1e-15);
        ChainMotion<3> yaw;
        chainMotion(*chainGeometry(spatialChain(1)), Vector3d(0.0, 0.7, 0.0), Vector3d(2.0, 0.7, turn), yaw);
        EXPECT_NEAR(yaw.remainder[1], share * std::pow(turn, 3) * (1.0 + 0.5 * turn), 1e-14);
    }
}

/// Joints that undo each other's turns: pitch up, pitch down, and so on. Far ends hardly move, and their remainders
/// show it, where a sum over all rates would not.
TEST(ChainMotion, KnowsWhatJointsUndo)
{
    constexpr int links = 40;
    constexpr double turn = 0.05;
    VectorXd from = VectorXd::Zero(2 * links + 1), to = from;
    for (int i = 0; i < links; ++i)
        to[2 * i + 1] = i == 0 ? turn : (i % 2 == 0 ? 2.0 : -2.0) * turn;
    ChainMotion<3> motion;
    chainMotion(*chainGeometry(spatialChain(links)), from, to, motion);
    // All links turn by +-turn, so that |d'''| = turn^3. By the sum of all rates it would be tens of thousands of times
    // as much.
    EXPECT_LE(motion.remainder[links], 3.0 * share * links * std::pow(turn, 3));
}

/// A link that turns about a corner of a box at a distance: whether it is proven depends on that distance alone, since
/// it is divided until planes do.
TEST(ChainMotionProof, TurnsAboutACorner)
{
    const Polygon box{{{-1.0, -1.0}, {0.5, -1.0}, {0.5, 0.0}, {-1.0, 0.0}}};
    const ChordObstacles<2> obstacles({{"box", box}});
    const ChainSpec spec{1, 1.0, radius};
    const PlanarArm arm({0.0, 0.0}, {{1.0, -1}}, radius, Slide{{0.0, 1.0}, -1.0, 1.0});
    // From level to the tip 0.2 below, past the corner at (0.5, 0), which is 0.5 sin(a) above the link if the base is
    // as high above the box as it must be.
    const auto proven = [&](double room)
    {
        const auto base = [&](double angle)
        {
            return (0.5 * std::sin(angle) + radius + room) / std::cos(angle);
        };
        ChainMotion<2> motion;
        chainMotion(arm, Vector2d(base(0.30), -0.30), Vector2d(base(0.34), -0.34), motion);
        return ChainMotionProof<2>(obstacles, spec).isFree(motion);
    };
    EXPECT_TRUE(proven(2e-3));
    EXPECT_FALSE(proven(-1e-4));
}

/// The tip swings through its lowest place, 1 below the base, at a quarter of the motion; both ends and the middle are
/// 0.005 higher.
TEST(ChainMotionProof, KnowsTheLowestPlaceBetween)
{
    const PlanarArm arm = planarChain(1);
    const ChainSpec spec{1, 1.0, radius};
    ChainMotion<2> motion;
    chainMotion(arm, Vector2d(0.0, -M_PI_2 - 0.1), Vector2d(0.0, -M_PI_2 + 0.3), motion);
    const auto proven = [&](double room)
    {
        const double top = -1.0 - radius - room;
        const Polygon floor{{{-2.0, -3.0}, {2.0, -3.0}, {2.0, top}, {-2.0, top}}};
        return ChainMotionProof<2>(ChordObstacles<2>({{"floor", floor}}), spec).isFree(motion);
    };
    EXPECT_TRUE(proven(2e-3));
    EXPECT_FALSE(proven(-1e-4));
}

TEST(ChainMotionProof, MissesWhatIsNotConvexOnlyByItsDistance)
{
    const Polygon hook{{{0.0, -1.0}, {3.0, -1.0}, {3.0, 0.0}, {2.9, 0.0}, {2.9, -0.2}, {0.0, -0.2}}};
    const ChordObstacles<2> obstacles({{"hook", hook}});
    const ChainSpec spec{1, 1.0, radius};
    const PlanarArm arm({0.0, 0.0}, {{1.0, -1}}, radius, Slide{{1.0, 0.0}, 0.0, 4.0});
    ChainMotion<2> motion;
    chainMotion(arm, Vector2d(1.0, 0.0), Vector2d(1.2, 0.0), motion);
    EXPECT_TRUE(ChainMotionProof<2>(obstacles, spec).isFree(motion));
    chainMotion(arm, Vector2d(1.0, 0.0), Vector2d(1.8, 0.0), motion);
    EXPECT_FALSE(ChainMotionProof<2>(obstacles, spec).isFree(motion)) << "free, but near a hook";
    const Polygon floor{{{0.0, -1.0}, {2.9, -1.0}, {2.9, -0.2}, {0.0, -0.2}}};
    const Polygon post{{{2.9, -1.0}, {3.0, -1.0}, {3.0, 0.0}, {2.9, 0.0}}};
    EXPECT_TRUE(ChainMotionProof<2>(ChordObstacles<2>({{"floor", floor}, {"post", post}}), spec).isFree(motion));
}

TEST(ChainMotionProof, LinksKeepApartIfTheyHaveTo)
{
    // Three sides of a square that close to a triangle: the first and the last link meet where 2 radii are left.
    const PlanarArm arm = planarChain(3);
    ChainMotion<2> motion;
    const auto proven = [&](double closed, bool self)
    {
        const double third = M_PI - closed;
        chainMotion(arm, Eigen::Vector4d(0.0, 0.0, M_PI_2, third - 0.1), Eigen::Vector4d(0.0, 0.0, M_PI_2, third),
                    motion);
        const ChainSpec spec{3, 1.0, radius, 3.0, self};
        return ChainMotionProof<2>(ChordObstacles<2>({}), spec).isFree(motion);
    };
    // The tip is 1 - sin(angle) above the first link.
    const double meets = std::asin(1.0 - 2.0 * radius);
    EXPECT_TRUE(proven(-meets + 0.01, true));
    EXPECT_FALSE(proven(-meets - 0.01, true));
    EXPECT_TRUE(proven(-meets - 0.01, false));
}
}  // namespace
}  // namespace narrows
