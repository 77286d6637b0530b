// SPDX-License-Identifier: BSD-3-Clause
#include "validity/TrajectoryCertificate.h"

#include <cmath>
#include <deque>
#include <stdexcept>

#include "spaces/SpatialArmStateSpace.h"
#include "validity/JointRules.h"
#include "validity/TrajectorySpans.h"

namespace narrows
{
namespace
{
constexpr double clearanceTolerance = 1e-9;  // of the arm's reach, as ArmChecker has it
}  // namespace

std::string toText(CertificateStatus status)
{
    switch (status)
    {
        case CertificateStatus::Free:
            return "free";
        case CertificateStatus::Collision:
            return "collision";
        case CertificateStatus::Limit:
            return "limit";
        case CertificateStatus::Undecided:
            break;
    }
    return "undecided";
}

/// One check of one trajectory.
class TrajectoryCertificate::Search
{
public:
    Search(const TrajectoryCertificate &certificate, const JointTrajectory &trajectory)
      : own_(certificate), trajectory_(trajectory), spans_(trajectory)
    {
        for (std::size_t piece = 0; piece < spans_.pieces(); ++piece)
            open_.push_back({piece, spans_.knots()[piece], spans_.knots()[piece + 1]});
    }

    CertificateFinding run()
    {
        while (!open_.empty())
        {
            const Span span = open_.front();
            open_.pop_front();
            const double middle = 0.5 * (span.from + span.to);
            if (finding_.placements >= own_.options_.maxPlacements)
                return failed(CertificateStatus::Undecided, middle);
            ++finding_.placements;
            look(span, middle);
            const Verdict limits = withinLimits();
            if (limits == Verdict::Broken)
                return failed(CertificateStatus::Limit, middle);
            const double spare = own_.clearance_(configuration_) - own_.options_.margin;
            if (!(spare > own_.resolution_))
                return failed(CertificateStatus::Collision, middle);
            if (limits == Verdict::Kept && own_.travel_(changes_) < spare)
                continue;
            open_.push_back({span.piece, span.from, middle});
            open_.push_back({span.piece, middle, span.to});
        }
        return finding_;
    }

private:
    struct Span
    {
        std::size_t piece;
        double from, to;
    };

    enum class Verdict
    {
        Kept,
        Open,
        Broken
    };

    /// State in the middle, and how far joints and configuration can get away from it within the span.
    void look(const Span &span, double middle)
    {
        const double half = 0.5 * (span.to - span.from);
        const Eigen::MatrixXd &map = own_.coordinates_.toConfiguration();
        trajectory_.at(middle, state_);
        spans_.bounds(span.piece, {span.from, span.to}, speeds_, accelerations_);
        configuration_.noalias() = map * state_.col(0);
        const auto within = [half](const auto &speed, const auto &bend, const auto &fastest)
        {
            return (half * (speed.cwiseAbs() + 0.5 * half * bend)).cwiseMin(half * fastest).eval();
        };
        joints_ = within(state_.col(1), accelerations_, speeds_);
        velocity_.noalias() = map * state_.col(1);
        bend_.noalias() = map.cwiseAbs() * accelerations_;
        speed_.noalias() = map.cwiseAbs() * speeds_;
        changes_ = within(velocity_, bend_, speed_);
    }

    Verdict withinLimits() const
    {
        Verdict verdict = Verdict::Kept;
        const auto need = [&verdict](double excess, double change)
        {
            if (excess > proof::limitTolerance)
                verdict = Verdict::Broken;
            else if (verdict == Verdict::Kept && excess + change > proof::limitTolerance)
                verdict = Verdict::Open;
        };
        const std::vector<ArmJoint> &joints = own_.space_.joints();
        for (std::size_t i = 0; i < joints.size(); ++i)
            if (const std::optional<Interval> &limits = joints[i].limits)
            {
                const double value = state_(static_cast<Eigen::Index>(i), 0);
                need(std::max(limits->lower - value, value - limits->upper), joints_[static_cast<Eigen::Index>(i)]);
            }
        if (const auto *spatial = dynamic_cast<const SpatialArmStateSpace *>(&own_.space_))
            for (const UniversalRange &range : spatial->universalRanges())
            {
                // The bend is an angle between directions: it changes by no more than both joints turn.
                const UniversalLimit &limit = range.limit();
                const double first = state_(limit.first, 0), second = state_(limit.second, 0);
                const double bend =
                    std::max({std::acos(std::cos(first) * std::cos(second)), std::abs(first), std::abs(second)});
                need(bend - limit.maxAngle, joints_[limit.first] + joints_[limit.second]);
            }
        return verdict;
    }

    CertificateFinding failed(CertificateStatus status, double time)
    {
        finding_.status = status;
        finding_.time = time;
        return finding_;
    }

    const TrajectoryCertificate &own_;
    const JointTrajectory &trajectory_;
    TrajectorySpans spans_;
    std::deque<Span> open_;
    CertificateFinding finding_;
    JointTrajectory::States state_;             ///< in the middle of the span
    Eigen::VectorXd speeds_, accelerations_;    ///< bounds over the span, per joint
    Eigen::VectorXd configuration_, velocity_;  ///< in the middle
    Eigen::VectorXd bend_, speed_;              ///< bounds over the span, per value of the configuration
    Eigen::VectorXd joints_, changes_;          ///< how far joints and configuration can get away
};

TrajectoryCertificate::TrajectoryCertificate(const ArmStateSpace &space, Clearance clearance, bool selfCollision,
                                             const TrajectoryCertificateOptions &options)
  : space_(space),
    clearance_(std::move(clearance)),
    options_(options),
    coordinates_(space),
    travel_(space, selfCollision),
    resolution_(clearanceTolerance * travel_.reach())
{
    if (!(options.margin >= 0.0) || !std::isfinite(options.margin) || options.maxPlacements == 0)
        throw std::invalid_argument("a certificate's margin must be finite and not negative, its placements positive");
}

CertificateFinding TrajectoryCertificate::check(const JointTrajectory &trajectory) const
{
    if (trajectory.joints() != coordinates_.joints())
        throw std::invalid_argument("the trajectory has another number of joints than the space");
    return Search(*this, trajectory).run();
}
}  // namespace narrows
