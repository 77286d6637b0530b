// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/JointTrajectory.h"
#include "spaces/ArmStateSpace.h"
#include "validity/Verifier.h"

namespace narrows
{
/// What the verifier says of a timed motion.
struct TrajectoryVerdict
{
    Verdict chords;           ///< of the polyline through the samples; its reason says why a motion is refused, with
                              ///< `limits` for a joint that leaves its limits between samples, `not_certified` if
                              ///< maxSamples were too few
    bool accepted = false;    ///< proven for all times
    double clearance = 0.0;   ///< if accepted: never overstated
    std::size_t samples = 0;  ///< configurations of the polyline
};

///@{
/// Judges a motion by the verifier, for all times: it is sampled until no point of the arm strays from the polyline
/// through the samples by half of the clearance that the verifier proves for it. Shares no geometry with the checkers,
/// and with TrajectoryCertificate only how far an arm can travel; positions are held against limits by certified
/// extremes. Much slower than the certificate.
///
/// \param model, task what is to be solved
/// \param space of the arm; joints of the motion are counted as its values are, without wrapping
/// \param trajectory the motion \param maxSamples > 1, of the polyline
/// \throws std::invalid_argument if the space is not the arm's or the motion has another number of joints
TrajectoryVerdict verifyTrajectory(const PlanarModel &model, const PlanarTask &task, const ArmStateSpace &space,
                                   const JointTrajectory &trajectory, std::size_t maxSamples = 100'000);
TrajectoryVerdict verifyTrajectory(const SpatialModel &model, const SpatialTask &task, const ArmStateSpace &space,
                                   const JointTrajectory &trajectory, std::size_t maxSamples = 100'000);
///@}
}  // namespace narrows
