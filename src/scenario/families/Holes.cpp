// SPDX-License-Identifier: BSD-3-Clause
// holes: a chain of eight links on universal joints. At the goal its last four lie on one line along x through square
// holes of walls; the first four, two carriers of two links each, can draw them back along it, which is the witness.
// Then the chain bends away to the start. See Threading.cpp for the same in the plane.
#include <cmath>

#include "scenario/families/BentStart.h"
#include "scenario/families/Draws.h"
#include "scenario/families/Families.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
namespace
{
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int mostDraws = 2000;
constexpr int links = 8;
constexpr int linksPerRod = 2;
constexpr double leastClearance = 0.03;
constexpr double headroom = 0.05;
constexpr double roundOff = 1e-9;       ///< of files, as it shows in a clearance
constexpr double halfThickness = 0.03;  ///< of the walls
constexpr double depth = 0.5;           ///< how far every rod is through its hole, in its own lengths

/// Joint values that let the links of a chain point in given directions. Not finite near the universal joint's
/// singularity, a yaw of a right angle.
VectorXd jointValues(const std::vector<Vector3d> &directions)
{
    constexpr double mostYaw = 1.3;
    VectorXd q(2 * static_cast<Eigen::Index>(directions.size()));
    Matrix3d frame = Matrix3d::Identity();
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
        const Vector3d local = frame.transpose() * directions[i];
        const double yaw = std::asin(std::min(1.0, std::max(-1.0, local.y())));
        const double pitch = std::atan2(-local.z(), local.x());
        if (std::abs(yaw) > mostYaw)
            return VectorXd::Constant(q.size(), std::nan(""));
        q.segment<2>(2 * static_cast<Eigen::Index>(i)) << pitch, yaw;
        frame = frame * AngleAxisd(pitch, Vector3d::UnitY()) * AngleAxisd(yaw, Vector3d::UnitZ());
    }
    return q;
}

class Holes
{
public:
    explicit Holes(const FamilyValues &values)
      : gaps_(static_cast<int>(values.at("holes"))),
        halfWidth_(values.at("half_width")),
        random_(static_cast<std::uint64_t>(values.at("seed")))
    {
        scene_.radius = values.at("radius");
    }

    SpaceScene draw()
    {
        constexpr int startsPerGoal = 20;
        drawUntilOneWillDo(
            mostDraws, [this]()
            { return drawGoal() && canWithdraw() && oneWillDo(startsPerGoal, [this]() { return drawStart(); }); });
        return scene_;
    }

private:
    /// Two carriers and two rods, the rods' line along x past the base, and a hole in the middle of every rod that has
    /// one.
    bool drawGoal()
    {
        SpaceScene::Chain lengths;
        for (const auto &[least, most] : {std::pair{1.0, 1.3}, {1.0, 1.3}, {0.7, 0.9}, {0.7, 0.9}})
            lengths.insert(lengths.end(), linksPerRod, rounded(random_.uniform(least, most) / linksPerRod, 6));
        const auto rod = [&](std::size_t i)
        {
            return linksPerRod * lengths[linksPerRod * i];
        };
        carriers_[0] = rod(0);
        carriers_[1] = rod(1);
        wayBack_ = depth * rod(2) + halfThickness + scene_.radius + rod(3) + headroom;
        begin_ = {rounded(wayBack_ / 2.0 + random_.uniform(-0.2, 0.2), 6), drawOffset(), drawOffset()};
        for (const int axis : {2, 1, 0})  // as the scenes that are stored were drawn
            elbow_[axis] = random_.uniform(-1.0, 1.0);
        const double half = rounded(scene_.radius + halfWidth_, 12);
        scene_.robot = lengths;
        scene_.walls.clear();
        Vector3d middle = begin_;
        for (std::size_t i = 2; i < 2 + static_cast<std::size_t>(gaps_); ++i)
        {
            middle.x() = rounded(begin_.x() + (i == 3 ? rod(2) : 0.0) + (1.0 - depth) * rod(i), 6);
            addOpening(scene_, middle, {half, half}, halfThickness, 4.0);
        }
        scene_.goal = drawnBack(0.0);
        return scene_.goal.allFinite() && clearance(scene_, scene_.goal) > halfWidth_ - roundOff;
    }

    double drawOffset() { return rounded(random_.uniform(0.3, 0.6) * (random_.coin() ? 1.0 : -1.0), 6); }

    /// Not finite where the carriers do not reach or the joints are near a singularity.
    VectorXd drawnBack(double way) const
    {
        const Vector3d end = begin_ - way * Vector3d::UnitX();
        const double distance = end.norm();
        const double along =
            (distance * distance + carriers_[0] * carriers_[0] - carriers_[1] * carriers_[1]) / (2.0 * distance);
        const Vector3d towards = end / distance;
        const Vector3d aside = (elbow_ - elbow_.dot(towards) * towards).normalized();
        const Vector3d elbow = along * towards + std::sqrt(carriers_[0] * carriers_[0] - along * along) * aside;
        std::vector<Vector3d> directions(links, Vector3d::UnitX());
        for (int i = 0; i < linksPerRod; ++i)
        {
            directions[static_cast<std::size_t>(i)] = elbow.normalized();
            directions[static_cast<std::size_t>(linksPerRod + i)] = (end - elbow).normalized();
        }
        VectorXd q = jointValues(directions);
        for (double &value : q)
            value = rounded(value, 12);
        return q;
    }

    bool canWithdraw() const
    {
        constexpr int looks = 40;
        for (int i = 0; i <= looks; ++i)
        {
            const VectorXd q = drawnBack(wayBack_ * i / looks);
            if (!q.allFinite() || clearance(scene_, q) <= 0.5 * halfWidth_)
                return false;
        }
        return clearance(scene_, drawnBack(wayBack_)) > leastClearance;
    }

    bool drawStart()
    {
        if (!drawBentStart(scene_, drawnBack(wayBack_), 0.5, leastClearance, random_))
            return false;
        writeWitness();
        return judgePath(scene_, scene_.witness) == Motion::Free;
    }

    void writeWitness()
    {
        const int steps = static_cast<int>(std::ceil(wayBack_ / (0.3 * std::sqrt(halfWidth_))));
        scene_.witness = {scene_.start};
        for (int i = steps; i >= 0; --i)
            scene_.witness.push_back(drawnBack(wayBack_ * i / steps));
    }

    int gaps_;
    double halfWidth_;
    RandomNumbers random_;
    double carriers_[2] = {};
    double wayBack_ = 0.0;
    Vector3d begin_;  ///< of the rods at the goal
    Vector3d elbow_;  ///< to which side the carriers bend
    SpaceScene scene_;
};
}  // namespace

Family holesFamily()
{
    using Kind = FamilyParameter::Kind;
    return {"holes",
            "a chain of sixteen joints in space threads square holes of walls",
            {{"holes", Kind::Whole, 2, 1, 2, "one behind the other, on a line along x"},
             {"half_width", Kind::Real, 0.01, 1e-6, 0.2, "between the links and a hole's edges, the goal's clearance"},
             {"radius", Kind::Real, 0.02, 0.0, 0.1, "of the links"},
             {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers: lengths, places, start"}},
            [](const FamilyValues &values)
            {
                return Holes(values).draw();
            }};
}
}  // namespace narrows
