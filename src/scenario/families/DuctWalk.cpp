// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/DuctWalk.h"

#include <algorithm>
#include <optional>

#include "scenario/families/Draws.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::Vector3i;

/// One attempt, nothing where it leads out of the lattice or into itself.
std::optional<std::vector<Vector3d>> walkOnce(RandomNumbers &random, int bends, const DuctLattice &lattice)
{
    std::vector<Vector3i> passed{Vector3i::Zero()};
    std::vector<Vector3d> line{lattice.origin};
    int axis = 0;
    for (int piece = 0; piece <= bends; ++piece)
    {
        const int direction = piece == 0 || random.coin() ? 1 : -1;
        for (int steps = random.whole(2, 4); steps > 0; --steps)
        {
            Vector3i next = passed.back();
            next[axis] += direction;
            const bool inside =
                (next.array() >= lattice.lowest.array()).all() && (next.array() <= lattice.highest.array()).all();
            if (!inside || std::find(passed.begin(), passed.end(), next) != passed.end())
                return std::nullopt;
            passed.push_back(next);
        }
        line.push_back(lattice.at(passed.back()));
        axis = (axis + random.whole(1, 2)) % 3;
    }
    return line;
}
}  // namespace

std::vector<AxisBox<3>> ductAlong(const std::vector<Vector3d> &line)
{
    std::vector<AxisBox<3>> rooms;
    for (std::size_t i = 1; i < line.size(); ++i)
        rooms.push_back({line[i - 1].cwiseMin(line[i]).array() - 0.5 * ductWidth,
                         line[i - 1].cwiseMax(line[i]).array() + 0.5 * ductWidth});
    return rooms;
}

double lengthOfLine(const std::vector<Vector3d> &line)
{
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += (line[i] - line[i - 1]).norm();
    return length;
}

Vector3d pointOfLine(const std::vector<Vector3d> &line, double way)
{
    for (std::size_t i = 1; i < line.size(); ++i)
    {
        const double length = (line[i] - line[i - 1]).norm();
        if (way <= length)
            return line[i - 1] + way / length * (line[i] - line[i - 1]);
        way -= length;
    }
    return line.back();
}

std::vector<Vector3d> drawDuct(RandomNumbers &random, int bends, const DuctLattice &lattice)
{
    constexpr int mostDraws = 100000;
    std::optional<std::vector<Vector3d>> line;
    drawUntilOneWillDo(mostDraws,
                       [&]()
                       {
                           line = walkOnce(random, bends, lattice);
                           return line.has_value();
                       });
    return *line;
}
}  // namespace narrows
