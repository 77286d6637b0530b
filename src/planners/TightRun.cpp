// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TightRun.h"

#include <algorithm>

#include <ompl/base/ScopedState.h>

#include "kernel/chain/ChainMotionProof.h"
#include "planners/ChainRobot.h"
#include "validity/ArmValidityChecker.h"
#include "validity/ContinuousMotionValidator.h"

namespace narrows
{
namespace
{
constexpr double straightness = 1e-9;
constexpr double withinTolerance = 0.9;  ///< of the goal, for what rounding and the joints' values may add
constexpr double firstStep = 0.125;      ///< of the tip, in link lengths
constexpr double longestStep = 0.5;
constexpr double shortestStep = 1e-7;
constexpr double stepGrowth = 1.25;
/// The validator is dear for long chains: it is asked only for steps of less than this share of a link, which margins
/// do not prove.
constexpr double worthAsking = 0.01;
constexpr double mostTurn = 1.0;  ///< of a joint, radians: of these, any state space means the same motion as we do
/// What a certified path may lose by motions between its states: beyond this the path itself is refused.
constexpr double rounding = 1e-12;

template <int D>
class TightRunOf : public TightRun
{
public:
    using Point = Eigen::Matrix<double, D, 1>;
    using Space = typename ChainRobot<D>::Space;

    TightRunOf(const ob::SpaceInformationPtr &si, const typename ChainRobot<D>::Model &model,
               const TightSettings &settings, const Eigen::VectorXd &start, const TightGoal<D> &goal)
      : si_(si),
        space_(si->getStateSpace()->as<Space>()),
        robot_(model, *space_),
        settings_(settings),
        start_(start),
        goal_(goal),
        obstacles_(model.obstacles),
        proof_(obstacles_, robot_.spec())
    {
        const std::vector<Point> centres = robot_.centres(start);
        entrance_ = (centres[1] - centres[0]).normalized();
        refusal_ = isStraight(centres) ? "" : "start_not_straight";
        search_ = std::make_unique<TightSearch<D>>(obstacles_, robot_.spec(), settings_, centres.back(), entrance_,
                                                   goal_.tip, withinTolerance * goal_.tolerance);
    }

    std::string refusal() const override { return refusal_; }
    bool isDone() const override { return search_->isDone() && !feed_; }

    TightOutcome next(const std::function<bool()> &stop) override
    {
        if (!feed_)
        {
            const TightAttempt<D> attempt = search_->next(stop);
            if (attempt.nodes.empty())
                return {{start_}, attempt.failure.empty() ? lastFailure_ : attempt.failure};
            measures_["amplification"] = attempt.certificate.amplification;
            measures_["largest_angle"] = attempt.certificate.largestAngle;
            measures_["link_clearance"] = attempt.certificate.clearance;
            // Ways of links may cross where links do not meet: the validator knows.
            const bool worthFeeding = attempt.failure.empty() || attempt.failure == toText(ChainFailure::SelfCollision);
            lastFailure_ = attempt.failure;
            if (!worthFeeding)
                return {{start_}, attempt.failure};
            begin(attempt);
        }
        TightOutcome outcome{{}, feed(stop)};
        outcome.states = feed_->states;
        if (outcome.failure == "timeout")
            return outcome;
        if (!outcome.failure.empty() && !feed_->doubt.empty())
            outcome.failure = feed_->doubt;
        lastFailure_ = outcome.failure;
        feed_.reset();
        return outcome;
    }

    std::map<std::string, double> measures() const override
    {
        std::map<std::string, double> all = measures_;
        for (const auto &[name, value] : search_->counts())
            all[name] = value;
        return all;
    }

private:
    bool isStraight(const std::vector<Point> &centres) const
    {
        for (std::size_t i = 1; i < centres.size(); ++i)
            if (((centres[i] - centres[i - 1]).normalized() - entrance_).norm() > straightness)
                return false;
        return std::abs(std::abs(entrance_.dot(robot_.axis())) - 1.0) <= straightness;
    }

    /// A path on which the chain has been moved up to s.
    struct Feed
    {
        LeaderPath<D> path;
        std::string doubt;  ///< what the certificate has against the path
        std::vector<Eigen::VectorXd> states;
        double s;
        double step;
    };

    void begin(const TightAttempt<D> &attempt)
    {
        const Point tip = robot_.centres(start_).back();
        const double ahead = (attempt.nodes.front() - tip).dot(entrance_);
        feed_.emplace(Feed{LeaderPath<D>(attempt.nodes, entrance_),
                           attempt.failure,
                           {start_},
                           -ahead,
                           firstStep * robot_.spec().length});
    }

