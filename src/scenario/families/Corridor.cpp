// SPDX-License-Identifier: BSD-3-Clause
// HPPM-PRA, Section 5.1, Table 1. The last two links of the goal lie on the line y = x + 1, equally far from both
// centres: 0.9 / sqrt(2). Whatever the circles leave of that is the goal's clearance, and all that the scene has of it
// there.
#include <cmath>
#include <stdexcept>

#include "scenario/families/Families.h"

namespace narrows
{
namespace
{
const double closedRadius = 0.9 * std::sqrt(0.5);

double radiusOf(const FamilyValues &values)
{
    if (values.count("radius") != 0 && values.count("clearance") != 0)
        throw std::invalid_argument("takes radius or clearance, not both");
    if (values.count("clearance") != 0)
        return closedRadius - values.at("clearance");
    return values.count("radius") != 0 ? values.at("radius") : 0.58;
}

ArmScene drawCorridor(const FamilyValues &values)
{
    // Constants, not calls of atan2: the same on every machine, to the last bit, because the clearance is what they
    // leave.
    constexpr double atanHalf = 0.46364760900080615;
    constexpr double atanTwo = 1.1071487177940904;
    constexpr double diagonal = M_PI / 4.0;
    const double radius = rounded(radiusOf(values), 15);
    ArmScene scene;
    scene.lengths = {std::sqrt(5.0), std::sqrt(2.0), std::sqrt(0.5)};
    addObstacle(scene, Circle{{2.4, 2.5}, radius});
    addObstacle(scene, Circle{{1.6, 3.5}, radius});
    scene.start = Eigen::Vector3d(atanHalf, -diagonal, diagonal);
    scene.goal = Eigen::Vector3d(atanTwo, diagonal, diagonal);
    return scene;
}
}  // namespace

Family corridorFamily()
{
    using Kind = FamilyParameter::Kind;
    const double narrowest = 1e-8;
    return {
        "corridor",
        "case 1 of HPPM-PRA, three links into a wedge between two circles, nearly closed at the goal",
        {{"clearance", Kind::Real, std::nullopt, narrowest, 0.6, "of the goal: sqrt(0.405) minus the circles' radius"},
         {"radius", Kind::Real, std::nullopt, 0.01, closedRadius - narrowest,
          "of the circles, instead of clearance; 0.58, the paper's, if neither is given"}},
        drawCorridor};
}
}  // namespace narrows
