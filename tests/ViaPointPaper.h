// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/ViaPointTrajectory.h"

namespace narrows
{
/// The problems and parameters that the IOSTV paper prints; degrees and seconds.
struct PaperTrajectory
{
    ViaPointTask task;
    PaperParameters parameters;
};

inline constexpr ViaPointTask paperTaskA{-12.0, 5.0, 30.0, 1.5, 3.0};    // Figs. 2, 3
inline constexpr ViaPointTask paperTaskB{10.0, 25.0, 62.0, 2.6, 3.0};    // Figs. 4-6
inline constexpr ViaPointTask paperTaskC{30.0, 180.0, 120.0, 1.5, 3.0};  // Figs. 7-9

inline constexpr PaperTrajectory paperFig2{paperTaskA, {2.5, -1.4, 2.0, 0.05}};
/// With a = 1.8, which the paper does not print: with a = -1.4 its S_v is that of Fig. 2.
inline constexpr PaperTrajectory paperFig3{paperTaskA, {2.5, 1.8, 2.0, 1.2481}};
inline constexpr PaperTrajectory paperFig4{paperTaskB, {1.8, 1.2, 1.7, 0.05}};
inline constexpr PaperTrajectory paperFig6{paperTaskB, {70.0, 2.2, 125.0, -100.0}};
inline constexpr PaperTrajectory paperFig8{paperTaskC, {81.7467, 2.4, 1.91, 0.8734}};
inline constexpr PaperTrajectory paperFig9{paperTaskC, {5.0, 1.95, 5.0, 0.5865}};

inline ViaPointTrajectory trajectoryOf(const PaperTrajectory &paper)
{
    return *ViaPointTrajectory::paper(paper.task, paper.parameters);
}
}  // namespace narrows
