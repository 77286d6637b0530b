// SPDX-License-Identifier: BSD-3-Clause
// What the families of chains on a slide have in common.
#pragma once

#include <cmath>

#include "scenario/families/DuctWalk.h"
#include "scenario/families/Family.h"

namespace narrows
{
inline FamilyParameter linksParameter()
{
    return {"links",      FamilyParameter::Kind::Whole,
            std::nullopt, 1,
            1000,         "of the chain; if it is not given, so many that the chain fills the way to the goal"};
}

inline FamilyParameter spatialRadiusParameter()
{
    return {"radius", FamilyParameter::Kind::Real, 2.0, 0.0, 10.0, "of the links"};
}

/// Universal joints cannot be told at right angles (JointCentres.h).
inline FamilyParameter spatialAngleParameter()
{
    return {"max_angle", FamilyParameter::Kind::Real, 88.0, 1.0, 89.9, "between neighbouring links, in degrees"};
}

inline FamilyParameter indexParameter()
{
    return {"index", FamilyParameter::Kind::Real,
            0.6,     0.05,
            1.2,     "length of a link over the longest that passes a right-angle bend of the duct flat"};
}

/// \pre the family has the parameters of index and radius
inline double lengthAtIndex(const FamilyValues &values)
{
    return rounded(values.at("index") * longestLinkAtBend(ductWidth, values.at("radius")), 6);
}

/// The chain that the values of "links", "radius" and "max_angle" tell. \param way that the links fill if no number is
/// given
template <int D>
ChainScene<D> chainOf(const FamilyValues &values, double length, double way)
{
    const auto links = values.find("links");
    const auto maxAngle = values.find("max_angle");
    ChainScene<D> scene{};
    scene.links = static_cast<int>(links != values.end() ? links->second : std::ceil(way / length));
    scene.length = length;
    scene.radius = values.at("radius");
    if (maxAngle != values.end())
        scene.maxAngle = maxAngle->second;
    return scene;
}
}  // namespace narrows
