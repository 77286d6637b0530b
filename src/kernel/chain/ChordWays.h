// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kernel/chain/ChordStretch.h"

namespace narrows
{
/// Looks for two links of a chain whose ways come within `distance` (> 0) of each other, over stretches that follow
/// each other and make up the whole path: chords of s and of s' <= g(g(s)), the chain on the entrance line included.
/// \param atRest where the base waits with the tip at the entrance
/// \param shortest stretches are not halved below this length; what is not certainly apart then counts as together
/// \return s of the first pair found, or nothing
template <int D>
std::optional<double> findMeetingChords(const LeaderPath<D> &path, double linkLength,
                                        const std::vector<ChordStretch<D>> &stretches,
                                        const Eigen::Matrix<double, D, 1> &atRest, double distance, double shortest);

extern template std::optional<double> findMeetingChords(const LeaderPath<2> &, double,
                                                        const std::vector<ChordStretch<2>> &, const Eigen::Vector2d &,
                                                        double, double);
extern template std::optional<double> findMeetingChords(const LeaderPath<3> &, double,
                                                        const std::vector<ChordStretch<3>> &, const Eigen::Vector3d &,
                                                        double, double);
}  // namespace narrows
