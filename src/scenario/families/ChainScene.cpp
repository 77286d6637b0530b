// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/ChainScene.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "scenario/families/ArmScene.h"

namespace narrows
{
namespace
{
constexpr int decimals = 9;

template <class Point>
std::string list(const Point &point)
{
    return fmt::format("[{}]", fmt::join(point.data(), point.data() + point.size(), ", "));
}

/// One piece of text for each link.
std::string repeated(int links, const std::string &first, const std::string &other)
{
    return fmt::format("[{}]", fmt::join(
                                   [&]
                                   {
                                       std::vector<std::string> texts(static_cast<std::size_t>(links), other);
                                       texts.front() = first;
                                       return texts;
                                   }(),
                                   ", "));
}

/// What files of both kinds have in common. \param robot lines that differ \param joints the key and the start's values
template <int D>
std::string file(const ChainScene<D> &scene, const std::string &name, const std::string &source,
                 const std::string &kind, const std::string &robot, const std::string &joints)
{
    std::string links, obstacles;
    for (int i = 0; i < scene.links; ++i)
        links += fmt::format("    - {{length: {}}}\n", scene.length);
    for (std::size_t i = 0; i < scene.walls.size(); ++i)
        obstacles += fmt::format("  - {{name: W{}, kind: box, min: {}, max: {}}}\n", i + 1, list(scene.walls[i].lower),
                                 list(scene.walls[i].upper));
    const double behind = -rounded(scene.reach(), decimals);
    return fmt::format(
        "format: narrows/scenario/1\nname: {}\nsource: {}\nrobot:\n  kind: {}\n"
        "  base: {{origin: {}, slide: {{axis: {}, limits: [{}, {}]}}}}\n  links:\n{}  radius: {}\n{}"
        "  self_collision: true\nobstacles:\n{}start: {{slide: {}, {}}}\ngoal: {{tip: {}, tolerance: {}}}\n",
        name, YAML::Dump(YAML::Node(source)), kind, list(scene.entrance), D == 2 ? "[0, 1]" : "x",
        rounded(behind - scene.length, decimals), scene.depth, links, scene.radius, robot, obstacles, behind, joints,
        list(scene.goal), scene.tolerance);
}
}  // namespace

double longestLinkAtBend(double width, double radius)
{
    return M_SQRT2 * (2.0 * (width - radius) - M_SQRT2 * radius);
}

std::string toYaml(const ChainScene<2> &scene, const std::string &name, const std::string &source)
{
    std::string limits = "none";
    if (scene.maxAngle)
        limits = repeated(scene.links, fmt::format("[{} deg, {} deg]", 90.0 - *scene.maxAngle, 90.0 + *scene.maxAngle),
                          fmt::format("[{} deg, {} deg]", -*scene.maxAngle, *scene.maxAngle));
    return file(scene, name, source, "planar_chain", fmt::format("  angles: relative\n  limits: {}\n", limits),
                "angles: " + repeated(scene.links, "90 deg", "0"));
}

std::string toYaml(const ChainScene<3> &scene, const std::string &name, const std::string &source)
{
    const std::string limit =
        scene.maxAngle ? fmt::format("  max_link_angle: {} deg\n", *scene.maxAngle) : std::string();
    return file(scene, name, source, "spatial_arm", "  joints: universal\n" + limit,
                "joints: " + repeated(scene.links, "[0, 0]", "[0, 0]"));
}
}  // namespace narrows
