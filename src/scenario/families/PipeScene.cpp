// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/PipeScene.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "kernel/SpatialDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();

Vector3d inSpace(const Vector2d &point)
{
    return {0.0, point.x(), point.y()};
}

double fromSegment(const PipeScene::Section &section, const Vector2d &a, const Vector2d &b)
{
    return std::visit([&](const auto &shape) { return nearness(inSpace(a), inSpace(b), shape).distance; }, section);
}

/// Of a section from the other's boundary, or from all of it if it is a pipe.
struct DistanceFrom
{
    const PipeScene::Section &section;

    double operator()(const Cylinder &pipe) const
    {
        return distance(section, Vector2d(pipe.center.y(), pipe.center.z())) - pipe.radius;
    }
    double operator()(const Prism &prism) const
    {
        double least = infinity;
        for (std::size_t i = 0; i < prism.vertices.size(); ++i)
            least = std::min(least,
                             fromSegment(section, prism.vertices[i], prism.vertices[(i + 1) % prism.vertices.size()]));
        return least;
    }
};

struct Entry
{
    std::string name;

    std::string operator()(const Cylinder &pipe) const
    {
        return fmt::format("  - {{name: {}, kind: cylinder, axis: x, center: [0, {}, {}], radius: {}, length: inf}}\n",
                           name, pipe.center.y(), pipe.center.z(), pipe.radius);
    }
    std::string operator()(const Prism &prism) const
    {
        std::vector<std::string> vertices;
        for (const Vector2d &vertex : prism.vertices)
            vertices.push_back(fmt::format("[{}, {}]", vertex.x(), vertex.y()));
        return fmt::format("  - {{name: {}, kind: prism, axis: x, vertices: [{}], length: inf}}\n", name,
                           fmt::join(vertices, ", "));
    }
};
}  // namespace

PipeScene::Section pipeAround(const Vector2d &center, double radius)
{
    return Cylinder{inSpace(center), Vector3d::UnitX(), radius, infinity};
}

PipeScene::Section prismOver(std::vector<Vector2d> vertices)
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() << Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX();
    return Prism{std::move(vertices), pose, infinity};
}

double distance(const PipeScene::Section &section, const Vector2d &point)
{
    return fromSegment(section, point, point);
}

double distance(const PipeScene::Section &one, const PipeScene::Section &other)
{
    // Both ways, because a section within the other is far from its boundary.
    return std::min(std::visit(DistanceFrom{one}, other), std::visit(DistanceFrom{other}, one));
}

std::string toYaml(const PipeScene &scene, const std::string &name, const std::string &source)
{
    std::string obstacles;
    for (std::size_t i = 0; i < scene.sections.size(); ++i)
        obstacles += std::visit(Entry{fmt::format("S{}", i + 1)}, scene.sections[i]);
    std::vector<std::string> tips;
    for (const Vector2d &tip : scene.tips)
        tips.push_back(fmt::format("[{}, {}, {}]", PipeScene::armLength, tip.x(), tip.y()));
    std::string links;
    for (const int length : {486, 486, 486, 486, 486, 206, 206, 284})
        links += fmt::format("    - {{length: {}}}\n", length);
    return fmt::format(
        "format: narrows/scenario/1\nname: {}\nsource: {}\nrobot:\n  kind: spatial_arm\n  joints: universal\n"
        "  base: {{origin: [0, 0, 0], slide: {{axis: x, limits: [-500, 1000]}}}}\n  links:\n{}  radius: {}\n"
        "  max_link_angle: 42.5 deg\n  self_collision: true\nobstacles:\n{}"
        "start: {{slide: 0, joints: [[0, 0], [0, 0], [0, 0], [0, 0], [0, 0], [0, 0], [0, 0], [0, 0]]}}\n"
        "goal: {{tip_path: [{}], tolerance: 1e-3}}\n",
        name, YAML::Dump(YAML::Node(source)), links, PipeScene::armRadius, obstacles, fmt::join(tips, ", "));
}
}  // namespace narrows
