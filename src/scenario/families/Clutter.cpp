// SPDX-License-Identifier: BSD-3-Clause
// A room full of boxes, entered along x: scene B of docs/tight.md, and random ones in which a duct was kept free.
#include <cmath>
#include <random>

#include "scenario/families/ChainParameters.h"
#include "scenario/families/DuctWalk.h"
#include "scenario/families/Families.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Kind = FamilyParameter::Kind;
using Box3 = AxisBox<3>;

const Vector3d roomSize(800.0, 480.0, 480.0);
const Vector3d entrance(40.0, 240.0, 240.0);
constexpr double clear = 150.0;  // no box before this x

/// All sides but the one at x = 0.
std::vector<Box3> roomWalls()
{
    constexpr double thickness = 20.0;
    const Box3 solid{{0.0, -thickness, -thickness}, roomSize.array() + thickness};
    return wallsAround<3>({{{-thickness, 0.0, 0.0}, roomSize}}, solid);
}

/// Sides of 24 to 72, then a center evenly in the room beyond x = 160, on whole numbers.
/// \param draw uniform in [0, 1)
template <class Draw>
Box3 drawBox(const Draw &draw)
{
    Vector3d half, center;
    for (double &size : half)
        size = 12.0 + 24.0 * draw();
    center.x() = 160.0 + 640.0 * draw();
    center.y() = roomSize.y() * draw();
    center.z() = roomSize.z() * draw();
    return {(center - half).array().floor(), (center + half).array().ceil()};
}

/// Draws boxes until there are so many that are wanted.
template <class Draw, class Wanted>
void fillRoom(ChainScene<3> &scene, int count, const Draw &draw, const Wanted &wanted)
{
    scene.walls = roomWalls();
    for (int found = 0; found < count;)
    {
        const Box3 box = drawBox(draw);
        if (box.lower.x() < clear || !wanted(box))
            continue;
        scene.walls.push_back(box);
        ++found;
    }
    scene.entrance = entrance;
    scene.depth = clear;
    scene.tolerance = 4.0;
}

ChainScene<3> drawPublished(const FamilyValues &values)
{
    ChainScene<3> scene = chainOf<3>(values, values.at("length"), 1200.0);
    scene.goal = {760.0, 100.0, 380.0};
    std::minstd_rand engine(7);  // x -> 48271 x mod 2^31 - 1, as the C++ standard fixes it
    engine.discard(200);
    fillRoom(
        scene, static_cast<int>(values.at("boxes")), [&engine] { return static_cast<double>(engine()) / 2147483647.0; },
        [&scene](const Box3 &box) { return box.distance(scene.goal) >= 25.0; });
    return scene;
}

ChainScene<3> drawRandom(const FamilyValues &values)
{
    RandomNumbers random(static_cast<std::uint64_t>(values.at("seed")));
    // From x = 120 to 720, and 60 or more from the other walls.
    const DuctLattice lattice{{120.0, 240.0, 240.0}, {0, -3, -3}, {10, 3, 3}};
    const std::vector<Vector3d> line = drawDuct(random, static_cast<int>(values.at("bends")), lattice);
    const std::vector<Box3> duct = ductAlong(line);
    ChainScene<3> scene =
        chainOf<3>(values, lengthAtIndex(values), 1.05 * (lengthOfLine(line) + line[0].x() - entrance.x()));
    scene.goal = line.back();
    const auto meetsDuct = [&duct](const Box3 &box)
    {
        return std::any_of(duct.begin(), duct.end(),
                           [&box](const Box3 &piece) {
                               return (box.lower.array() < piece.upper.array()).all() &&
                                      (piece.lower.array() < box.upper.array()).all();
                           });
    };
    fillRoom(
        scene, static_cast<int>(values.at("boxes")), [&random] { return random.uniform(0.0, 1.0); },
        [&meetsDuct](const Box3 &box) { return !meetsDuct(box); });
    return scene;
}

FamilyParameter boxesParameter()
{
    return {"boxes", Kind::Whole, 700, 0, 3000, "in the room, beside its walls"};
}
}  // namespace

Family boxesFamily()
{
    return {"boxes3d",
            "a chain is fed into a room of 800 x 480 x 480 full of boxes, always the same ones",
            {boxesParameter(),
             {"length", Kind::Real, 84.0, 5.0, 500.0, "of a link"},
             linksParameter(),
             spatialRadiusParameter(),
             spatialAngleParameter()},
            drawPublished};
}

Family clutterFamily()
{
    return {"clutter3d",
            "a chain is fed into a room full of random boxes, between which a square duct, 40 wide, was kept free",
            {boxesParameter(),
             {"bends", Kind::Whole, 4, 1, 10, "of the duct"},
             indexParameter(),
             linksParameter(),
             spatialRadiusParameter(),
             spatialAngleParameter(),
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers"}},
            drawRandom};
}
}  // namespace narrows
