// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/chain/ChordObstacles.h"

namespace narrows
{
/// A disc on the ground that goes straight from place to place, and rests before the first and after the last time.
struct MovingDisc
{
    double radius;                        ///< > 0
    std::vector<double> times;            ///< at least one, rising strictly
    std::vector<Eigen::Vector2d> places;  ///< as many

    /// Its middle at that time.
    Eigen::Vector2d at(double time) const;
};

/// A chain that lies straight on a mobile robot: seen from above, all points within `radius` of a segment through the
/// robot's place, along its heading.
struct Carrier
{
    double behind;  ///< how far the segment goes against the heading, >= 0
    double ahead;   ///< and along it, >= 0; not both 0
    double radius;  ///< >= 0
};

/// Where the carrier is, and when.
struct CarrierPose
{
    /// >= 0.
    double time;
    Eigen::Vector2d place;  ///< of its middle
    double heading;         ///< radians; between two poses it goes straight, full turns count
};

/// What of a carriage is free.
struct CarriageVerdict
{
    bool free = true;        ///< whether all of the way is
    double time = 0.0;       ///< where it is not: when
    int obstacle = -1;       ///< which one: those that rest first, then those that move
    double clearance = 0.0;  ///< the least that was looked at

    /// Whether all of the way is free.
    explicit operator bool() const { return free; }
};

/// Decides whether a carrier that goes through these poses, place and heading linear in time between them, and rests in
/// the last one for ever, keeps off all obstacles, those that move included: in space and time, not by samples. A
/// stretch of time in which all velocities are constant is halved until what is known of its middle covers it: there
/// the distance changes by no more than both sides' speeds allow. What is not decided over a billionth of the whole
/// time counts as a touch.
/// \throws std::invalid_argument if times do not rise, there is no pose, or a number is out of range
CarriageVerdict certifyCarriage(const std::vector<CarrierPose> &way, const Carrier &carrier,
                                const ChordObstacles<2> &resting, const std::vector<MovingDisc> &moving);

/// Why there is no carriage.
enum class CarriageFailure
{
    None,
    StartBlocked,  ///< not even the lattice's next pose can be reached from the start
    GoalBlocked,   ///< the goal is not free once everything rests
    NoWay,         ///< none on this lattice
    TooMany,       ///< not found among as many states as may be looked at
};

/// "start_blocked" and the like.
std::string toText(CarriageFailure failure);

/// The lattice that is searched.
struct CarriageOptions
{
    Eigen::Vector2d lower;      ///< where the carrier's place may be: least coordinates
    Eigen::Vector2d upper;      ///< greatest coordinates
    double spacing;             ///< of the lattice's places, > 0
    int headings = 16;          ///< of the lattice, >= 4
    double speed;               ///< of the place, > 0
    double turnRate;            ///< radians per unit of time, > 0
    int maxStates = 2'000'000;  ///< >= 1
};

/// A carriage, or why there is none.
struct CarriagePlan
{
    CarriageFailure failure = CarriageFailure::None;  ///< none: the way is whole
    std::vector<CarrierPose> way;                     ///< from the start to the goal, certified
    int states = 0;                                   ///< that were looked at
};

/// The carriage that arrives first among those of a lattice of places, headings and times around the goal: steps to the
/// eight next places, turns to the two next headings, waiting, each taking one tick. The mobile robot is holonomic.
/// Every step is certified. When all obstacles rest, time counts no more, so that the search ends.
/// \param start its time is when it begins
/// \throws std::invalid_argument if a number is out of range
CarriagePlan planCarriage(const CarrierPose &start, const Eigen::Vector2d &goal, double goalHeading,
                          const Carrier &carrier, const ChordObstacles<2> &resting,
                          const std::vector<MovingDisc> &moving, const CarriageOptions &options);
}  // namespace narrows
