// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/BoxArrays.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace narrows
{
namespace
{
template <class T>
class BoxArraysOf : public testing::Test
{
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(BoxArraysOf, Dimensions);

/// Random segments, and the truth about the boxes around them.
template <int Dim>
struct Segments
{
    using Vector = Eigen::Matrix<double, Dim, 1>;

    Segments(int count, unsigned seed)
    {
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
        for (int i = 0; i < count; ++i)
        {
            Vector from, to;
            for (int axis = 0; axis < Dim; ++axis)
            {
                from[axis] = coordinate(generator);
                to[axis] = from[axis] + 0.3 * coordinate(generator);
            }
            a.push_back(from);
            b.push_back(to);
        }
        boxes.resize(count);
        for (int i = 0; i < count; ++i)
            boxes.set(i, a[i], b[i], room);
    }

    static bool meet(const Segments &one, int i, const Segments &other, int j)
    {
        const auto lower = [](const Segments &s, int k)
        {
            return (s.a[k].cwiseMin(s.b[k]).array() - room).eval();
        };
        const auto upper = [](const Segments &s, int k)
        {
            return (s.a[k].cwiseMax(s.b[k]).array() + room).eval();
        };
        return (lower(one, i) <= upper(other, j)).all() && (lower(other, j) <= upper(one, i)).all();
    }

    static constexpr double room = 0.05;
    std::vector<Vector> a, b;
    BoxArrays<Dim> boxes;
};

TYPED_TEST(BoxArraysOf, FindsWhatBruteForceFinds)
{
    constexpr int dim = TypeParam::value;
    for (const int count : {1, 4, 7, 20})
        for (const int others : {0, 1, 5, 32, 75})
        {
            const Segments<dim> mine(count, 1 + count), theirs(others, 100 + others);
            std::vector<ObstacleBits> found;
            mine.boxes.findMeetings(theirs.boxes, found);
            for (int i = 0; i < count; ++i)
            {
                ObstacleBits expected = 0;
                for (int k = 0; k < others; ++k)
                    if (Segments<dim>::meet(mine, i, theirs, k))
                        expected |= 1u << (k % 32);
                EXPECT_EQ(found[i], expected) << count << " " << others << " " << i;
            }
            for (int i = 0; i < count; ++i)
                for (int j = 0; j < count; ++j)
                    EXPECT_EQ(mine.boxes.meet(i, j), Segments<dim>::meet(mine, i, mine, j));
        }
}

TEST(BoxArrays, NeverTakesTouchingBoxesForApart)
{
    // Ends that single precision cannot tell apart, either way.
    for (const double end : {1.0 / 3.0, 0.1, 1e6 + 0.1, 3e-9})
    {
        BoxArrays<2> boxes, others;
        boxes.resize(1);
        others.resize(2);
        boxes.set(0, {end - 1.0, 0.0}, {end, 1.0}, 0.0);
        others.set(0, {end, 0.5}, {end + 1.0, 0.5}, 0.0);                 // touches
        others.set(1, {end * (1.0 + 1e-3), 0.5}, {end + 1.0, 0.5}, 0.0);  // does not
        std::vector<ObstacleBits> found;
        boxes.findMeetings(others, found);
        EXPECT_EQ(found[0], 1u) << end;
    }
}

TEST(BoxArrays, MeetsEverythingIfItIsNotANumber)
{
    BoxArrays<2> boxes, others;
    boxes.resize(1);
    others.resize(1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    boxes.set(0, {nan, nan}, {nan, nan}, 0.0);
    others.set(0, {5.0, 5.0}, {6.0, 6.0}, 0.0);
    std::vector<ObstacleBits> found;
    boxes.findMeetings(others, found);
    EXPECT_EQ(found[0], 1u);
}
}  // namespace
}  // namespace narrows
