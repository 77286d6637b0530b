// SPDX-License-Identifier: BSD-3-Clause
// A solid block with a duct through it, entered along x: scene A of docs/tight.md, and random ones.
#include <cmath>

#include "scenario/families/ChainParameters.h"
#include "scenario/families/DuctWalk.h"
#include "scenario/families/Families.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Kind = FamilyParameter::Kind;

constexpr double tolerance = 4.0;

/// \param block the solid that the duct is cut out of; the line begins before it
ChainScene<3> ductScene(const FamilyValues &values, double length, const std::vector<Vector3d> &line,
                        const AxisBox<3> &block)
{
    ChainScene<3> scene = chainOf<3>(values, length, 1.05 * lengthOfLine(line));
    scene.walls = wallsAround<3>(ductAlong(line), block);
    scene.entrance = line.front();
    scene.depth = line[1].x() - line[0].x();
    scene.goal = line.back();
    scene.tolerance = tolerance;
    return scene;
}

ChainScene<3> drawMaze(const FamilyValues &values)
{
    const std::vector<Vector3d> line{{40, 240, 60},   {320, 240, 60},  {320, 240, 300}, {320, 420, 300},
                                     {440, 420, 300}, {440, 420, 100}, {440, 180, 100}, {560, 180, 100},
                                     {560, 180, 400}, {560, 60, 400},  {680, 60, 400},  {680, 60, 140},
                                     {680, 300, 140}, {800, 300, 140}, {800, 300, 400}};
    const AxisBox<3> block{{240, 0, 0}, {860, 480, 480}};
    ChainScene<3> scene = ductScene(values, values.at("length"), line, block);
    if (const auto fed = values.find("fed"); fed != values.end())
        scene.goal = pointOfLine(line, block.lower.x() - line.front().x() + fed->second * scene.reach());
    return scene;
}

ChainScene<3> drawPipe(const FamilyValues &values)
{
    RandomNumbers random(static_cast<std::uint64_t>(values.at("seed")));
    // All but the first piece stay inside of the block, whose face is at x = 0.
    const DuctLattice lattice{Vector3d::Zero(), {0, -6, -6}, {12, 6, 6}};
    std::vector<Vector3d> line;
    do
        line = drawDuct(random, static_cast<int>(values.at("bends")), lattice);
    while (std::any_of(line.begin() + 1, line.end(), [](const Vector3d &bend) { return bend.x() < ductWidth; }));

    AxisBox<3> block{line.front(), line.front()};
    for (const Vector3d &bend : line)
    {
        block.lower = block.lower.cwiseMin(bend);
        block.upper = block.upper.cwiseMax(bend);
    }
    block.lower -= Vector3d(0.0, ductWidth, ductWidth);
    block.upper += Vector3d::Constant(ductWidth);
    return ductScene(values, lengthAtIndex(values), line, block);
}
}  // namespace

Family mazeFamily()
{
    return {"maze3d",
            "a chain is fed into a square duct, 40 wide, with thirteen right-angle bends",
            {{"length", Kind::Real, 84.0, 5.0, 500.0, "of a link; 103.48 is the longest that passes such bends flat"},
             linksParameter(),
             {"fed", Kind::Real, std::nullopt, 0.1, 1.0,
              "share of the chain that is in the duct when its tip is at the goal; if it is not given, the goal is at "
              "the duct's end"},
             spatialRadiusParameter(),
             spatialAngleParameter()},
            drawMaze};
}

Family ductFamily()
{
    return {"pipe3d",
            "a chain is fed into a square duct, 40 wide, with right-angle bends in random planes",
            {{"bends", Kind::Whole, 8, 1, 20, "of the duct"},
             indexParameter(),
             linksParameter(),
             spatialRadiusParameter(),
             spatialAngleParameter(),
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers"}},
            drawPipe};
}
}  // namespace narrows
