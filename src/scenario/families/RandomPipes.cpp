// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "scenario/families/Draws.h"
#include "scenario/families/Families.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

constexpr int mostDraws = 20000;
constexpr int tipCount = 3;
constexpr int decimals = 3;

/// In a disc around the origin, by rejection: no sine that another machine rounds otherwise.
Vector2d drawPoint(RandomNumbers &random, double discRadius)
{
    while (true)
    {
        const double x = random.uniform(-1.0, 1.0);
        const double y = random.uniform(-1.0, 1.0);
        if (x * x + y * y < 1.0)
            return {rounded(discRadius * x, decimals), rounded(discRadius * y, decimals)};
    }
}

/// Three to six corners on a circle, no two neighbours more than half a turn apart.
PipeScene::Section drawPrism(RandomNumbers &random)
{
    const Vector2d center = drawPoint(random, 1300.0);
    const double radius = random.uniform(110.0, 230.0);
    const int corners = random.whole(3, 6);
    const double turn = random.uniform(0.0, 1.0);
    std::vector<Vector2d> vertices;
    for (int i = 0; i < corners; ++i)
    {
        const double angle = 2.0 * M_PI * (i + turn + random.uniform(0.0, 0.5)) / corners;
        vertices.push_back({rounded(center.x() + radius * std::cos(angle), decimals),
                            rounded(center.y() + radius * std::sin(angle), decimals)});
    }
    return prismOver(vertices);
}

PipeScene drawOnce(RandomNumbers &random, int obstacles)
{
    PipeScene scene;
    for (int i = 0; i < obstacles; ++i)
        if (random.coin())
        {
            const double radius = rounded(random.uniform(80.0, 200.0), decimals);
            scene.sections.push_back(pipeAround(drawPoint(random, 1300.0), radius));
        }
        else
            scene.sections.push_back(drawPrism(random));
    for (int i = 0; i < tipCount; ++i)
        scene.tips.push_back(drawPoint(random, 1700.0));
    return scene;
}

/// \param margin how far from a section the region goes that the tip keeps out of
bool fits(const PipeScene &scene, double margin)
{
    constexpr double room = 20.0;  // that two such regions leave between them
    constexpr double beyond = 2.0;
    const std::vector<PipeScene::Section> &sections = scene.sections;
    for (std::size_t i = 0; i < sections.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
            if (distance(sections[i], sections[j]) < 2.0 * margin + room)
                return false;
        const auto isNear = [&](const Vector2d &tip)
        {
            return distance(sections[i], tip) < margin + beyond;
        };
        if (isNear(Vector2d::Zero()) || std::any_of(scene.tips.begin(), scene.tips.end(), isNear))
            return false;
    }
    return true;
}

PipeScene drawPipes(const FamilyValues &values)
{
    const double margin = std::max(values.at("margin"), PipeScene::armRadius);
    RandomNumbers random(static_cast<std::uint64_t>(values.at("seed")));
    PipeScene scene;
    drawUntilOneWillDo(mostDraws,
                       [&]()
                       {
                           scene = drawOnce(random, static_cast<int>(values.at("obstacles")));
                           return fits(scene, margin);
                       });
    return scene;
}
}  // namespace

Family pipesFamily()
{
    using Kind = FamilyParameter::Kind;
    return {"pipes",
            "the arm of the VDSM paper among endless pipes and prisms along its slide; its tip has three places to go",
            {{"obstacles", Kind::Whole, 2, 1, 10, "pipes (radius 80 to 200) and prisms (110 to 230), at random"},
             {"margin", Kind::Real, 100.0, 0.0, 500.0,
              "twice this and 20 more lie between obstacles, this and 2 more between them and the places of the tip; "
              "at least the arm's radius, 61.5"},
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers"}},
            drawPipes};
}
}  // namespace narrows
