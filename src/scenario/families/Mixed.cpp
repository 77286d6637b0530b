// SPDX-License-Identifier: BSD-3-Clause
// mixed: links of equal length among obstacles of all kinds. With `witness` start, goal and two postures between them
// are drawn first and obstacles that the way past these would touch are drawn again: every scene then has a way.
// Without, as `circles` does it, nothing is known, and nothing favours scenes that are easy to find a way in.
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
        witness_(values.at("witness") != 0.0),
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
                               return drawObstacles() &&
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

    bool drawObstacles()
    {
        constexpr int triesPerObstacle = 30;
        const int count = random_.whole(fewest_, most_);
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
            const Vector2d place(random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0));
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
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers"}},
            [](const FamilyValues &values)
            {
                return Mixed(values).draw();
            }};
}
}  // namespace narrows
