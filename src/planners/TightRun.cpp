// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TightRun.h"

#include <algorithm>

#include <ompl/base/ScopedState.h>

#include "planners/ChainRobot.h"

namespace narrows
{
namespace
{
constexpr double straightness = 1e-9;
constexpr double firstStep = 0.125;  ///< of the tip, in link lengths
constexpr double longestStep = 0.5;
constexpr double shortestStep = 1e-7;
constexpr double stepGrowth = 1.25;
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
        obstacles_(model.obstacles)
    {
        const std::vector<Point> centres = robot_.centres(start);
        entrance_ = (centres[1] - centres[0]).normalized();
        refusal_ = isStraight(centres) ? "" : "start_not_straight";
        search_ = std::make_unique<TightSearch<D>>(obstacles_, robot_.spec(), settings_, centres.back(), entrance_,
                                                   goal_.tip);
    }

    std::string refusal() const override { return refusal_; }
    bool isDone() const override { return search_->isDone(); }

    TightOutcome next(const std::function<bool()> &stop) override
    {
        const TightAttempt<D> attempt = search_->next(stop);
        if (attempt.nodes.empty())
            return {{start_}, attempt.failure};
        measures_["amplification"] = attempt.certificate.amplification;
        measures_["largest_angle"] = attempt.certificate.largestAngle;
        measures_["link_clearance"] = attempt.certificate.clearance;
        // Ways of links may cross where links do not meet: the validator knows.
        const bool worthFeeding = attempt.failure.empty() || attempt.failure == toText(ChainFailure::SelfCollision);
        if (!worthFeeding)
            return {{start_}, attempt.failure};
        TightOutcome outcome = feed(attempt.nodes, stop);
        if (!outcome.failure.empty() && !attempt.failure.empty() && outcome.failure != "timeout")
            outcome.failure = attempt.failure;
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

    /// Moves the tip along the path, in steps that the validator accepts.
    TightOutcome feed(const PointPath<D> &nodes, const std::function<bool()> &stop)
    {
        const LeaderPath<D> path(nodes, entrance_);
        const double length = robot_.spec().length;
        TightOutcome outcome{{start_}, ""};
        Eigen::VectorXd values = start_;
        double s = 0.0;
        for (double step = firstStep * length; s < path.length();)
        {
            if (stop())
                return {outcome.states, "timeout"};
            const double to = std::min(s + step, path.length());
            const std::string refused = poseAt(path, to, outcome.states.back(), values);
            if (refused.empty() && isFree(outcome.states.back(), values))
            {
                outcome.states.push_back(values);
                s = to;
                step = std::min(stepGrowth * step, longestStep * length);
                continue;
            }
            measures_["refused_motions"] += 1.0;
            step *= 0.5;
            if (step < shortestStep * length)
                return {outcome.states, refused.empty() ? "motion" : refused};
        }
        measures_["states"] = static_cast<double>(outcome.states.size());
        if (goal_.values && (*goal_.values - outcome.states.back()).template lpNorm<Eigen::Infinity>() > rounding)
        {
            if (!isFree(outcome.states.back(), *goal_.values))
                return {outcome.states, "goal_motion"};
            outcome.states.push_back(*goal_.values);
        }
        else if (goal_.values)
            outcome.states.back() = *goal_.values;
        return outcome;
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

    bool isFree(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const
    {
        ob::ScopedState<> a(si_), b(si_);
        space_->fromConfiguration(from, a.get());
        space_->fromConfiguration(to, b.get());
        return si_->checkMotion(a.get(), b.get());
    }

    ob::SpaceInformationPtr si_;
    const Space *space_;
    ChainRobot<D> robot_;
    TightSettings settings_;
    Eigen::VectorXd start_;
    TightGoal<D> goal_;
    ChordObstacles<D> obstacles_;
    Point entrance_;
    std::string refusal_;
    std::unique_ptr<TightSearch<D>> search_;
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
