// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "kernel/PlanarModel.h"
#include "kernel/SpatialModel.h"
#include "planners/TightSearch.h"
#include "spaces/Ompl.h"

namespace narrows
{
/// What came of one try.
struct TightOutcome
{
    std::vector<Eigen::VectorXd> states;  ///< configurations from the start on, joined by free motions
    std::string failure;                  ///< empty if the last state reaches the goal
};

/// The way of one chain to one goal, in the plane or in space: tries one path of TightSearch after the other, and turns
/// the first that a chain can follow into motions that are proven: by margins (ChainMotionProof) if state checker and
/// motion validator are this library's own, else by the validator.
class TightRun
{
public:
    virtual ~TightRun() = default;

    /// Why it cannot begin ("start_not_straight"); empty if it can.
    virtual std::string refusal() const = 0;
    virtual bool isDone() const = 0;  ///< Has everything been tried?
    /// The next try; "timeout" if `stop` ended it, then it goes on next time. Other failures are names of ChainFailure
    /// and of the grid or field, `slide_limit`, `motion` (not proven to be free) or `goal_motion` (that to the goal's
    /// values).
    virtual TightOutcome next(const std::function<bool()> &stop) = 0;
    /// Counts of the search and of the feed (states, motions_by_margin, motions_by_validator, refused_motions), and
    /// what the certificate of the last path says (amplification, largest_angle, link_clearance).
    virtual std::map<std::string, double> measures() const = 0;
};

/// Where a run ends.
template <int D>
struct TightGoal
{
    Eigen::Matrix<double, D, 1> tip;        ///< where the chain's tip shall be
    std::optional<Eigen::VectorXd> values;  ///< configuration to end in; none: the tip is all that matters
    double tolerance = 0.0;                 ///< >= 0, how far from it the tip may end
};

///@{
/// A run from a configuration to a goal; the model must outlive it.
/// \pre whyNoChain() of the model says nothing, the space is the robot's
std::unique_ptr<TightRun> makeTightRun(const ob::SpaceInformationPtr &si, const PlanarModel &model,
                                       const TightSettings &settings, const Eigen::VectorXd &start,
                                       const TightGoal<2> &goal);
std::unique_ptr<TightRun> makeTightRun(const ob::SpaceInformationPtr &si, const SpatialModel &model,
                                       const TightSettings &settings, const Eigen::VectorXd &start,
                                       const TightGoal<3> &goal);
///@}
}  // namespace narrows
