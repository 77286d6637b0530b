// SPDX-License-Identifier: BSD-3-Clause
// slot: an arm of six joints, its links those of a UR5 with a longer tool, whose tool is in an opening at the goal: a
// slot, a square hole, or the hole that a box is open at. The arm can draw the tool back along its own line, which is
// the witness; then it bends away to the start.
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "scenario/families/BentStart.h"
#include "scenario/families/Draws.h"
#include "scenario/families/Families.h"
#include "scenario/families/RandomNumbers.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int mostDraws = 4000;
constexpr double toolLength = 0.25;
constexpr double toolRadius = 0.02;
constexpr double halfThickness = 0.01;  ///< of the walls
constexpr double depth = 0.12;          ///< how far the tool is through
constexpr double headroom = 0.05;
constexpr double roundOff = 1e-9;  ///< of files, as it shows in a clearance
constexpr double leastClearance = 0.02;

enum class Opening
{
    Slot,
    Hole,
    Box
};

SpaceScene::Table armTable()
{
    constexpr double quarter = M_PI / 2.0;
    const std::optional<Interval> turn = Interval{-2.0 * M_PI, 2.0 * M_PI};
    return {{0.0, 0.089159, 0.0, quarter, turn, 0.06}, {0.0, 0.0, -0.425, 0.0, turn, 0.05},
            {0.0, 0.0, -0.39225, 0.0, turn, 0.04},     {0.0, 0.10915, 0.0, quarter, turn, 0.04},
            {0.0, 0.09465, 0.0, -quarter, turn, 0.04}, {0.0, toolLength, 0.0, 0.0, turn, toolRadius}};
}

class Slot
{
public:
    explicit Slot(const FamilyValues &values)
      : opening_(static_cast<Opening>(values.at("opening"))),
        halfWidth_(values.at("half_width")),
        random_(static_cast<std::uint64_t>(values.at("seed")))
    {
        scene_.robot = armTable();
        scene_.radius = 0.04;
    }

