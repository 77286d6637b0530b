// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/TrajectoryFailure.h"

namespace narrows
{
std::string toText(TrajectoryFailure failure)
{
    switch (failure)
    {
        case TrajectoryFailure::None:
            return "none";
        case TrajectoryFailure::NotFinite:
            return "not finite";
        case TrajectoryFailure::BadTime:
            return "bad time";
        case TrajectoryFailure::BadBase:
            return "bad base";
        case TrajectoryFailure::BadShape:
            return "bad shape";
        case TrajectoryFailure::BadCount:
            return "bad count";
        case TrajectoryFailure::BadLimit:
            return "bad limit";
        case TrajectoryFailure::Pole:
            return "pole";
        case TrajectoryFailure::Singular:
            return "singular";
        case TrajectoryFailure::NoMotion:
            return "no motion";
        case TrajectoryFailure::Infeasible:
            return "infeasible";
    }
    return "unknown";
}
}  // namespace narrows
