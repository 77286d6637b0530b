// SPDX-License-Identifier: BSD-3-Clause
// Solid scenes of the tight-maneuvering benchmarks, made of boxes around their rooms.
#pragma once

#include <set>

#include "TightScenes.h"
#include "kernel/chain/ChordObstacles.h"

namespace narrows
{
inline PlanarObstacle solidBox(const std::string &name, const Eigen::Vector2d &lower, const Eigen::Vector2d &upper)
{
    return {name, Polygon{{lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}}}};
}

inline SpatialObstacle solidBox(const std::string &name, const Eigen::Vector3d &lower, const Eigen::Vector3d &upper)
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = 0.5 * (lower + upper);
    return {name, Box{pose, 0.5 * (upper - lower)}};
}

/// What is left of a box when rooms are cut out of it, in boxes: cells between all the planes of rooms, joined along
/// the axes.
template <int D>
class SolidWithRooms
{
public:
    using Point = Eigen::Matrix<double, D, 1>;
    using Index = Eigen::Matrix<int, D, 1>;

    SolidWithRooms(const OpenBox<D> &solid, const std::vector<OpenBox<D>> &rooms)
    {
        for (int axis = 0; axis < D; ++axis)
        {
            std::set<double> cuts{solid.lower[axis], solid.upper[axis]};
            for (const OpenBox<D> &room : rooms)
                for (const double cut : {room.lower[axis], room.upper[axis]})
                    if (cut > solid.lower[axis] && cut < solid.upper[axis])
                        cuts.insert(cut);
            cuts_[axis].assign(cuts.begin(), cuts.end());
            counts_[axis] = static_cast<int>(cuts.size()) - 1;
        }
        filled_.assign(counts_.prod(), 1);
        for (int cell = 0; cell < counts_.prod(); ++cell)
        {
            const Point middle = 0.5 * (corner(indexOf(cell)) + corner((indexOf(cell).array() + 1).matrix()));
            for (const OpenBox<D> &room : rooms)
                if ((middle.array() > room.lower.array()).all() && (middle.array() < room.upper.array()).all())
                    filled_[cell] = 0;
        }
    }

    auto boxes()
    {
        std::vector<typename ChordObstacles<D>::Obstacle> result;
        for (int cell = 0; cell < counts_.prod(); ++cell)
        {
            if (!filled_[cell])
                continue;
            const Index begin = indexOf(cell);
            Index end = (begin.array() + 1).matrix();
            for (int axis = 0; axis < D; ++axis)
                while (end[axis] < counts_[axis] && isLayerFilled(begin, end, axis))
                    ++end[axis];
            clear(begin, end);
            result.push_back(solidBox("solid" + std::to_string(result.size()), corner(begin), corner(end)));
        }
        return result;
    }

private:
    Index indexOf(int cell) const
    {
        Index index;
        for (int axis = 0; axis < D; ++axis)
        {
            index[axis] = cell % counts_[axis];
            cell /= counts_[axis];
        }
        return index;
    }
    Point corner(const Index &index) const
    {
        Point point;
        for (int axis = 0; axis < D; ++axis)
            point[axis] = cuts_[axis][index[axis]];
        return point;
    }
    /// Whether the layer next to [begin, end) along an axis is filled.
    bool isLayerFilled(const Index &begin, const Index &end, int axis) const
    {
        for (int cell = 0; cell < counts_.prod(); ++cell)
        {
            const Index index = indexOf(cell);
            bool inside = index[axis] == end[axis];
            for (int other = 0; other < D; ++other)
                inside = inside && (other == axis || (index[other] >= begin[other] && index[other] < end[other]));
            if (inside && !filled_[cell])
                return false;
        }
        return true;
    }
    void clear(const Index &begin, const Index &end)
    {
        for (int cell = 0; cell < counts_.prod(); ++cell)
            if ((indexOf(cell).array() >= begin.array()).all() && (indexOf(cell).array() < end.array()).all())
                filled_[cell] = 0;
    }

    std::vector<double> cuts_[D];
    Index counts_;
    std::vector<char> filled_;
};

/// A scene for a chain: obstacles, and where its tip goes.
template <int D>
struct LeaderScene
{
    std::vector<typename ChordObstacles<D>::Obstacle> obstacles;
    Eigen::Matrix<double, D, 1> start;
    Eigen::Matrix<double, D, 1> goal;
    Eigen::Matrix<double, D, 1> entrance;  ///< direction in which the chain comes
};

inline LeaderScene<2> planarScene(const std::vector<OpenBox<2>> &rooms, const Eigen::Vector2d &goal)
{
    OpenBox<2> solid = rooms[0];
    for (const OpenBox<2> &room : rooms)
        solid = {solid.lower.cwiseMin(room.lower), solid.upper.cwiseMax(room.upper)};
    solid.lower.array() -= 100.0;
    solid.upper.array() += 100.0;
    solid.lower.y() = 0.0;
    return {SolidWithRooms<2>(solid, rooms).boxes(), {100.0, 50.0}, goal, Eigen::Vector2d::UnitY()};
}

/// Corridors 200 wide, entered upwards at x = 100.
inline LeaderScene<2> cornerL()
{
    return planarScene({{{0.0, 0.0}, {200.0, 1100.0}}, {{0.0, 900.0}, {1100.0, 1100.0}}}, {1050.0, 1000.0});
}
inline LeaderScene<2> turnU40()
{
    return planarScene(
        {{{0.0, 0.0}, {200.0, 1100.0}}, {{240.0, 0.0}, {440.0, 1100.0}}, {{0.0, 900.0}, {440.0, 1100.0}}},
        {340.0, 50.0});
}
inline LeaderScene<2> bendZ(double offset)
{
    return planarScene({{{0.0, 0.0}, {200.0, 1100.0}},
                        {{0.0, 900.0}, {200.0 + offset, 1100.0}},
                        {{offset, 900.0}, {200.0 + offset, 2000.0}}},
                       {100.0 + offset, 1950.0});
}
inline LeaderScene<2> turnsS3()
{
    return planarScene({{{0.0, 0.0}, {200.0, 1100.0}},
                        {{0.0, 900.0}, {440.0, 1100.0}},
                        {{240.0, 100.0}, {440.0, 1100.0}},
                        {{240.0, 100.0}, {680.0, 300.0}},
                        {{480.0, 100.0}, {680.0, 1100.0}},
                        {{480.0, 900.0}, {920.0, 1100.0}},
                        {{720.0, 100.0}, {920.0, 1100.0}}},
                       {820.0, 150.0});
}

/// Scene A of the findings: the pipe of thirteen bends as a solid.
inline LeaderScene<3> pipeA()
{
    const std::vector<Eigen::Vector3d> line = bentPipeLine();
    std::vector<OpenBox<3>> rooms;
    for (std::size_t i = 1; i < line.size(); ++i)
        rooms.push_back({line[i - 1].cwiseMin(line[i]).array() - 20.0, line[i - 1].cwiseMax(line[i]).array() + 20.0});
    const OpenBox<3> solid{{240.0, 0.0, 0.0}, {860.0, 480.0, 480.0}};
    return {SolidWithRooms<3>(solid, rooms).boxes(), line.front(), line.back(), Eigen::Vector3d::UnitX()};
}

/// Scene B: clutter.
inline LeaderScene<3> clutterB(int count)
{
    return {clutter(count), {40.0, 240.0, 240.0}, {760.0, 100.0, 380.0}, Eigen::Vector3d::UnitX()};
}
}  // namespace narrows
