// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/SpatialFields.h"

#include <limits>

#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
constexpr double shortestAxis = 1e-9;
}  // namespace

std::optional<Eigen::Vector3d> readAxis(const Field &field)
{
    if (!field.given())
        return std::nullopt;
    if (field.node().IsScalar())
    {
        const std::optional<std::string> name = field.oneOf({"x", "y", "z"});
        return name ? std::optional<Eigen::Vector3d>(Eigen::Vector3d::Unit((*name)[0] - 'x')) : std::nullopt;
    }
    const std::optional<Eigen::Vector3d> axis = field.spatialPoint();
    if (!axis || axis->norm() >= shortestAxis)
        return axis ? std::optional<Eigen::Vector3d>(axis->normalized()) : std::nullopt;
    field.fault("must not be a zero vector");
    return std::nullopt;
}

std::optional<Eigen::Matrix3d> readRotation(const Field &field)
{
    if (!field.given())
        return Eigen::Matrix3d::Identity();
    const Mapping rotation(field);
    rotation.allowOnly({"axis", "angle"});
    const std::optional<Eigen::Vector3d> axis = readAxis(rotation.required("axis"));
    const std::optional<double> angle = rotation.required("angle").angle();
    if (!axis || !angle)
        return std::nullopt;
    return Eigen::AngleAxisd(*angle, *axis).toRotationMatrix();
}

std::optional<double> readLength(const Field &field)
{
    if (field.isWord("inf") || field.isWord(".inf"))
        return std::numeric_limits<double>::infinity();
    return field.positive();
}
}  // namespace narrows
