// SPDX-License-Identifier: BSD-3-Clause
// bent_tube: two carriers, a front rod through one gap and a last rod through a second gap that is tilted against the
// first. No motion keeps the whole arm on one line here: the last rod's end is drawn out of its gap along its own line
// while the rod's beginning turns between the two lines, then the last rod follows the first one through its gap. That
// takes a joint within the last rod, and decides the arm's proportions; scenes are drawn until the verifier accepts the
// motion, which is the witness.
#include <cmath>
#include <stdexcept>

#include "scenario/families/BentStart.h"
#include "scenario/families/Draws.h"
#include "scenario/families/Families.h"
#include "scenario/families/GapArm.h"
#include "scenario/families/GapShape.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr int mostDraws = 4000;
constexpr int frontRod = GapArm::carriers;
constexpr int lastRod = frontRod + 1;
constexpr int rodCount = lastRod + 1;
constexpr double leastClearance = 0.04;  ///< of the withdrawn arm and the start
constexpr double roundOff = 1e-10;       ///< of files, as it shows in a clearance
constexpr double headroom = 0.05;        ///< between the withdrawn tip and the obstacles of the first gap

class BentTube
{
public:
    explicit BentTube(const FamilyValues &values)
      : links_(static_cast<int>(values.at("links"))),
        lastLinks_(GapArm::share(lastRod, rodCount, links_)),
        turningLinks_(static_cast<int>(std::floor((1.0 - values.at("depth")) * lastLinks_ + 1e-9))),
        halfWidth_(values.at("half_width")),
        depth_(values.at("depth")),
        bend_(values.at("bend")),
        shape_(gapShapeOf(values)),
        random_(static_cast<std::uint64_t>(values.at("seed")))
    {
        if (turningLinks_ < 1)
            throw std::invalid_argument(
                "depth: must leave a link of the last rod between the gaps, so that it can turn");
    }

    ArmScene draw()
    {
        constexpr int startsPerGoal = 20;
        drawUntilOneWillDo(mostDraws,
                           [this]()
                           {
                               GapArm arm(drawLengths(), links_);
                               return drawGoal(arm) && canWithdraw(arm) &&
                                      oneWillDo(startsPerGoal, [&]() { return drawStart(arm); });
                           });
        return scene_;
    }

private:
    std::vector<double> drawLengths()
    {
        const double front = random_.uniform(0.85, 1.15);
        const double last = random_.uniform(0.65, 0.85);
        for (double &size : sizes_)
            size = rounded(random_.uniform(0.2, 0.35), 6);
        wayBack_ = depth_ * front + last + std::max(sizes_[0], sizes_[1]) + headroom;
        return {random_.uniform(1.0, 1.3), random_.uniform(1.0, 1.3), front, last};
    }

    /// Everything but the start: see Threading.cpp; then the last rod turns to its line.
    bool drawGoal(GapArm &arm)
    {
        const double direction = random_.uniform(-M_PI, M_PI);
        const int side = random_.coin() ? 1 : -1;
        const double aside = random_.uniform(0.5, 0.9);
        const double distance = random_.coin() ? aside : -aside;
        if (!arm.place(direction, {wayBack_ / 2.0 + random_.uniform(-0.2, 0.2), distance}, side))
            return false;
        turning_ = arm.rod(lastRod) * turningLinks_ / lastLinks_;
        if (turning_ > depth_ * arm.rod(frontRod))
            return false;  // it would be in the first gap before it lies on its line
        tilt_ = rounded(bend_ * (random_.coin() ? 1.0 : -1.0), 6);
        scene_.lengths = arm.lengths();
        scene_.goal = arm.placed();
        lineAngle_ = scene_.goal[links_ - 1];
        scene_.goal.tail(lastLinks_).array() += tilt_;
        for (double &angle : scene_.goal)
            angle = rounded(angle, 6);
        scene_.obstacles.clear();
        placeGap(arm.begin(), lineAngle_, arm.rod(frontRod), 0);
        placeGap(arm.begin() + arm.rod(frontRod) * arm.along(), scene_.goal[links_ - 1], arm.rod(lastRod), 2);
        return clearance(scene_, scene_.goal) > halfWidth_ - roundOff;
    }

