// SPDX-License-Identifier: BSD-3-Clause
// slab and tube: an arm of two carriers and one or more rods. At the goal the rods lie on one line and each in a gap
// between two obstacles. The carriers can draw them back along that line, which is the witness; then the arm bends away
// to the start. One gap leaves the motions near the line all but one of their dimensions (a slab in joint space),
// several gaps take more of them (a tube).
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
constexpr int mostDraws = 2000;
constexpr double leastClearance = 0.04;  ///< of the carriers, the withdrawn arm and the start
constexpr double headroom = 0.05;        ///< between the withdrawn tip and the obstacles of the first gap

using Eigen::Vector2d;

class Threading
{
public:
    Threading(const FamilyValues &values, int gaps)
      : links_(static_cast<int>(values.at("links"))),
        gaps_(gaps),
        halfWidth_(values.at("half_width")),
        depth_(values.at("depth")),
        symmetric_(values.at("symmetric") != 0.0),
        shape_(gapShapeOf(values)),
        random_(static_cast<std::uint64_t>(values.at("seed")))
    {
        if (links_ < GapArm::carriers + gaps)
            throw std::invalid_argument("links: must be at least " + std::to_string(GapArm::carriers + gaps) +
                                        " to thread " + (gaps == 1 ? "a gap" : std::to_string(gaps) + " gaps"));
    }

    ArmScene draw()
    {
        constexpr int startsPerGoal = 20;
        drawUntilOneWillDo(mostDraws,
                           [this]()
                           {
                               drawLengths();
                               GapArm arm(rods_, links_);
                               return drawGoal(arm) && canWithdraw(arm) &&
                                      oneWillDo(startsPerGoal, [&]() { return drawStart(arm); });
                           });
        return scene_;
    }

private:
    /// The rods, the obstacles' radii, how far the rods must be drawn back to be out of the first gap, and carriers
    /// that can do so.
    void drawLengths()
    {
        rods_.assign(GapArm::carriers, 0.0);
        radii_.clear();
        wayBack_ = headroom;
        for (int i = 0; i < gaps_; ++i)
        {
            rods_.push_back(random_.uniform(0.7, 1.0));
            radii_.push_back(rounded(random_.uniform(0.2, 0.35), 6));
            radii_.push_back(rounded(random_.uniform(0.2, 0.35), 6));
            wayBack_ += i == 0 ? depth_ * rods_.back() + std::max(radii_[0], radii_[1]) : rods_.back();
        }
        if (symmetric_)
        {
            // Cut into whole millionths, or the links' rounding would make the carriers unequal.
            const int rodCount = GapArm::carriers + gaps_;
            const double unit = 1e-6 * GapArm::share(0, rodCount, links_) * GapArm::share(1, rodCount, links_);
            end_ = wayBack_ + random_.uniform(0.2, 0.5);
            rods_[0] = rods_[1] = unit * std::round((end_ + random_.uniform(0.15, 0.4)) / 2.0 / unit);
        }
        else
        {
            end_ = wayBack_ / 2.0 + random_.uniform(-0.2, 0.2);
            rods_[0] = random_.uniform(0.9, 1.2);
            rods_[1] = random_.uniform(0.9, 1.2);
        }
    }

    /// Everything but the start. In a frame along the rods the line they slide on passes the base at a distance, and
    /// the carriers' end goes about as far on one side of it as on the other; or it passes through the base.
    bool drawGoal(GapArm &arm)
    {
        const double direction = random_.uniform(-M_PI, M_PI);
        const int side = random_.coin() ? 1 : -1;
        const double aside = symmetric_ ? 0.0 : random_.uniform(0.5, 0.9);
        const double distance = symmetric_ || random_.coin() ? aside : -aside;
        if (!arm.place(direction, {end_, distance}, side))
            return false;
        scene_.lengths = arm.lengths();
        scene_.goal = arm.placed();
        placeObstacles(arm);
        return true;
    }

