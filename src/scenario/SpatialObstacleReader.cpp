// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/SpatialObstacleReader.h"

#include <fmt/format.h>

#include "scenario/MeshSurface.h"
#include "scenario/ObstacleNames.h"
#include "scenario/PrismReader.h"
#include "scenario/SpatialFields.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
using Shape = decltype(SpatialObstacle::shape);
std::optional<Shape> readSphere(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "center", "radius"});
    const std::optional<Eigen::Vector3d> center = entry.required("center").spatialPoint();
    const std::optional<double> radius = entry.required("radius").positive();
    if (!center || !radius)
        return std::nullopt;
    return Sphere{*center, *radius};
}

std::optional<Shape> readCapsule(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "from", "to", "radius"});
    const std::optional<Eigen::Vector3d> from = entry.required("from").spatialPoint();
    const Field toField = entry.required("to");
    const std::optional<Eigen::Vector3d> to = toField.spatialPoint();
    const std::optional<double> radius = entry.required("radius").positive();
    if (from && to && *from == *to)
        toField.fault("must differ from the point `from` (a capsule without length is a sphere)");
    else if (from && to && radius)
        return Capsule{*from, *to, *radius};
    return std::nullopt;
}

std::optional<Shape> readCylinder(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "center", "axis", "radius", "length"});
    const std::optional<Eigen::Vector3d> center = entry.required("center").spatialPoint();
    const std::optional<Eigen::Vector3d> axis = readAxis(entry.required("axis"));
    const std::optional<double> radius = entry.required("radius").positive();
    const std::optional<double> length = readLength(entry.required("length"));
    if (!center || !axis || !radius || !length)
        return std::nullopt;
    return Cylinder{*center, *axis, *radius, *length / 2.0};
}

std::optional<Shape> readBox(const Mapping &entry)
{
    entry.allowOnly({"name", "kind", "min", "max", "rotation"});
    const std::optional<Eigen::Vector3d> low = entry.required("min").spatialPoint();
    const Field field = entry.required("max");
    const std::optional<Eigen::Vector3d> high = field.spatialPoint();
    const std::optional<Eigen::Matrix3d> rotation = readRotation(entry.optional("rotation"));
    if (low && high && !(low->array() < high->array()).all())
        field.fault("must be greater than min in all three coordinates");
    else if (low && high && rotation)
    {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.translation() = (*low + *high) / 2.0;
        pose.linear() = *rotation;
        return Box{pose, (*high - *low) / 2.0};
    }
    return std::nullopt;
}

/// Where the points of a mesh's file are in the scene.
struct Placing
{
    double scale;
    Eigen::Matrix3d rotation;
    Eigen::Vector3d position;
};

std::optional<Placing> readPlacing(const Mapping &entry)
{
    const Field scaleField = entry.optional("scale");
    const std::optional<double> scale = scaleField.given() ? scaleField.positive() : std::optional<double>(1.0);
    const std::optional<Eigen::Matrix3d> rotation = readRotation(entry.optional("rotation"));
    const Field field = entry.optional("position");
    const std::optional<Eigen::Vector3d> position = field.given() ? field.spatialPoint() : Eigen::Vector3d(0, 0, 0);
    if (!scale || !rotation || !position)
        return std::nullopt;
    return Placing{*scale, *rotation, *position};
}

/// Judges the surface as `solid` asks for: by default a closed surface is that of a solid.
bool finishSurface(const Mapping &entry, Mesh &mesh)
{
    const Field file = entry.optional("file");
    const Field solid = entry.optional("solid");
    const std::optional<bool> asked = solid.flag();
    if (solid.given() && (!asked || !*asked))
        return asked.has_value();
    const std::string opening = findOpening(mesh);
    if (!opening.empty())
    {
        if (asked)
            solid.fault("the surface is not closed: " + opening);
        return !asked;
    }
    const std::string defect = orientOutwards(mesh);
    if (!defect.empty())
        file.fault(fmt::format("{}; its inside is not defined (`solid: false` takes the surface alone)", defect));
    mesh.closed = defect.empty();
    return mesh.closed;
}

std::optional<Shape> readMesh(const Mapping &entry, MeshFiles &files)
{
    entry.allowOnly({"name", "kind", "file", "scale", "rotation", "position", "solid"});
    std::optional<Mesh> mesh = files.read(entry.required("file"));
    const std::optional<Placing> placing = readPlacing(entry);
    if (!mesh || !finishSurface(entry, *mesh) || !placing)
        return std::nullopt;
    for (Eigen::Vector3d &vertex : mesh->vertices)
        vertex = placing->position + placing->rotation * (placing->scale * vertex);
    return *mesh;
}

std::optional<Shape> readShape(const Mapping &entry, MeshFiles &files)
{
    const std::string kind =
        entry.required("kind").oneOf({"sphere", "capsule", "cylinder", "box", "prism", "mesh"}).value_or("");
    if (kind == "sphere")
        return readSphere(entry);
    if (kind == "capsule")
        return readCapsule(entry);
    if (kind == "cylinder")
        return readCylinder(entry);
    if (kind == "box")
        return readBox(entry);
    if (kind == "prism")
    {
        const std::optional<Prism> prism = readPrism(entry);
        return prism ? std::optional<Shape>(*prism) : std::nullopt;
    }
    if (kind == "mesh")
        return readMesh(entry, files);
    return std::nullopt;
}
}  // namespace

SpatialObstaclesDraft readSpatialObstacles(const Field &field, MeshFiles &files)
{
    SpatialObstaclesDraft draft;
    ObstacleNames names;
    for (const Field &item : field.items(0, mostObstacles))
    {
        const Mapping entry(item);
        const std::string name = names.read(entry);
        if (const std::optional<Shape> shape = readShape(entry, files))
            draft.obstacles.push_back({name, *shape});
    }
    draft.names = names.all();
    return draft;
}
}  // namespace narrows