    /// A gap across a rod that begins at `base`. \param first index of the sizes of its obstacles
    void placeGap(const Vector2d &base, double angle, double rod, int first)
    {
        const Vector2d along(std::cos(angle), std::sin(angle));
        for (const int side : {1, -1})
        {
            const Vector2d outwards(-side * along.y(), side * along.x());
            const Vector2d touch = base + (1.0 - depth_) * rod * along + halfWidth_ * outwards;
            addObstacle(scene_, placeAtGap(shape_, touch, outwards, sizes_[first + (side < 0 ? 1 : 0)], random_));
        }
    }

    /// The arm when the front rod has been drawn back by `way`. While that is less than the turning part of the last
    /// rod, that part leads from one line to the other, and its end is `ahead` of the corner on the second line:
    /// |way u1 + ahead u2| = turning. Then all of the last rod's base follows the first line, and its end turns to it.
    VectorXd drawnBack(const GapArm &arm, double way) const
    {
        VectorXd q = arm.drawnBack(way);
        if (way < turning_)
        {
            const double across = way * std::sin(tilt_);
            const double ahead = std::sqrt(turning_ * turning_ - across * across) - way * std::cos(tilt_);
            const double turn = std::atan2(ahead * std::sin(tilt_), way + ahead * std::cos(tilt_));
            q.tail(lastLinks_).setConstant(lineAngle_ + turn);
        }
        const double room = depth_ * arm.rod(frontRod);  // until the turning part's end is in the first gap
        const double progress = (way - turning_ - 0.3 * room) / (0.7 * room);
        q.tail(lastLinks_ - turningLinks_)
            .setConstant(lineAngle_ + tilt_ * std::min(1.0, std::max(0.0, 1.0 - progress)));
        return q;
    }

    bool canWithdraw(const GapArm &arm) const
    {
        constexpr int looks = 60;
        for (int i = 1; i <= looks; ++i)
        {
            const VectorXd q = drawnBack(arm, wayBack_ * i / looks);
            if (!q.allFinite() || clearance(scene_, q) <= 0.5 * halfWidth_)
                return false;
        }
        return clearance(scene_, drawnBack(arm, wayBack_)) > leastClearance;
    }

    bool drawStart(const GapArm &arm)
    {
        if (!drawBentStart(scene_, drawnBack(arm, wayBack_), 1.0, leastClearance, random_))
            return false;
        writeWitness(arm);
        return judgePath(scene_, scene_.witness) == Motion::Free;
    }

    /// Between two waypoints a distance s apart the rods leave their lines by about s^2 / 8 over the length of what
    /// turns.
    void writeWitness(const GapArm &arm)
    {
        const int steps = static_cast<int>(std::ceil(wayBack_ / (0.3 * std::sqrt(halfWidth_))));
        scene_.witness = {scene_.start};
        for (int i = steps; i > 0; --i)
            scene_.witness.push_back(drawnBack(arm, wayBack_ * i / steps));
        scene_.witness.push_back(scene_.goal);
    }

    int links_;
    int lastLinks_;     ///< of the last rod
    int turningLinks_;  ///< those of them that turn from line to line
    double halfWidth_;
    double depth_;
    double bend_;
    GapShape shape_;
    RandomNumbers random_;
    double sizes_[4] = {};    ///< of the obstacles
    double wayBack_ = 0.0;    ///< from the goal until all is out of the first gap
    double turning_ = 0.0;    ///< length of the turning links
    double tilt_ = 0.0;       ///< of the second line against the first
    double lineAngle_ = 0.0;  ///< of the first line
    ArmScene scene_;
};
}  // namespace

Family bentTubeFamily()
{
    using Kind = FamilyParameter::Kind;
    return {"bent_tube",
            "links thread two gaps in a row, the second one tilted",
            {{"links", Kind::Whole, 8, 5, 100, "of the arm: two carriers and two rods, cut into so many in all"},
             {"half_width", Kind::Real, 0.01, 1e-8, 0.2, "of both gaps, the goal's clearance"},
             {"bend", Kind::Real, 0.3, 0.0, 0.8, "in radians: of the second gap against the first"},
             {"depth", Kind::Real, 0.4, 0.05, 0.9, "how far both rods are through their gaps, in their own lengths"},
             gapShapeParameter(),
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers: lengths, obstacles, directions, start"}},
            [](const FamilyValues &values)
            {
                return BentTube(values).draw();
            }};
}
}  // namespace narrows
