// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/GapShape.h"

#include <cmath>

#include "scenario/families/ArmScene.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

constexpr int decimals = 12;

/// A plate, so that what is through the channel along its end is soon out of it.
Polygon turnedBox(const Vector2d &touch, const Vector2d &outwards, double size)
{
    constexpr double thickness = 0.2;                   // of the size, to either side
    const Vector2d along(outwards.y(), -outwards.x());  // along, outwards: a right-handed frame
    Polygon box;
    for (const auto &[x, y] : {std::pair{-thickness, 0.0}, {thickness, 0.0}, {thickness, 2.0}, {-thickness, 2.0}})
        box.vertices.push_back(rounded(Vector2d(touch + size * (x * along + y * outwards)), decimals));
    return box;
}

/// Corners on a circle that touches the line, one of them where it does.
Polygon corneredPolygon(const Vector2d &touch, const Vector2d &outwards, double size, RandomNumbers &random)
{
    const int corners = random.whole(4, 7);
    const double first = std::atan2(-outwards.y(), -outwards.x());
    Polygon polygon{{rounded(touch, decimals)}};
    for (int i = 1; i < corners; ++i)
    {
        const double angle = first + 2.0 * M_PI * (i + random.uniform(-0.3, 0.3)) / corners;
        polygon.vertices.push_back(
            rounded(Vector2d(touch + size * (outwards + Vector2d(std::cos(angle), std::sin(angle)))), decimals));
    }
    return polygon;
}

/// The point where an outer normal is -n lies at -x(n) from the centre, where x_i = a_i (a_i |n_i| / h)^(q - 1) with
/// the sign of n_i, h^q = sum of (a_i |n_i|)^q and 1/p + 1/q = 1.
Superellipse uprightSuperellipse(const Vector2d &touch, const Vector2d &outwards, double size, RandomNumbers &random)
{
    constexpr double exponent = 4.0;
    constexpr double dual = 4.0 / 3.0;
    Vector2d extents(size, rounded(size * random.uniform(0.5, 1.0), 6));
    if (random.coin())
        extents.reverseInPlace();
    const Vector2d scaled = extents.cwiseProduct(outwards).cwiseAbs();
    const double height = std::pow(std::pow(scaled.x(), dual) + std::pow(scaled.y(), dual), 1.0 / dual);
    Vector2d reach;
    for (int i = 0; i < 2; ++i)
        reach[i] = std::copysign(extents[i] * std::pow(scaled[i] / height, dual - 1.0), outwards[i]);
    return {rounded(Vector2d(touch + reach), decimals), extents, exponent};
}
}  // namespace

FamilyParameter gapShapeParameter()
{
    // Without a standard, so that what is told of scenes with circles is what it was before there were others.
    return {"shape",
            FamilyParameter::Kind::Name,
            std::nullopt,
            0,
            0,
            "of what is beside the gaps; circles if not given",
            {"circle", "box", "superellipse", "polygon"}};
}

GapShape gapShapeOf(const FamilyValues &values)
{
    const auto shape = values.find("shape");
    return shape == values.end() ? GapShape::Circle : static_cast<GapShape>(shape->second);
}

std::variant<Circle, Superellipse, Polygon> placeAtGap(GapShape shape, const Vector2d &touch, const Vector2d &outwards,
                                                       double size, RandomNumbers &random)
{
    switch (shape)
    {
        case GapShape::Box:
            return turnedBox(touch, outwards, size);
        case GapShape::Superellipse:
            return uprightSuperellipse(touch, outwards, size, random);
        case GapShape::Polygon:
            return corneredPolygon(touch, outwards, size, random);
        case GapShape::Circle:
            break;
    }
    return Circle{rounded(Vector2d(touch + size * outwards), decimals), size};
}
}  // namespace narrows