    void placeObstacles(const GapArm &arm)
    {
        const Vector2d along = arm.along();
        const Vector2d across(-along.y(), along.x());
        scene_.obstacles.clear();
        double begin = 0.0;
        for (int i = GapArm::carriers; i < arm.rodCount(); ++i)
        {
            const double throat = begin + (1.0 - depth_) * arm.rod(i);
            begin += arm.rod(i);
            for (const int side : {1, -1})
            {
                const double radius = radii_[scene_.obstacles.size()];
                const Vector2d outwards = side * across;
                const Vector2d touch = arm.begin() + throat * along + halfWidth_ * outwards;
                addObstacle(scene_, placeAtGap(shape_, touch, outwards, radius, random_));
            }
        }
    }

    /// Can the carriers draw the rods back without coming near the obstacles themselves?
    bool canWithdraw(const GapArm &arm) const
    {
        constexpr int looks = 100;
        ArmScene carriers = scene_;
        carriers.lengths.resize(static_cast<std::size_t>(arm.carrierLinks()));
        for (int i = 0; i <= looks; ++i)
        {
            const Eigen::VectorXd q = arm.drawnBack(wayBack_ * i / looks);
            if (!q.allFinite() ||
                clearance(carriers, q.head(arm.carrierLinks())) <= std::max(leastClearance, halfWidth_))
                return false;
        }
        return clearance(scene_, arm.drawnBack(wayBack_)) > leastClearance;
    }

    bool drawStart(const GapArm &arm)
    {
        if (!drawBentStart(scene_, arm.drawnBack(wayBack_), 1.0, leastClearance, random_))
            return false;
        writeWitness(arm);
        return true;
    }

    /// Between two waypoints a distance s apart the rods leave their line by about s^2 / 8 over the carriers' length.
    void writeWitness(const GapArm &arm)
    {
        const int steps = static_cast<int>(std::ceil(wayBack_ / (0.5 * std::sqrt(halfWidth_))));
        scene_.witness = {scene_.start};
        for (int i = steps; i > 0; --i)
            scene_.witness.push_back(arm.drawnBack(wayBack_ * i / steps));
        scene_.witness.push_back(scene_.goal);
    }

    int links_;
    int gaps_;
    double halfWidth_;
    double depth_;
    bool symmetric_;
    GapShape shape_;
    RandomNumbers random_;
    std::vector<double> rods_;   ///< lengths of the carriers, then of the rods
    std::vector<double> radii_;  ///< of the obstacles
    double wayBack_ = 0.0;       ///< from the goal until the rods are out of the first gap
    double end_ = 0.0;           ///< of the carriers at the goal, along the rods' line
    ArmScene scene_;
};

std::vector<FamilyParameter> parameters(int links)
{
    using Kind = FamilyParameter::Kind;
    return {
        {"links", Kind::Whole, links, 3, 100, "of the arm: two carriers and one rod per gap, cut into so many in all"},
        {"half_width", Kind::Real, 0.01, 1e-8, 0.2, "of every gap, the goal's clearance"},
        {"depth", Kind::Real, 0.5, 0.05, 0.9, "how far every rod is through its gap, in its own lengths"},
        {"symmetric", Kind::Flag, 0.0, 0.0, 1.0,
         "equal carriers, and the rods' line passes through the base: drawing back is straight in joint space"},
        gapShapeParameter(),
        {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers: lengths, obstacles, directions, start"}};
}
}  // namespace

Family slabFamily()
{
    return {"slab", "links thread a gap between two obstacles", parameters(3),
            [](const FamilyValues &values)
            {
                return Threading(values, 1).draw();
            }};
}

Family tubeFamily()
{
    std::vector<FamilyParameter> all = parameters(4);
    all.push_back({"gaps", FamilyParameter::Kind::Whole, 2, 2, 3, "to be threaded, one behind the other"});
    return {"tube", "links thread several gaps in a row at once", all,
            [](const FamilyValues &values)
            {
                return Threading(values, static_cast<int>(values.at("gaps"))).draw();
            }};
}
}  // namespace narrows
