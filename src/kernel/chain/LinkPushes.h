// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/chain/NodePushes.h"

namespace narrows
{
/// How far links that are not neighbours are to be from each other.
struct LinkRoom
{
    double linkLength;  ///< > 0
    double waiting;     ///< length of the chain, as it lies on the entrance line before it moves
    double needed;      ///< what the certificate asks for, > 0
    double wanted;      ///< > needed: what is closer is pushed
    double mostPush;    ///< > 0
};

/// Looks at chords P(g(s))P(s) whose front ends are nodes of the path, and at all chords of later links there may be at
/// the same time (front end at g(g(s)) or behind, the entrance line included): pairs that are too near each other are
/// pushed apart, each by half. Where they meet, they are parted along what is perpendicular to both, on the side where
/// their middles are.
/// \return whether all have the room that is needed
template <int D>
bool pushLinksApart(const LeaderPath<D> &path, const LinkRoom &room, NodePushes<D> &pushes);

extern template bool pushLinksApart(const LeaderPath<2> &, const LinkRoom &, NodePushes<2> &);
extern template bool pushLinksApart(const LeaderPath<3> &, const LinkRoom &, NodePushes<3> &);
}  // namespace narrows
