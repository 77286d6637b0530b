// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/LadderArcs.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
namespace
{
constexpr double turn = 2.0 * M_PI;
constexpr int sectors = 16;
}  // namespace

bool LadderArc::meets(const LadderArc &other) const
{
    for (const double shift : {-turn, 0.0, turn})
        if (from <= other.to + shift && other.from + shift <= to)
            return true;
    return false;
}

std::vector<LadderArc> LadderArcs::around(const Eigen::Vector2d &center)
{
    std::vector<LadderArc> kept;
    for (int i = 0; i < sectors; ++i)
        divide(center, {turn * i / sectors, turn * (i + 1) / sectors}, kept);
    if (kept.size() > 1 && kept.front().from == 0.0 && kept.back().to == turn)
    {
        kept.front().from = kept.back().from - turn;
        kept.pop_back();
    }
    return kept;
}

void LadderArcs::divide(const Eigen::Vector2d &center, const LadderArc &arc, std::vector<LadderArc> &kept)
{
    const double middle = 0.5 * (arc.from + arc.to), half = 0.5 * (arc.to - arc.from);
    const Ray ray = look(center, middle, half);
    if (ray == Ray::Blocked)
        return;
    if (ray == Ray::Undecided && 2.0 * half > finest_)
    {
        divide(center, {arc.from, middle}, kept);
        divide(center, {middle, arc.to}, kept);
    }
    else if (!kept.empty() && kept.back().to == arc.from)
        kept.back().to = arc.to;
    else
        kept.push_back(arc);
}

LadderArcs::Ray LadderArcs::look(const Eigen::Vector2d &center, double angle, double halfWidth)
{
    ++rays_;
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    const double shortest = 0.1 * away_;
    Ray ray = Ray::Clear;
    double t = 0.0;
    while (true)
    {
        // As far as the point at t moves while the joint and the direction go through all their values.
        const double moves = away_ + t * halfWidth;
        const double room = distance_(center + t * along) - radius_;
        if (room + moves < 0.0)
            return Ray::Blocked;
        if (room <= moves)
            ray = Ray::Undecided;
        if (t == length_)
            return ray;
        t = std::min(t + std::max((room + moves) / (1.0 + halfWidth), shortest), length_);
    }
}
}  // namespace narrows