    /// Moves the tip along the path, in steps that are proven to be free. "timeout": a later call goes on.
    std::string feed(const std::function<bool()> &stop)
    {
        const double length = robot_.spec().length;
        Eigen::VectorXd values = start_;
        while (feed_->s < feed_->path.length())
        {
            if (stop())
                return "timeout";
            const double to = std::min(feed_->s + feed_->step, feed_->path.length());
            const std::string refused = poseAt(feed_->path, to, feed_->states.back(), values);
            if (refused.empty() && isFree(feed_->states.back(), values, feed_->step <= worthAsking * length))
            {
                feed_->states.push_back(values);
                feed_->s = to;
                feed_->step = std::min(stepGrowth * feed_->step, longestStep * length);
                continue;
            }
            measures_["refused_motions"] += 1.0;
            feed_->step *= 0.5;
            if (feed_->step < shortestStep * length)
                return refused.empty() ? "motion" : refused;
        }
        measures_["states"] = static_cast<double>(feed_->states.size());
        return goal_.values ? endIn(*goal_.values) : "";
    }

    /// From the last state to joint values with the same tip.
    std::string endIn(const Eigen::VectorXd &values)
    {
        Eigen::VectorXd &last = feed_->states.back();
        if ((values - last).template lpNorm<Eigen::Infinity>() <= rounding)
            last = values;
        else if (isFree(last, values, true))
            feed_->states.push_back(values);
        else
            return "goal_motion";
        return "";
    }

    /// The chain with its tip at s; a reason if it cannot take that pose.
    std::string poseAt(const LeaderPath<D> &path, double s, const Eigen::VectorXd &before,
                       Eigen::VectorXd &values) const
    {
        const std::vector<double> places = jointPlaces<D>(path, s, robot_.spec().length, robot_.spec().links);
        if (places.back() > 0.0)
            return toText(ChainFailure::TooShort);
        std::vector<Point> centres;
        for (auto place = places.rbegin(); place != places.rend(); ++place)
            centres.push_back(path.at(*place));
        if (!robot_.configuration(centres, before, values))
            return toText(ChainFailure::TooShort);
        ob::ScopedState<> state(si_);
        space_->fromConfiguration(values, state.get());
        if (!si_->satisfiesBounds(state.get()))
        {
            const auto *numbers = state->as<ob::RealVectorStateSpace::StateType>();
            const std::optional<Interval> &slide = space_->joints()[0].limits;
            const bool slides = !slide || (numbers->values[0] >= slide->lower && numbers->values[0] <= slide->upper);
            return slides ? toText(ChainFailure::JointLimit) : "slide_limit";
        }
        return "";
    }

    /// By margins if they suffice, else by the validator if it may be asked. Margins are about robot and obstacles:
    /// they say nothing of what somebody else's checker or validator wants to know.
    bool isFree(const Eigen::VectorXd &from, const Eigen::VectorXd &to, bool mayAsk)
    {
        const bool proven = marginsCount_ && hasMargin(from, to);
        const bool valid = !proven && (mayAsk || !marginsCount_) && isValid(from, to);
        measures_["motions_by_margin"] += proven ? 1.0 : 0.0;
        measures_["motions_by_validator"] += valid ? 1.0 : 0.0;
        return proven || valid;
    }

    bool hasMargin(const Eigen::VectorXd &from, const Eigen::VectorXd &to)
    {
        if ((to - from).tail(to.size() - 1).template lpNorm<Eigen::Infinity>() > mostTurn)
            return false;
        const Eigen::VectorXd half = 0.5 * (from + to);
        return keepsClear(from, to) || (keepsClear(from, half) && keepsClear(half, to));
    }

    bool keepsClear(const Eigen::VectorXd &from, const Eigen::VectorXd &to)
    {
        robot_.motion(from, to, motion_);
        return proof_.isFree(motion_);
    }

    bool isValid(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const
    {
        ob::ScopedState<> a(si_), b(si_);
        space_->fromConfiguration(from, a.get());
        space_->fromConfiguration(to, b.get());
        return si_->checkMotion(a.get(), b.get());
    }

    ob::SpaceInformationPtr si_;
    const Space *space_;
    const bool marginsCount_ =
        dynamic_cast<const ArmValidityChecker *>(si_->getStateValidityChecker().get()) != nullptr &&
        dynamic_cast<const ContinuousMotionValidator *>(si_->getMotionValidator().get()) != nullptr;
    ChainRobot<D> robot_;
    TightSettings settings_;
    Eigen::VectorXd start_;
    TightGoal<D> goal_;
    ChordObstacles<D> obstacles_;
    ChainMotionProof<D> proof_;
    ChainMotion<D> motion_;
    Point entrance_;
    std::string refusal_;
    std::unique_ptr<TightSearch<D>> search_;
    std::optional<Feed> feed_;  ///< what is under way
    std::string lastFailure_;
    std::map<std::string, double> measures_;
};
}  // namespace

std::unique_ptr<TightRun> makeTightRun(const ob::SpaceInformationPtr &si, const PlanarModel &model,
                                       const TightSettings &settings, const Eigen::VectorXd &start,
                                       const TightGoal<2> &goal)
{
    return std::make_unique<TightRunOf<2>>(si, model, settings, start, goal);
}

std::unique_ptr<TightRun> makeTightRun(const ob::SpaceInformationPtr &si, const SpatialModel &model,
                                       const TightSettings &settings, const Eigen::VectorXd &start,
                                       const TightGoal<3> &goal)
{
    return std::make_unique<TightRunOf<3>>(si, model, settings, start, goal);
}
}  // namespace narrows
