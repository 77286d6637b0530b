// SPDX-License-Identifier: BSD-3-Clause
// The steps of ThreadingSearch: straight ones and, where they are blocked, centred ones.
#include <algorithm>
#include <cmath>

#include "planners/ThreadingSearch.h"

namespace narrows
{
namespace
{
constexpr double wideFactor = 4.0;      ///< gaps up to so many times as wide as the narrowest count with it
constexpr double leastProgress = 0.02;  ///< of the way to the target that is left of it in the tangent
constexpr double slideGrowth = 1.5;
constexpr double longestSlide = 0.5;    ///< radians
constexpr int mostSlides = 10000;       ///< on one way: so that it ends
constexpr int mostCorrections = 3;      ///< of a step that ends in an obstacle
constexpr double overRelaxation = 1.5;  ///< of these corrections
constexpr double lookSpacing = 0.4;     ///< radians: how far apart motions are looked at before they are certified
constexpr int mostLooks = 8;
constexpr int listEvery = 8;  ///< nodes of a slide that nearest() finds
}  // namespace

ThreadingSearch::Progress ThreadingSearch::advance(Way &way, ompl::RNG &random)
{
    Progress progress = stepStraight(way);
    if (way.isPlain)
        return progress;
    if (progress == Progress::Trapped && hasGaps())
        progress = slide(way, random);
    if (progress == Progress::Trapped && depth_ < 0.0)
        progress = stepAlong(way);
    return progress;
}

bool ThreadingSearch::hasGaps()
{
    if (makeMidGap_)
    {
        midGap_ = makeMidGap_();
        makeMidGap_ = nullptr;
        if (midGap_ && midGap_->gapCount() > 0)
            centredStep_.emplace(*midGap_);
    }
    return centredStep_.has_value();
}

void ThreadingSearch::measureWay(const Way &way)
{
    const Eigen::VectorXd &from = tree(way.side)[way.node].x;
    if (way.stride.dimension == 0 && !way.isGiven)
        chart_.shortWay(from, way.goal, direction_);
    else
        direction_ = way.goal - from;
}

ThreadingSearch::Progress ThreadingSearch::stepStraight(Way &way, bool isGoalFree)
{
    way.sliding = false;
    depth_ = 0.0;
    measureWay(way);
    const Eigen::VectorXd &from = tree(way.side)[way.node].x;
    const double part = std::min(way.stride.range / direction_.norm(), chart_.unambiguousPart(direction_));
    const bool arrives = !(part < 1.0);
    if (arrives && way.target >= 0)
    {
        write(way.side, way.node, from_.get());
        write(1 - way.side, way.target, to_.get());
        const bool free = (looksOpen() || !meetsObstacle(from, direction_)) && si_->checkMotion(from_.get(), to_.get());
        counts_.blocked += free ? 0 : 1;
        return free ? Progress::Reached : Progress::Trapped;
    }
    step_ = (arrives ? 1.0 : part) * direction_;
    next_ = from + step_;
    // Asking about its end first spares most of the motions that are not free.
    const bool isEndFree = looksOpen() || (arrives && isGoalFree) || !isBlockedAt(next_, way.stride);
    const bool mayBeFree = isEndFree && (looksOpen() || !meetsObstacle(from, step_));
    if (mayBeFree && extend(way, next_, levelOf(way.stride), !way.isPlain))
        return arrives ? Progress::Reached : Progress::Advanced;
    ++counts_.blocked;
    return Progress::Trapped;
}

bool ThreadingSearch::isBlockedAt(const Eigen::VectorXd &x, const Stride &stride)
{
    return stride.bends ? isDeep(x) : firstMet(x, 0) >= 0;
}

bool ThreadingSearch::isDeep(const Eigen::VectorXd &x)
{
    if (!collision_)
        return false;
    chart_.toConfiguration(x, q_);
    depth_ = collision_->deepest(q_, gradient_);
    return depth_ < 0.0;
}

int ThreadingSearch::firstMet(const Eigen::VectorXd &x, int joint)
{
    if (!collision_)
        return -1;
    chart_.toConfiguration(x, q_);
    return collision_->firstMet(q_, joint);
}

bool ThreadingSearch::meetsObstacle(const Eigen::VectorXd &from, const Eigen::VectorXd &step)
{
    if (!collision_)
        return false;
    ++counts_.looks;
    int parts = 1;
    for (const double length = step.cwiseAbs().maxCoeff(); parts < mostLooks && length > lookSpacing * parts;)
        parts *= 2;
    chart_.toConfiguration(from, q_);
    chart_.toConfiguration(step, turning_);
    return collision_->isMetBetween(q_, turning_, parts);
}

ThreadingSearch::Progress ThreadingSearch::stepAlong(Way &way)
{
    const Eigen::VectorXd from = tree(way.side)[way.node].x;
    const double length = step_.norm();
    for (int i = 0; i < mostCorrections; ++i)
    {
        push_ = chart_.gradient(gradient_);
        if (way.stride.dimension > 0)
        {
            const auto basis = slices_.basis.leftCols(way.stride.dimension);
            push_ = basis * (basis.transpose() * push_);
        }
        const double square = push_.squaredNorm();
        if (!(square > 0.0))
            return Progress::Trapped;
        step_ -= overRelaxation * depth_ / square * push_;
        // Nearer to the target each time: so that ways end.
        if (!((direction_ - step_).norm() < direction_.norm() - leastProgress * length) || step_.norm() > 2.0 * length)
            return Progress::Trapped;
        next_ = from + step_;
        if (isDeep(next_))
            continue;
        if (!extend(way, next_, levelOf(way.stride), true))
            return Progress::Trapped;
        ++counts_.bent;
        return Progress::Advanced;
    }
    return Progress::Trapped;
}

int ThreadingSearch::levelOf(const Stride &stride) const
{
    return stride.dimension > 0 ? stride.dimension : static_cast<int>(chart_.dimension());
}

ThreadingSearch::Progress ThreadingSearch::slide(Way &way, ompl::RNG &random)
{
    chart_.toConfiguration(tree(way.side)[way.node].x, q_);
    if (way.slides >= mostSlides || !chooseCrossings(random))
        return Progress::Trapped;
    chart_.toConfiguration(direction_, turning_);  // as stepStraight left it
    centredStep_->begin(q_, crossings_);
    centredStep_->tangent(turning_, tangent_);
    const double least = leastSlide();
    if (!(tangent_.norm() > leastProgress * turning_.norm()))
        return centring_.recentring && recentre(way, least, random) ? Progress::Advanced : Progress::Trapped;
    double &step = slideStep_[static_cast<std::size_t>(way.side)];
    for (step = std::max(step, least); step >= least; step *= 0.5)
        if (slideBy(way, step, 0.0))
        {
            step = std::min(slideGrowth * step, longestSlide);
            return Progress::Advanced;
        }
    return Progress::Trapped;
}

bool ThreadingSearch::recentre(Way &way, double least, ompl::RNG &random)
{
    if (slideBy(way, 0.0, least))
        return true;
    const int last = static_cast<int>(crossings_.size()) - 1;
    if (last == 0)
        return false;
    crossings_ = {crossings_[static_cast<std::size_t>(random.uniformInt(0, last))]};
    crossings_[0].square = true;
    centredStep_->begin(q_, crossings_);
    return slideBy(way, 0.0, least);
}

bool ThreadingSearch::slideBy(Way &way, double length, double least)
{
    const double whole = tangent_.norm(), step = std::min(length, whole);
    if (!centredStep_->reach(step > 0.0 ? Eigen::VectorXd(step / whole * tangent_) : 0.0 * tangent_, next_))
        return false;
    next_ -= q_;
    if (step > 0.0 ? !(next_.dot(tangent_) > leastProgress * step * whole) : !(next_.norm() > least))
        return false;
    next_ = tree(way.side)[way.node].x + chart_.fromConfiguration(next_);
    if (!extend(way, next_, static_cast<int>(chart_.dimension()), way.unlisted + 1 >= listEvery))
    {
        ++counts_.refused;
        return false;
    }
    ++counts_.centred;
    ++way.slides;
    way.sliding = true;
    return true;
}

bool ThreadingSearch::chooseCrossings(ompl::RNG &random)
{
    midGap_->crossings(q_, centring_.lengthening * random.uniform01(), crossings_);
    if (crossings_.empty())
        return false;
    // Wide gaps need no care while a narrow one is threaded, and may not allow it.
    if (random.uniform01() < centring_.narrow)
    {
        const auto width = [this](const GapCrossing &crossing)
        {
            return midGap_->halfWidth(q_, crossing);
        };
        double least = std::numeric_limits<double>::infinity();
        for (const GapCrossing &crossing : crossings_)
            least = std::min(least, width(crossing));
        const auto isWide = [&](const GapCrossing &crossing)
        {
            return width(crossing) > wideFactor * least;
        };
        crossings_.erase(std::remove_if(crossings_.begin(), crossings_.end(), isWide), crossings_.end());
    }
    if (random.uniform01() >= centring_.square)
        for (GapCrossing &crossing : crossings_)
            crossing.square = random.uniformBool();
    return true;
}

/// Chords of a curved passage leave its middle by about the square of their length.
double ThreadingSearch::leastSlide() const
{
    double least = std::numeric_limits<double>::infinity();
    for (const GapCrossing &crossing : crossings_)
        least = std::min(least, 0.01 * std::sqrt(midGap_->halfWidth(q_, crossing) / midGap_->size(crossing)));
    return least;
}

bool ThreadingSearch::extend(Way &way, const Eigen::VectorXd &x, int level, bool listed)
{
    write(way.side, way.node, from_.get());
    chart_.write(x, to_->as<ob::RealVectorStateSpace::StateType>()->values);
    if (!si_->checkMotion(from_.get(), to_.get()))
        return false;
    ThreadingTree &tree = treeOf(way.side);
    level = std::max(level, tree[way.node].level);
    way.node = tree.add(x, way.node, level, coordinates(x), listed);
    way.unlisted = listed ? 0 : way.unlisted + 1;
    return true;
}

void ThreadingSearch::listLast(Way &way)
{
    if (way.unlisted > 0)
        treeOf(way.side).list(way.node, coordinates(tree(way.side)[way.node].x));
    way.unlisted = 0;
}
}  // namespace narrows
