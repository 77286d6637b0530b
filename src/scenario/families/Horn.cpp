// SPDX-License-Identifier: BSD-3-Clause
// horn: the planar kinematic chain of OMPL's demos. The arm, 1 long in n equal links, starts bent to half a turn
// between two walls of n - 1 pieces that follow it, w to its outside and inside, and shall lie straight the other way,
// nearly folded back at its base. Here the walls are as thick as asked for, away from the arm, where the demo has lines
// that motions checked at intervals jump over.
#include <algorithm>
#include <cmath>

#include "scenario/families/Families.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr int decimals = 12;

Vector2d unitVector(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

/// A wall over n - 1 pieces, which begins beside the first joint. \param offset from the arm, to the outside
/// \param thickness signed likewise, to where its other face is
Polygon wall(int links, double offset, double thickness)
{
    const double turn = M_PI / links;
    const double piece = (1.0 + M_PI * offset) / links;
    Polygon polygon;
    std::vector<Vector2d> face{{1.0 / links, -offset}};
    for (int i = 1; i < links; ++i)
        face.push_back(face.back() + piece * unitVector(i * turn));
    for (const Vector2d &corner : face)
        polygon.vertices.push_back(rounded(corner, decimals));
    for (int i = links - 1; i >= 0; --i)
    {
        // At right angles to the pieces that meet in this corner, half and half.
        const Vector2d outwards = unitVector((i + 0.5) * turn - M_PI / 2.0);
        polygon.vertices.push_back(
            rounded(Vector2d(face[static_cast<std::size_t>(i)] + thickness * outwards), decimals));
    }
    if (thickness > 0.0)
        std::reverse(polygon.vertices.begin(), polygon.vertices.end());  // to be counter-clockwise
    return polygon;
}

ArmScene drawHorn(const FamilyValues &values)
{
    const int links = static_cast<int>(values.at("links"));
    const double halfWidth =
        values.count("half_width") != 0 ? values.at("half_width") : std::log(double(links)) / links;
    const double thickness = values.at("thickness");
    ArmScene scene;
    scene.lengths.assign(static_cast<std::size_t>(links), 1.0 / links);
    scene.convention = AngleConvention::Relative;
    scene.selfCollision = true;
    VectorXd start = VectorXd::Constant(links, rounded(M_PI / links, decimals));
    start[0] = 0.0;
    scene.start = modelOf(scene).arm.toAbsolute(start, AngleConvention::Relative);
    scene.goal = VectorXd::Constant(links, rounded(M_PI - 1e-3, decimals));
    addObstacle(scene, wall(links, halfWidth, thickness));
    // The inner wall runs around a disc, which it fills if it is no wider than the wall is thick.
    const double inner = 1.0 / M_PI - halfWidth;
    if (inner > 2.0 * thickness)
        addObstacle(scene, wall(links, -halfWidth, -thickness));
    else
        addObstacle(scene,
                    Circle{rounded(Vector2d(1.0 / links, 1.0 / M_PI), decimals), std::max(inner, thickness / 2.0)});
    return scene;
}
}  // namespace

Family hornFamily()
{
    using Kind = FamilyParameter::Kind;
    return {
        "horn",
        "the kinematic chain of OMPL's demos, bent in a horn whose walls are thick; links must not touch each other",
        {{"links", Kind::Whole, 10, 3, 100, "of the arm, which is 1 long"},
         {"half_width", Kind::Real, std::nullopt, 0.01, 0.4,
          "from the arm's start to either wall; ln(links) / links, as in the demo, if not given"},
         {"thickness", Kind::Real, 0.03, 1e-3, 0.1, "of the walls, away from the arm"}},
        drawHorn};
}
}  // namespace narrows
