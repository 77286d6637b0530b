// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>

#include "scenario/families/Draws.h"
#include "scenario/families/Families.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
namespace
{
constexpr int mostDraws = 20000;

Eigen::VectorXd drawAngles(RandomNumbers &random, int count)
{
    Eigen::VectorXd angles(count);
    for (double &angle : angles)
        angle = rounded(random.uniform(-M_PI, M_PI), 6);
    return angles;
}

/// In a disc around the origin, by rejection: no sine that another machine rounds otherwise.
Eigen::Vector2d drawCenter(RandomNumbers &random, double discRadius)
{
    while (true)
    {
        const double x = random.uniform(-1.0, 1.0);
        const double y = random.uniform(-1.0, 1.0);
        if (x * x + y * y < 1.0)
            return {rounded(discRadius * x, 6), rounded(discRadius * y, 6)};
    }
}

/// The goal's angles become those nearest to the start's, a full turn more or less, so that the straight line between
/// the two is also the shortest way.
void unwind(ArmScene &scene)
{
    for (Eigen::Index i = 0; i < scene.goal.size(); ++i)
    {
        const double turns = std::round((scene.goal[i] - scene.start[i]) / (2.0 * M_PI));
        scene.goal[i] = rounded(scene.goal[i] - 2.0 * M_PI * turns, 6);
    }
}

ArmScene drawOnce(RandomNumbers &random, const FamilyValues &values)
{
    const int links = static_cast<int>(values.at("links"));
    ArmScene scene;
    scene.lengths = cut({values.at("reach")}, links);
    const int count =
        random.whole(static_cast<int>(values.at("min_circles")), static_cast<int>(values.at("max_circles")));
    for (int i = 0; i < count; ++i)
    {
        const double radius = rounded(random.uniform(values.at("min_radius"), values.at("max_radius")), 6);
        addObstacle(scene, Circle{drawCenter(random, values.at("disc")), radius});
    }
    scene.start = drawAngles(random, links);
    scene.goal = drawAngles(random, links);
    unwind(scene);
    return scene;
}

ArmScene drawCircles(const FamilyValues &values)
{
    if (values.at("min_circles") > values.at("max_circles") || values.at("min_radius") > values.at("max_radius"))
        throw std::invalid_argument("a minimum is larger than its maximum");
    RandomNumbers random(static_cast<std::uint64_t>(values.at("seed")));
    ArmScene scene;
    drawUntilOneWillDo(
        mostDraws,
        [&]()
        {
            scene = drawOnce(random, values);
            return clearance(scene, scene.start) > values.at("clearance") &&
                   clearance(scene, scene.goal) > values.at("clearance") &&
                   (values.at("blocked") == 0.0 || judgeMotion(scene, scene.start, scene.goal) == Motion::Blocked);
        });
    return scene;
}
}  // namespace

Family circlesFamily()
{
    using Kind = FamilyParameter::Kind;
    return {"circles",
            "links of equal length among random circles; whether there is a way is not known",
            {{"links", Kind::Whole, 3, 1, 100, "of the arm"},
             {"reach", Kind::Real, 3.0, 0.1, 100.0, "length of all links together"},
             {"min_circles", Kind::Whole, 2, 0, 100, "fewest circles"},
             {"max_circles", Kind::Whole, 6, 0, 100, "most circles"},
             {"min_radius", Kind::Real, 0.15, 0.001, 100.0, "of a circle"},
             {"max_radius", Kind::Real, 0.45, 0.001, 100.0, "of a circle"},
             {"disc", Kind::Real, 3.0, 0.1, 100.0, "radius of the disc around the base that the centres lie in"},
             {"clearance", Kind::Real, 0.03, 0.0, 10.0, "start and goal have more"},
             {"blocked", Kind::Flag, 1.0, 0.0, 1.0, "the straight line in joint space is blocked"},
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers"}},
            drawCircles};
}
}  // namespace narrows
