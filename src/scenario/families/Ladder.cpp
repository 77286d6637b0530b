// SPDX-License-Identifier: BSD-3-Clause
// The benchmark of Minnetoglu and Conkur 2022 (Section 3, Fig. 4) in shapes whose longest link is known or bounded, and
// our guess at their Fig. 22. docs/tight.md lists the bounds.
#include <cmath>

#include "scenario/families/ChainParameters.h"
#include "scenario/families/Families.h"

namespace narrows
{
namespace
{
struct LadderShape
{
    std::string name;
    std::vector<AxisBox<2>> rooms;  ///< corridors; the first one is the entrance, from y = -100 up
    Eigen::Vector2d goal;
    double way;  ///< length of the corridors' middle from the start to the goal
};

const std::vector<LadderShape> &shapes()
{
    static const std::vector<LadderShape> all{
        {"L", {{{0, -100}, {200, 1100}}, {{0, 900}, {1600, 1100}}}, {1550, 1000}, 2400},
        {"U40", {{{0, -100}, {200, 1100}}, {{240, 0}, {440, 1100}}, {{0, 900}, {440, 1100}}}, {340, 50}, 2140},
        {"S3",
         {{{0, -100}, {200, 1100}},
          {{0, 900}, {440, 1100}},
          {{240, 0}, {440, 1100}},
          {{240, 0}, {680, 200}},
          {{480, 0}, {680, 1100}},
          {{480, 900}, {920, 1100}},
          {{720, 0}, {920, 1100}}},
         {820, 50},
         4420},
        {"Z300", {{{0, -100}, {200, 1100}}, {{0, 900}, {500, 1100}}, {{300, 900}, {500, 2000}}}, {400, 1950}, 2200},
        {"Z600", {{{0, -100}, {200, 1100}}, {{0, 900}, {800, 1100}}, {{600, 900}, {800, 2000}}}, {700, 1950}, 2500},
        {"trap22", {{{0, -100}, {200, 1100}}, {{0, 900}, {1600, 1100}}, {{-600, 300}, {0, 1100}}}, {1550, 1000}, 2400},
        {"corner200x115", {{{0, -100}, {200, 1015.1}}, {{0, 900}, {1600, 1015.1}}}, {1550, 957.55}, 2357.55},
    };
    return all;
}

AxisBox<2> solidAround(const std::vector<AxisBox<2>> &rooms)
{
    AxisBox<2> solid = rooms.front();
    for (const AxisBox<2> &room : rooms)
    {
        solid.lower = solid.lower.cwiseMin(room.lower);
        solid.upper = solid.upper.cwiseMax(room.upper);
    }
    constexpr double thickness = 100.0;
    // Not below: there the entrance is open.
    return {solid.lower - Eigen::Vector2d(thickness, 0.0), solid.upper + Eigen::Vector2d::Constant(thickness)};
}

ChainScene<2> drawLadder(const FamilyValues &values)
{
    const LadderShape &shape = shapes()[static_cast<std::size_t>(values.at("shape"))];
    ChainScene<2> scene = chainOf<2>(values, values.at("length"), 1.5 * shape.way + values.at("length"));
    scene.walls = wallsAround<2>(shape.rooms, solidAround(shape.rooms));
    scene.entrance = {100.0, 50.0};
    scene.depth = 850.0;
    scene.goal = shape.goal;
    scene.tolerance = 10.0;
    return scene;
}
}  // namespace

Family ladderFamily()
{
    using Kind = FamilyParameter::Kind;
    FamilyParameter shape{"shape", Kind::Name, 0, 0, 0, "of the corridors, which are 200 wide"};
    for (const LadderShape &one : shapes())
        shape.names.push_back(one.name);
    return {"ladder",
            "a planar chain is fed through corridors with right-angle bends: how long may its links be?",
            {shape,
             {"length", Kind::Real, 350.0, 10.0, 2000.0, "of a link"},
             linksParameter(),
             {"radius", Kind::Real, 5.0, 0.0, 50.0, "of the links"},
             {"max_angle", Kind::Real, std::nullopt, 1.0, 180.0, "between neighbouring links, in degrees"}},
            drawLadder};
}
}  // namespace narrows
