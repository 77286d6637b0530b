// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/ArmScene.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "validity/ArmChecker.h"
#include "validity/Verifier.h"

namespace narrows
{
namespace
{
std::string list(const Eigen::VectorXd &values)
{
    return fmt::format("[{}]", fmt::join(values.data(), values.data() + values.size(), ", "));
}

/// Kind and keys of an obstacle, as files write them.
struct ShapeText
{
    std::string operator()(const Circle &circle) const
    {
        return fmt::format("kind: circle, center: {}, radius: {}", list(circle.center), circle.radius);
    }
    std::string operator()(const Superellipse &shape) const
    {
        return fmt::format("kind: superellipse, center: {}, half_extents: {}, exponent: {}", list(shape.center),
                           list(shape.halfExtents), shape.exponent);
    }
    std::string operator()(const Polygon &polygon) const
    {
        std::vector<std::string> vertices;
        for (const Eigen::Vector2d &vertex : polygon.vertices)
            vertices.push_back(list(vertex));
        return fmt::format("kind: polygon, vertices: [{}]", fmt::join(vertices, ", "));
    }
};

std::string robotText(const ArmScene &scene)
{
    std::string text = scene.slide ? fmt::format(
                                         "  kind: planar_chain\n  base: {{origin: [0, 0], slide: {{axis: {}, "
                                         "limits: [{}, {}]}}}}\n",
                                         list(scene.slide->axis), scene.slide->lower, scene.slide->upper)
                                   : "  kind: planar_arm\n  base: [0, 0]\n";
    text += "  links:\n";
    for (const double length : scene.lengths)
        text += fmt::format("    - {{length: {}}}\n", length);
    text += fmt::format("  radius: {}\n  angles: {}\n  limits: none\n", scene.radius,
                        scene.convention == AngleConvention::Absolute ? "absolute" : "relative");
    return text + (scene.selfCollision ? "  self_collision: true\n" : "");
}

std::string stateText(const ArmScene &scene, const PlanarArm &arm, const Eigen::VectorXd &absolute)
{
    Eigen::VectorXd q = arm.fromAbsolute(absolute, scene.convention);
    if (scene.convention == AngleConvention::Relative)  // differences of rounded numbers are not round
        for (double &value : q)
            value = rounded(value, 12);
    const std::string slide = scene.slide ? fmt::format("slide: {}, ", q[0]) : "";
    return fmt::format("{{{}angles: {}}}", slide, list(q.tail(arm.linkCount())));
}

std::string proofText(const std::optional<Confinement> &proof)
{
    if (!proof)
        return "";
    const auto &[first, along] = *proof;
    return fmt::format("infeasible: {{first_joint: [{}, {}], along: [{}, {}]}}\n", first.lower, first.upper, along[0],
                       along[1]);
}
}  // namespace

double rounded(double value, int decimals)
{
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale;
}

Eigen::Vector2d rounded(const Eigen::Vector2d &point, int decimals)
{
    return {rounded(point.x(), decimals), rounded(point.y(), decimals)};
}

std::vector<double> cut(const std::vector<double> &rods, int count)
{
    const int rodCount = static_cast<int>(rods.size());
    std::vector<double> pieces;
    for (int i = 0; i < rodCount; ++i)
    {
        const int share = (count + i) / rodCount;  // these sum to count
        pieces.insert(pieces.end(), static_cast<std::size_t>(share),
                      rounded(rods[static_cast<std::size_t>(i)] / share, 6));
    }
    return pieces;
}

void addObstacle(ArmScene &scene, std::variant<Circle, Superellipse, Polygon> shape)
{
    static constexpr const char *letters = "CEP";  // in the order of the variant
    scene.obstacles.push_back(
        {fmt::format("{}{}", letters[shape.index()], scene.obstacles.size() + 1), std::move(shape)});
}

PlanarModel modelOf(const ArmScene &scene)
{
    std::vector<PlanarLink> links;
    for (const double length : scene.lengths)
        links.push_back({length, static_cast<int>(links.size()) - 1});
    return {PlanarArm(Eigen::Vector2d::Zero(), links, scene.radius, scene.slide), scene.obstacles, scene.selfCollision};
}

double clearance(const ArmScene &scene, const Eigen::VectorXd &q)
{
    return makeArmChecker("analytic", modelOf(scene))->clearance(q);
}

Motion judgePath(const ArmScene &scene, const std::vector<Eigen::VectorXd> &path)
{
    const JointLimits none{AngleConvention::Absolute, std::vector<std::optional<Interval>>(scene.lengths.size())};
    const Verdict verdict = verify(modelOf(scene), {path.front(), path.back(), none}, path);
    if (verdict.accepted)
        return Motion::Free;
    return verdict.reason == "not_certified" ? Motion::Undecided : Motion::Blocked;
}

Motion judgeMotion(const ArmScene &scene, const Eigen::VectorXd &from, const Eigen::VectorXd &to)
{
    return judgePath(scene, {from, to});
}

std::string toYaml(const ArmScene &scene, const std::string &name, const std::string &source)
{
    const PlanarModel model = modelOf(scene);
    std::string obstacles;
    for (const PlanarObstacle &obstacle : scene.obstacles)
        obstacles += fmt::format("  - {{name: {}, {}}}\n", obstacle.name, std::visit(ShapeText{}, obstacle.shape));
    return fmt::format(
        "format: narrows/scenario/1\nname: {}\nsource: {}\nrobot:\n{}obstacles:{}{}start: {}\ngoal: {}\n{}", name,
        YAML::Dump(YAML::Node(source)), robotText(scene), obstacles.empty() ? " []" : "\n",
        obstacles.empty() ? "\n" : obstacles, stateText(scene, model.arm, scene.start),
        stateText(scene, model.arm, scene.goal), proofText(scene.infeasible));
}
}  // namespace narrows
