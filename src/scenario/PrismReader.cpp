// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/PrismReader.h"

#include <cmath>

#include "scenario/PolygonReader.h"
#include "scenario/SpatialFields.h"

namespace narrows
{
namespace
{
/// The distance from a prism is worked out side by side.
constexpr std::size_t mostVertices = 1000;

/// A plane at right angles to an axis, seen along it: its x is level, along growing world x or y, whichever is nearer,
/// and its y as upright as can be. For the axes x, y, z these are the world's (y, z), (x, z) and (x, y).
Eigen::Matrix3d sectionFrame(const Eigen::Vector3d &axis)
{
    Eigen::Vector3d level(-axis.y(), axis.x(), 0.0);
    level = level.norm() > 0.0 ? Eigen::Vector3d(level.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitX());
    Eigen::Index larger = 0;
    level.cwiseAbs().maxCoeff(&larger);
    level *= std::copysign(1.0, level[larger]);
    const Eigen::Vector3d across = axis.cross(level);
    const bool isUp = across.z() > 0.0 || (across.z() == 0.0 && across.y() > 0.0);
    const Eigen::Vector3d up = isUp ? across : Eigen::Vector3d(-across);
    Eigen::Matrix3d frame;
    frame << level, up, level.cross(up);
    return frame;
}
}  // namespace

std::optional<Prism> readPrism(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "center", "axis", "vertices", "length"});
    const Field centerField = entry.optional("center");
    const std::optional<Eigen::Vector3d> center =
        centerField.given() ? centerField.spatialPoint() : Eigen::Vector3d(0, 0, 0);
    const std::optional<Eigen::Vector3d> axis = readAxis(entry.required("axis"));
    const std::optional<Polygon> section = readConvexPolygon(entry.required("vertices"), mostVertices);
    const std::optional<double> length = readLength(entry.required("length"));
    if (!center || !axis || !section || !length)
        return std::nullopt;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = *center;
    pose.linear() = sectionFrame(*axis);
    return Prism{section->vertices, pose, *length / 2.0};
}
}  // namespace narrows
