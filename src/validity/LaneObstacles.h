// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/PlanarObstacle.h"
#include "validity/LaneGeometry.h"

namespace narrows
{
/// The obstacles of a scene as LaneGeometry.h looks at them: circles, superellipses of exponent 4, polygons. Other
/// superellipses have their box only; what meets it is left open.
class LaneObstacles
{
public:
    /// \param radius of the links
    /// \param room how far links may be from where they are said to be
    LaneObstacles(const std::vector<PlanarObstacle> &obstacles, double radius, double room);

    /// Around each, with room for a link's radius and for rounding.
    const std::vector<lanes::Box> &boxes() const { return boxes_; }

    /// What can be said of the segments ab and obstacle k; `found` becomes the worse of it and what it was.
    void examine(std::size_t k, const lanes::Points &a, const lanes::Points &b, lanes::Findings &found) const;

private:
    struct Polygon
    {
        std::vector<lanes::Edge> edges;
        lanes::Range range;
    };
    struct Boxed  ///< nothing more is known
    {
    };
    using Shape = std::variant<lanes::Circle, lanes::Quartic, Polygon, Boxed>;

    Shape shapeOf(const Circle &circle, double room) const;
    Shape shapeOf(const Superellipse &shape, double room) const;
    Shape shapeOf(const narrows::Polygon &polygon, double room) const;

    double radius_;
    std::vector<lanes::Box> boxes_;
    std::vector<Shape> shapes_;
};

/// Of distances that mean contact up to `contact`, `room` being what rounding may do to them.
lanes::Range laneRange(double contact, double room);
}  // namespace narrows
