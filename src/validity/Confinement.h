// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// A proof that a task in the plane has no solution: its first joint (the slide, or else the first link's) stays
/// between two values, whatever the other joints do, and the goal's value is not between them. At each of the two the
/// joint's limit is reached, or a point of the robot that this joint alone places lies in an obstacle.
struct Confinement
{
    Interval first;               ///< of the joint's values, in absolute angles; the start's is inside
    std::array<double, 2> along;  ///< at either end: how far from the base on the first link the point is that lies in
                                  ///< an obstacle; 0, the base itself, if there is a slide
};

/// What is wrong with the proof; empty if nothing is, and then no path that solves the task is free. A point lies in an
/// obstacle if one of them covers 1e-9 around it. An angle of a joint without limits is looked at with all full turns.
std::string whyNoProof(const Confinement &confinement, const PlanarModel &model, const PlanarTask &task);
}  // namespace narrows
