// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include <Eigen/Core>

namespace narrows
{
/// What is asked: can links of this length follow one another from the entrance to the goal?
struct LadderTask
{
    Eigen::Vector2d entrance;   ///< first point of the joints' way; the chain waits straight behind it
    Eigen::Vector2d direction;  ///< in which it enters, not zero
    Eigen::Vector2d goal;       ///< of the tip
    double tolerance = 0.0;     ///< >= 0, of the goal
    double length = 0.0;        ///< of a link, > 0
    double radius = 0.0;        ///< >= 0, half-width of a link
    Eigen::Vector2d lower;      ///< joints between entrance and goal stay in this box, links need not
    Eigen::Vector2d upper;      ///< the other corner
};

/// How finely rooms are cut.
struct LadderSearchOptions
{
    double spacing = 5.0;        ///< > 0, edge of the cells for the joint
    double finestAngle = 0.01;   ///< > 0, radians: intervals of directions are not divided below this
    int links = 2;               ///< 1 or 2, see excludeLadder()
    long maxNodes = 20'000'000;  ///< >= 1
};

/// What the search has proven.
enum class LadderVerdict
{
    Excluded,      ///< proven: no chain of such links gets there, whatever its path
    Open,          ///< not excluded at this resolution, which does not mean that there is a way
    StartBlocked,  ///< excluded at the entrance itself
    TooManyNodes,  ///< given up
};

/// "excluded" and the like.
std::string toText(LadderVerdict verdict);

/// What was proven, and what that cost.
struct LadderSearch
{
    LadderVerdict verdict = LadderVerdict::Open;  ///< what was proven
    long cells = 0;                               ///< whose free directions were found
    long nodes = 0;                               ///< places of the joint with arcs of directions that were reached
    long rays = 0;                                ///< links that were looked at
};

/// Tries to prove that a link is too long for planar rooms, for any path of the joints: the other side of what a path
/// proves that a chain can follow.
///
/// With `links` = 1 a single link moves freely between start and goal (the classical ladder). With 2 it is a joint with
/// the link behind it and the link ahead of it: all joints follow one path, so that its every point must be fit for
/// both at once, and both must be carried along continuously. That excludes lengths with which a single ladder still
/// passes.
///
/// The joint's place is cut into cells, the links' directions into intervals, which are halved. A cell and an interval
/// are dropped only if some point of the link lies in an obstacle for all places and directions in them, so that every
/// motion there is goes through what is kept. Arcs of kept directions of one cell, joined to those of its neighbours
/// that they overlap, make a graph; if the goal is not reached in it, there is no motion. Bends of joints and
/// self-collision are left out: they can only exclude more. \param distance of a point from the obstacles, negative
/// inside by its depth or less; between two points it changes by no more than they are apart \throws
/// std::invalid_argument if the task or the options are out of range
LadderSearch excludeLadder(const LadderTask &task, const std::function<double(const Eigen::Vector2d &)> &distance,
                           const LadderSearchOptions &options = {});
}  // namespace narrows
