// SPDX-License-Identifier: BSD-3-Clause
// mixed: links of equal length among obstacles of all kinds. With `witness` start, goal and two postures between them
// are drawn first and obstacles that the way past these would touch are drawn again: every scene then has a way.
// Without, as `circles` does it, nothing is known, and nothing favours scenes that are easy to find a way in. With
// `sealed` two walls come first that the first link cannot pass, one on either way round from start to goal: no way.
#include <cmath>
#include <stdexcept>

#include "scenario/families/Draws.h"
#include "scenario/families/Families.h"
#include "scenario/families/GapShape.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr int mostDraws = 20000;
constexpr int decimals = 6;
constexpr double reach = 3.0;

class Mixed
{
public:
    explicit Mixed(const FamilyValues &values)
      : links_(static_cast<int>(values.at("links"))),
        clearance_(values.at("clearance")),
        sealed_(values.count("sealed") != 0 && values.at("sealed") != 0.0),
        witness_(values.at("witness") != 0.0 && !sealed_),
        fewest_(static_cast<int>(values.at("min_obstacles"))),
        most_(static_cast<int>(values.at("max_obstacles"))),
        random_(static_cast<std::uint64_t>(values.at("seed")))
    {
        if (fewest_ > most_)
            throw std::invalid_argument("min_obstacles: is larger than max_obstacles");
    }

    ArmScene draw()
    {
        drawUntilOneWillDo(mostDraws,
                           [this]()
                           {
                               scene_ = {};
                               scene_.lengths = cut({reach}, links_);
                               drawWay();
                               return (!sealed_ || drawSeal()) && drawObstacles() &&
                                      judgeMotion(scene_, scene_.start, scene_.goal) == Motion::Blocked;
                           });
        return scene_;
    }

private:
    /// A posture whose angles do not differ from another one's by more than half a turn.
    VectorXd drawPosture(const VectorXd &near)
    {
        VectorXd q(links_);
        for (Eigen::Index i = 0; i < links_; ++i)
            q[i] = rounded(near[i] + random_.uniform(-M_PI, M_PI), decimals);
        return q;
    }

    void drawWay()
    {
        scene_.start = drawPosture(VectorXd::Zero(links_));
        scene_.goal = drawPosture(scene_.start);
        if (!witness_)
            return;
        constexpr int bends = 2;
        scene_.witness = {scene_.start};
        for (int i = 1; i <= bends; ++i)
        {
            VectorXd q = scene_.start + i / (bends + 1.0) * (scene_.goal - scene_.start);
            for (double &angle : q)
                angle = rounded(angle + random_.uniform(-1.0, 1.0), decimals);
            scene_.witness.push_back(q);
        }
        scene_.witness.push_back(scene_.goal);
    }

    /// One wall in each of the two sectors between the first link's directions at the start and at the goal.
    bool drawSeal()
    {
        const double way = std::remainder(scene_.goal[0] - scene_.start[0], 2.0 * M_PI);
        const double otherWay = way - std::copysign(2.0 * M_PI, way);
        Confinement proof{};
        for (const double sector : {way, otherWay})
        {
            const double direction = rounded(scene_.start[0] + random_.uniform(0.3, 0.7) * sector, decimals);
            (sector > 0.0 ? proof.first.upper : proof.first.lower) = direction;
            proof.along[sector > 0.0 ? 1 : 0] = drawWall(direction);
            if (!fits())
                return false;
        }
        scene_.infeasible = proof;
        return true;
    }

    /// A plate along a ray from the base, from some way out on the first link. \return a place on the link that it
    /// covers
    double drawWall(double direction)
    {
        const double link = scene_.lengths.front();
        const double begin = random_.uniform(0.4, 0.7) * link;
        const double end = link + random_.uniform(0.1, 1.0);
        const double halfThickness = std::min(0.05, 0.1 * link);
        const Vector2d outwards(std::cos(direction), std::sin(direction));
        const Vector2d across(-outwards.y(), outwards.x());
        Polygon wall;
        for (const auto &[out, side] : {std::pair{begin, -1.0}, {end, -1.0}, {end, 1.0}, {begin, 1.0}})
            wall.vertices.push_back(rounded(Vector2d(out * outwards + side * halfThickness * across), 12));
        addObstacle(scene_, wall);
        return rounded(0.5 * (begin + link), decimals);
    }

    bool drawObstacles()
    {
        constexpr int triesPerObstacle = 30;
        const int count = static_cast<int>(scene_.obstacles.size()) + random_.whole(fewest_, most_);
        for (int tries = 0; static_cast<int>(scene_.obstacles.size()) < count; ++tries)
        {
            if (tries == triesPerObstacle * count)
                return false;
            drawObstacle();
            if (!fits())
                scene_.obstacles.pop_back();
        }
        return true;
    }

    /// Around a place that is uniform in a disc of the arm's reach, and turned at random.
    void drawObstacle()
    {
        const double size = rounded(random_.uniform(0.12, 0.45), decimals);
        const auto shape = static_cast<GapShape>(random_.whole(0, 3));
        const double direction = random_.uniform(-M_PI, M_PI);
        const Vector2d outwards(std::cos(direction), std::sin(direction));
        addObstacle(scene_, placeAtGap(shape, drawPlace() - size * outwards, outwards, size, random_));
    }

    Vector2d drawPlace()
    {
        while (true)
        {
            Vector2d place;
            for (const int axis : {1, 0})  // as the scenes that are stored were drawn
                place[axis] = random_.uniform(-1.0, 1.0);
            if (place.squaredNorm() < 1.0)
                return reach * place;
        }
    }

    /// Does the latest obstacle leave room for the ends, and for the way if there is one?
    bool fits() const
    {
        ArmScene alone = scene_;
        alone.obstacles = {scene_.obstacles.back()};
        return clearance(alone, scene_.start) > clearance_ && clearance(alone, scene_.goal) > clearance_ &&
               (!witness_ || judgePath(alone, scene_.witness) == Motion::Free);
    }

    int links_;
    double clearance_;
    bool sealed_;
    bool witness_;
    int fewest_;
    int most_;
    RandomNumbers random_;
    ArmScene scene_;
};
}  // namespace

Family mixedFamily()
{
    using Kind = FamilyParameter::Kind;
    return {"mixed",
            "links of equal length among random circles, plates, superellipses and polygons",
            {{"links", Kind::Whole, 6, 1, 100, "of the arm, which is 3 long"},
             {"min_obstacles", Kind::Whole, 3, 1, 50, "fewest obstacles"},
             {"max_obstacles", Kind::Whole, 8, 1, 50, "most obstacles"},
             {"clearance", Kind::Real, 0.03, 0.0, 1.0, "start and goal have more"},
             {"witness", Kind::Flag, 1.0, 0.0, 1.0,
              "obstacles leave a way free that was drawn before them; if not, there may be none"},
             {"sealed", Kind::Flag, std::nullopt, 0.0, 1.0, "walls stop the first link, so that there is no way"},
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers"}},
            [](const FamilyValues &values)
            {
                return Mixed(values).draw();
            }};
}
}  // namespace narrows
