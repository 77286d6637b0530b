// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/SpaceScene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "validity/ArmChecker.h"
#include "validity/Verifier.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

std::string list(const Eigen::VectorXd &values)
{
    return fmt::format("[{}]", fmt::join(values.data(), values.data() + values.size(), ", "));
}

struct ArmOf
{
    double radius;

    SpatialArm operator()(const SpaceScene::Chain &lengths) const
    {
        return universalChain(Vector3d::Zero(), lengths, radius);
    }
    SpatialArm operator()(SpaceScene::Table rows) const
    {
        for (DenavitHartenberg &row : rows)
            row.radius = row.radius > 0.0 ? row.radius : radius;
        return denavitHartenbergArm(Eigen::Isometry3d::Identity(), rows);
    }
};

/// What files say of the robot.
struct RobotText
{
    std::string operator()(const SpaceScene::Chain &lengths) const
    {
        std::string text = "  joints: universal\n  links:\n";
        for (const double length : lengths)
            text += fmt::format("    - {{length: {}}}\n", length);
        return text;
    }
    std::string operator()(const SpaceScene::Table &rows) const
    {
        std::string text = "  joints: dh\n  links:\n";
        for (const DenavitHartenberg &row : rows)
        {
            text += fmt::format("    - {{theta: {}, d: {}, a: {}, alpha: {}", row.theta, row.d, row.a, row.alpha);
            text += row.limits ? fmt::format(", limits: [{}, {}]", row.limits->lower, row.limits->upper) : "";
            text += row.radius > 0.0 ? fmt::format(", radius: {}}}\n", row.radius) : "}\n";
        }
        return text;
    }
};

/// Universal joints come in pairs.
std::string stateText(const SpaceScene &scene, const Eigen::VectorXd &q)
{
    if (scene.robot.index() == 1)
        return list(q);
    std::vector<std::string> pairs;
    for (Eigen::Index i = 0; i < q.size(); i += 2)
        pairs.push_back(list(q.segment(i, 2)));
    return fmt::format("[{}]", fmt::join(pairs, ", "));
}
}  // namespace

void addOpening(SpaceScene &scene, const Vector3d &middle, const Eigen::Vector2d &halfOpening, double halfThickness,
                double halfSquare)
{
    const auto add = [&](double left, double right, double bottom, double top)
    {
        scene.walls.push_back({{middle.x() - halfThickness, middle.y() + left, middle.z() + bottom},
                               {middle.x() + halfThickness, middle.y() + right, middle.z() + top}});
    };
    const double side = halfOpening.x(), height = halfOpening.y();
    add(-halfSquare, halfSquare, -halfSquare, -height);
    add(-halfSquare, halfSquare, height, halfSquare);
    if (side >= halfSquare)
        return;
    add(-halfSquare, -side, -height, height);
    add(side, halfSquare, -height, height);
}

SpatialModel modelOf(const SpaceScene &scene)
{
    SpatialModel model{std::visit(ArmOf{scene.radius}, scene.robot), {}, true};
    for (const SpaceScene::Wall &wall : scene.walls)
    {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.translation() = 0.5 * (wall.lower + wall.upper);
        model.obstacles.push_back(
            {fmt::format("B{}", model.obstacles.size() + 1), Box{pose, 0.5 * (wall.upper - wall.lower)}});
    }
    return model;
}

double clearance(const SpaceScene &scene, const Eigen::VectorXd &q)
{
    return makeArmChecker("analytic", modelOf(scene))->clearance(q);
}

Motion judgePath(const SpaceScene &scene, const std::vector<Eigen::VectorXd> &path)
{
    const Verdict verdict = verify(modelOf(scene), SpatialTask{path.front(), path.back()}, path);
    if (verdict.accepted)
        return Motion::Free;
    return verdict.reason == "not_certified" ? Motion::Undecided : Motion::Blocked;
}

Motion judgeMotion(const SpaceScene &scene, const Eigen::VectorXd &from, const Eigen::VectorXd &to)
{
    return judgePath(scene, {from, to});
}

std::string toYaml(const SpaceScene &scene, const std::string &name, const std::string &source)
{
    std::string walls;
    for (std::size_t i = 0; i < scene.walls.size(); ++i)
        walls += fmt::format("  - {{name: B{}, kind: box, min: {}, max: {}}}\n", i + 1, list(scene.walls[i].lower),
                             list(scene.walls[i].upper));
    return fmt::format(
        "format: narrows/scenario/1\nname: {}\nsource: {}\nrobot:\n  kind: spatial_arm\n{}  radius: {}\n"
        "  self_collision: true\nobstacles:\n{}start: {{joints: {}}}\ngoal: {{joints: {}}}\n",
        name, YAML::Dump(YAML::Node(source)), std::visit(RobotText{}, scene.robot), scene.radius, walls,
        stateText(scene, scene.start), stateText(scene, scene.goal));
}
}  // namespace narrows