    SpaceScene draw()
    {
        constexpr int startsPerGoal = 20;
        drawUntilOneWillDo(mostDraws,
                           [this]()
                           {
                               placeOpening();
                               return drawGoal() && withdraw() &&
                                      oneWillDo(startsPerGoal, [this]() { return drawStart(); });
                           });
        return scene_;
    }

private:
    void placeOpening()
    {
        constexpr double halfSquare = 1.5;
        throat_ = {rounded(random_.uniform(0.35, 0.6), 6), rounded(random_.uniform(-0.3, 0.3), 6),
                   rounded(random_.uniform(0.0, 0.5), 6)};
        const double half = rounded(toolRadius + halfWidth_, 12);
        scene_.walls.clear();
        addOpening(scene_, throat_, {opening_ == Opening::Slot ? halfSquare : half, half}, halfThickness, halfSquare);
        if (opening_ != Opening::Box)
            return;
        // Behind the hole: four sides and the back.
        constexpr double room = 0.2;
        const Vector3d middle = throat_ + Vector3d(halfThickness + room, 0.0, 0.0);
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0})
            {
                if (axis == 0 && side < 0.0)
                    continue;
                Vector3d halfExtents = Vector3d::Constant(room + 2.0 * halfThickness);
                halfExtents[axis] = halfThickness;
                const Vector3d place = middle + side * (room + halfThickness) * Vector3d::Unit(axis);
                scene_.walls.push_back({place - halfExtents, place + halfExtents});
            }
    }

    /// How far the tool is from lying along x with its end at a point: three coordinates, two of its direction.
    static VectorXd offset(const SpatialArm &arm, const VectorXd &q, const Vector3d &end)
    {
        SpatialArm::Placement placement;
        arm.place(q, placement);
        const Vector3d tip = placement.points.back();
        const Vector3d tool = (tip - placement.points[placement.points.size() - 2]) / toolLength;
        VectorXd result(5);
        result << tip - end, tool.y(), tool.z();
        return result;
    }

    /// Newton's method with least changes from q on, difference quotients for derivatives. Nothing if it does not get
    /// there, or with the tool the wrong way round.
    static std::optional<VectorXd> reachFrom(const SpatialArm &arm, VectorXd q, const Vector3d &end)
    {
        constexpr double h = 1e-6;
        constexpr double longest = 0.3;
        for (int i = 0; i < 60; ++i)
        {
            const VectorXd error = offset(arm, q, end);
            if (error.norm() < 1e-13)
                break;
            Eigen::MatrixXd slope(5, q.size());
            for (Eigen::Index j = 0; j < q.size(); ++j)
            {
                const VectorXd step = h * VectorXd::Unit(q.size(), j);
                slope.col(j) = (offset(arm, q + step, end) - offset(arm, q - step, end)) / (2.0 * h);
            }
            VectorXd change = -slope.transpose() * (slope * slope.transpose()).fullPivLu().solve(error);
            if (!change.allFinite())
                return std::nullopt;
            q += change * std::min(1.0, longest / change.norm());
        }
        SpatialArm::Placement placement;
        arm.place(q, placement);
        const bool forwards = placement.points.back().x() > placement.points[placement.points.size() - 2].x();
        if (!forwards || offset(arm, q, end).norm() > 1e-11)
            return std::nullopt;
        return q;
    }

    bool drawGoal()
    {
        VectorXd guess(6);
        guess << random_.uniform(-1.5, 1.5), random_.uniform(-M_PI, 0.0), random_.uniform(-2.5, 2.5),
            random_.uniform(-M_PI, M_PI), random_.uniform(-M_PI, M_PI), random_.uniform(-M_PI, M_PI);
        const SpatialArm arm = modelOf(scene_).arm;
        const std::optional<VectorXd> goal = reachFrom(arm, guess, throat_ + depth * Vector3d::UnitX());
        if (!goal || goal->lpNorm<Eigen::Infinity>() > M_PI)
            return false;
        scene_.goal = *goal;
        for (double &value : scene_.goal)
            value = rounded(value, 11);
        return clearance(scene_, scene_.goal) > halfWidth_ - roundOff;
    }

    /// The way back, from the goal on.
    bool withdraw()
    {
        const double wayBack = depth + halfThickness + toolRadius + headroom;
        const int steps = static_cast<int>(std::ceil(wayBack / (0.15 * std::sqrt(halfWidth_))));
        const SpatialArm arm = modelOf(scene_).arm;
        back_ = {scene_.goal};
        for (int i = 1; i <= steps; ++i)
        {
            const double way = depth - wayBack * i / steps;
            const std::optional<VectorXd> q = reachFrom(arm, back_.back(), throat_ + way * Vector3d::UnitX());
            if (!q || (*q - back_.back()).norm() > 10.0 * wayBack / steps)
                return false;
            back_.push_back(q->unaryExpr([](double value) { return rounded(value, 12); }));
        }
        return clearance(scene_, back_.back()) > leastClearance && judgePath(scene_, back_) == Motion::Free;
    }

    bool drawStart()
    {
        if (!drawBentStart(scene_, back_.back(), 1.0, leastClearance, random_))
            return false;
        scene_.witness = {scene_.start};
        scene_.witness.insert(scene_.witness.end(), back_.rbegin(), back_.rend());
        return true;
    }

    Opening opening_;
    double halfWidth_;
    RandomNumbers random_;
    Vector3d throat_;
    std::vector<VectorXd> back_;  ///< waypoints from the goal to where the tool is out
    SpaceScene scene_;
};
}  // namespace

Family slotFamily()
{
    using Kind = FamilyParameter::Kind;
    return {
        "slot",
        "an arm of six joints puts its tool into an opening",
        {{"opening",
          Kind::Name,
          0,
          0,
          0,
          "a slot, a square hole, or the hole that a box is open at",
          {"slot", "hole", "box"}},
         {"half_width", Kind::Real, 0.01, 1e-6, 0.1, "between the tool and the opening's edges, the goal's clearance"},
         {"seed", Kind::Whole, 1, 0, 1e9, "of the random numbers: places, goal, start"}},
        [](const FamilyValues &values)
        {
            return Slot(values).draw();
        }};
}
}  // namespace narrows
