// SPDX-License-Identifier: BSD-3-Clause
// blind: a chain on a sliding base stands before a wall and shall stand behind it; the slide runs through gaps in
// walls. Neither end of the problem has a link in a gap, so that no search tree stands in the passage: it must be found
// and entered from outside, and followed until the whole chain and its base are through. The witness stretches the
// chain along the slide, carries it through and bends it again. Where `half_width` is negative the obstacles overlap:
// the base cannot pass them, and there is no way.
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

constexpr int mostDraws = 2000;
constexpr double leastClearance = 0.04;
constexpr double narrowest = 1e-8;
constexpr double between = 0.8;  ///< of neighbouring gaps

class Blind
{
public:
    explicit Blind(const FamilyValues &values)
      : links_(static_cast<int>(values.at("links"))),
        gaps_(static_cast<int>(values.at("gaps"))),
        halfWidth_(values.at("half_width")),
        shape_(gapShapeOf(values)),
        random_(static_cast<std::uint64_t>(values.at("seed")))
    {
    }

    ArmScene draw()
    {
        if (std::abs(halfWidth_) < narrowest)
            throw std::invalid_argument("half_width: must be 1e-8 or more from 0");
        drawUntilOneWillDo(mostDraws,
                           [this]()
                           {
                               drawChain();
                               drawWalls();
                               return drawEnds();
                           });
        return scene_;
    }

private:
    /// The gaps are at 0, `between`, ... along the slide; the chain has room on both sides.
    void drawChain()
    {
        scene_ = {};
        std::vector<double> rods(static_cast<std::size_t>(links_));
        reach_ = 0.0;
        for (double &rod : rods)
            reach_ += rod = rounded(random_.uniform(0.5, 0.9), 6);
        scene_.lengths = rods;
        direction_ = rounded(random_.uniform(-M_PI, M_PI), 6);
        along_ = {std::cos(direction_), std::sin(direction_)};
        along_ = rounded(along_, 15).normalized();
        // The base must not come nearer to a gap than the stretched chain is long, or that could not be bent there.
        const double room = reach_ + 0.6;
        const double behind = (gaps_ - 1) * between + 0.6;
        scene_.slide = Slide{along_, rounded(-room - 0.5, 6), rounded(behind + 0.5, 6)};
        before_ = -rounded(room, 6);
        behind_ = rounded(behind, 6);
    }

    /// Two obstacles at every gap, and plates behind them that no link reaches around.
    void drawWalls()
    {
        const Vector2d across(-along_.y(), along_.x());
        for (int i = 0; i < gaps_; ++i)
            for (const int side : {1, -1})
            {
                const double size = rounded(random_.uniform(0.2, 0.35), 6);
                const Vector2d outwards = side * across;
                const Vector2d throat = i * between * along_;
                addObstacle(scene_, placeAtGap(shape_, throat + halfWidth_ * outwards, outwards, size, random_));
                addObstacle(scene_, plate(throat + (halfWidth_ + 0.5 * size) * outwards, outwards, 2.5 * reach_));
            }
    }

    static Polygon plate(const Vector2d &from, const Vector2d &outwards, double length)
    {
        constexpr double halfThickness = 0.05;
        const Vector2d along(outwards.y(), -outwards.x());
        Polygon polygon;
        for (const auto &[x, y] :
             {std::pair{-halfThickness, 0.0}, {halfThickness, 0.0}, {halfThickness, 1.0}, {-halfThickness, 1.0}})
            polygon.vertices.push_back(rounded(Vector2d(from + x * along + y * length * outwards), 12));
        return polygon;
    }

    VectorXd bent(double slide)
    {
        VectorXd q(links_ + 1);
        q[0] = slide;
        for (Eigen::Index i = 1; i <= links_; ++i)
            q[i] = rounded(direction_ + random_.uniform(-1.2, 1.2), 6);
        return q;
    }

    VectorXd stretched(double slide) const
    {
        VectorXd q = VectorXd::Constant(links_ + 1, direction_);
        q[0] = slide;
        return q;
    }

    bool drawEnds()
    {
        constexpr int tries = 50;
        for (int i = 0; i < tries; ++i)
        {
            scene_.start = bent(before_);
            scene_.goal = bent(behind_);
            writeProof();
            if (clearance(scene_, scene_.start) > leastClearance && clearance(scene_, scene_.goal) > leastClearance &&
                judgeMotion(scene_, scene_.start, scene_.goal) == Motion::Blocked &&
                (scene_.infeasible || judgePath(scene_, scene_.witness) == Motion::Free))
                return true;
        }
        return false;
    }

    /// That there is a way; or that the base stays between the slide's lower limit and the first gap.
    void writeProof()
    {
        if (halfWidth_ > 0.0)
            scene_.witness = {scene_.start, stretched(before_), stretched(behind_), scene_.goal};
        else
            scene_.infeasible = Confinement{{scene_.slide->lower, 0.0}, {0.0, 0.0}};
    }

    int links_;
    int gaps_;
    double halfWidth_;
    GapShape shape_;
    RandomNumbers random_;
    double reach_ = 0.0;
    double direction_ = 0.0;  ///< of the slide
    Vector2d along_;
    double before_ = 0.0;  ///< the slide's value at the start,
    double behind_ = 0.0;  ///< and at the goal
    ArmScene scene_;
};
}  // namespace

Family blindFamily()
{
    using Kind = FamilyParameter::Kind;
    return {"blind",
            "a chain on a slide is carried through gaps; no link is in one at the start or at the goal",
            {{"links", Kind::Whole, 3, 1, 100, "of the chain, 0.5 to 0.9 long each"},
             {"half_width", Kind::Real, 0.01, -0.1, 0.2, "of every gap; below 0 they are closed, and there is no way"},
             {"gaps", Kind::Whole, 1, 1, 3, "0.8 apart"},
             gapShapeParameter(),
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers: lengths, obstacles, direction, both ends"}},
            [](const FamilyValues &values)
            {
                return Blind(values).draw();
            }};
}
}  // namespace narrows
