// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/families/CircleScene.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "kernel/SegmentDistance.h"
#include "validity/Verifier.h"

namespace narrows
{
double rounded(double value, int decimals)
{
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale;
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

PlanarModel modelOf(const CircleScene &scene)
{
    std::vector<PlanarLink> links;
    for (const double length : scene.lengths)
        links.push_back({length, static_cast<int>(links.size()) - 1});
    PlanarModel model{PlanarArm(Eigen::Vector2d::Zero(), links), {}};
    for (const Circle &circle : scene.circles)
        model.obstacles.push_back({fmt::format("C{}", model.obstacles.size() + 1), circle});
    return model;
}

double clearance(const CircleScene &scene, const Eigen::VectorXd &q, int first)
{
    double least = std::numeric_limits<double>::infinity();
    Eigen::Vector2d tip = Eigen::Vector2d::Zero();
    for (Eigen::Index i = 0; i < q.size(); ++i)
    {
        const Eigen::Vector2d base = tip;
        tip += scene.lengths[static_cast<std::size_t>(i)] * Eigen::Vector2d(std::cos(q[i]), std::sin(q[i]));
        if (i < first)
            continue;
        for (const Circle &circle : scene.circles)
            least = std::min(least, std::sqrt(squaredDistance(base, tip, circle.center)) - circle.radius);
    }
    return least;
}

Motion judgeMotion(const CircleScene &scene, const Eigen::VectorXd &from, const Eigen::VectorXd &to)
{
    const JointLimits none{AngleConvention::Absolute, std::vector<std::optional<Interval>>(scene.lengths.size())};
    const Verdict verdict = verify(modelOf(scene), {from, to, none}, {from, to});
    if (verdict.accepted)
        return Motion::Free;
    return verdict.reason == "collision" ? Motion::Blocked : Motion::Undecided;
}

std::string toYaml(const CircleScene &scene, const std::string &name, const std::string &source)
{
    std::string links;
    for (const double length : scene.lengths)
        links += fmt::format("    - {{length: {}}}\n", length);
    std::string obstacles;
    for (const PlanarObstacle &obstacle : modelOf(scene).obstacles)
    {
        const auto &circle = std::get<Circle>(obstacle.shape);
        obstacles += fmt::format("  - {{name: {}, kind: circle, center: [{}, {}], radius: {}}}\n", obstacle.name,
                                 circle.center.x(), circle.center.y(), circle.radius);
    }
    const auto angles = [](const Eigen::VectorXd &q)
    {
        return fmt::format("{{angles: [{}]}}", fmt::join(q.data(), q.data() + q.size(), ", "));
    };
    return fmt::format(
        "format: narrows/scenario/1\nname: {}\nsource: {}\nrobot:\n  kind: planar_arm\n  base: [0, 0]\n  links:\n{}"
        "  radius: 0\n  angles: absolute\n  limits: none\nobstacles:{}{}start: {}\ngoal: {}\n",
        name, YAML::Dump(YAML::Node(source)), links, obstacles.empty() ? " []" : "\n",
        obstacles.empty() ? "\n" : obstacles, angles(scene.start), angles(scene.goal));
}
}  // namespace narrows
