// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "kernel/trajectory/JointTrajectory.h"
#include "spaces/JointCoordinates.h"
#include "validity/ArmTravel.h"

namespace narrows
{
/// What is known of a timed motion.
enum class CertificateStatus
{
    Free,       ///< proven at all times
    Collision,  ///< the clearance is no larger than the margin, or than can be told apart from touching
    Limit,      ///< a joint leaves its limits, by more than 1e-9
    Undecided   ///< maxPlacements did not suffice
};

/// "free", "collision", ...
std::string toText(CertificateStatus status);

/// What is asked of a timed motion, and how long is looked.
struct TrajectoryCertificateOptions
{
    double margin = 0.0;                    ///< >= 0, a length: the clearance that shall be exceeded at all times
    std::uint64_t maxPlacements = 100'000;  ///< > 0, how many configurations are looked at, at most
};

/// Status of a timed motion, and where it comes from.
struct CertificateFinding
{
    CertificateStatus status = CertificateStatus::Free;  ///< of the whole motion
    double time = 0.0;                                   ///< where it fails, or what is undecided; 0 if free
    std::uint64_t placements = 0;                        ///< how many configurations were looked at
};

/// Decides whether a timed motion is free of collisions and within the limits of its joints at ALL times, without a
/// step size: a span of time is free when the clearance in its middle exceeds what the motion can take away from it
/// until the span's ends, which follows from enclosures of velocity and acceleration; otherwise it is halved, widest
/// first.
class TrajectoryCertificate
{
public:
    /// Clearance of a configuration, as ArmChecker::clearance().
    using Clearance = std::function<double(ConfigurationRef)>;

    /// \param space outlives the certificate; joints of trajectories are counted as its values are, without wrapping
    /// \param clearance of the space's arm; Lipschitz as ArmTravel says
    /// \param selfCollision whether the clearance counts links against each other too
    /// \param options margin and effort
    /// \throws std::invalid_argument if an option is out of range or ArmTravel refuses the space
    TrajectoryCertificate(const ArmStateSpace &space, Clearance clearance, bool selfCollision,
                          const TrajectoryCertificateOptions &options = {});

    /// \throws std::invalid_argument if the trajectory has another number of joints than the space
    CertificateFinding check(const JointTrajectory &trajectory) const;

private:
    class Search;

    const ArmStateSpace &space_;
    Clearance clearance_;
    TrajectoryCertificateOptions options_;
    JointCoordinates coordinates_;
    ArmTravel travel_;
    double resolution_;  ///< clearances up to it cannot be told from touching
};
}  // namespace narrows
