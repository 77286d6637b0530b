// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <stdexcept>

#include "kernel/chain/Carriage.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

/// A state of the lattice: steps from the goal, and ticks since the start (no more than until everything rests).
using Node = std::array<int, 4>;  // x, y, heading, tick

class CarriageSearch
{
public:
    CarriageSearch(const CarrierPose &start, const Vector2d &goal, double goalHeading, const Carrier &carrier,
                   const ChordObstacles<2> &resting, const std::vector<MovingDisc> &moving,
                   const CarriageOptions &options)
      : start_(start),
        goal_(goal),
        goalHeading_(goalHeading),
        carrier_(carrier),
        resting_(resting),
        moving_(moving),
        options_(options),
        turn_(2.0 * M_PI / options.headings),
        tick_(std::max(std::sqrt(2.0) * options.spacing / options.speed, turn_ / options.turnRate))
    {
        double end = start.time;
        for (const MovingDisc &disc : moving)
            end = std::max(end, disc.times.back());
        restTick_ = static_cast<int>(std::ceil((end - start.time) / tick_)) + 1;
    }

    CarriagePlan run()
    {
        if (!isFree({{start_.time + (restTick_ + 1) * tick_, goal_, goalHeading_}}))
            return failed(CarriageFailure::GoalBlocked);
        const Node first = nearestToStart();
        if (!isStepFree(between(start_, poseOf(first, 1))))
            return failed(CarriageFailure::StartBlocked);
        reached_[first] = {1, first};
        open_.push({1 + left(first), first});
        while (!open_.empty())
        {
            const Node node = open_.top().second;
            const int ticks = reached_[node].ticks;
            const bool again = open_.top().first > ticks + left(node);
            open_.pop();
            if (again)
                continue;
            if (node[0] == 0 && node[1] == 0 && node[2] == 0 && isFree({poseOf(node, ticks)}))
                return found(node);
            if (++plan_.states > options_.maxStates)
                return failed(CarriageFailure::TooMany);
            expand(node, ticks);
        }
        return failed(CarriageFailure::NoWay);
    }

private:
    struct Reached
    {
        int ticks;
        Node from;
    };

    CarriagePlan failed(CarriageFailure failure)
    {
        plan_.failure = failure;
        return plan_;
    }

    CarrierPose poseOf(const Node &node, int ticks) const
    {
        return {start_.time + ticks * tick_, goal_ + options_.spacing * Vector2d(node[0], node[1]),
                goalHeading_ + turn_ * node[2]};
    }

    Node nearestToStart() const
    {
        const Vector2d steps = (start_.place - goal_) / options_.spacing;
        const int heading = static_cast<int>(std::lround((start_.heading - goalHeading_) / turn_));
        return {static_cast<int>(std::lround(steps.x())), static_cast<int>(std::lround(steps.y())),
                (heading % options_.headings + options_.headings) % options_.headings, std::min(1, restTick_)};
    }

    /// The motion between two poses, headings by the shorter way round.
    static std::vector<CarrierPose> between(const CarrierPose &from, CarrierPose to)
    {
        to.heading = from.heading + std::remainder(to.heading - from.heading, 2.0 * M_PI);
        return {from, to};
    }

    bool isFree(const std::vector<CarrierPose> &way) const
    {
        return static_cast<bool>(certifyCarriage(way, carrier_, resting_, moving_));
    }

    /// Without the rest at the end, which certifyCarriage() adds: obstacles stop where they are when the step is over.
    bool isStepFree(const std::vector<CarrierPose> &way) const
    {
        std::vector<MovingDisc> now;
        for (const MovingDisc &disc : moving_)
            now.push_back(during(disc, way.front().time, way.back().time));
        return static_cast<bool>(certifyCarriage(way, carrier_, resting_, now));
    }

    static MovingDisc during(const MovingDisc &disc, double begin, double end)
    {
        MovingDisc cut{disc.radius, {begin}, {disc.at(begin)}};
        for (std::size_t i = 0; i < disc.times.size(); ++i)
            if (disc.times[i] > begin && disc.times[i] < end)
            {
                cut.times.push_back(disc.times[i]);
                cut.places.push_back(disc.places[i]);
            }
        cut.times.push_back(end);
        cut.places.push_back(disc.at(end));
        return cut;
    }

    /// Ticks that are needed at least from there to the goal: steps and turns, as if nothing were in the way.
    int left(const Node &node) const
    {
        return std::max(std::abs(node[0]), std::abs(node[1])) + std::min(node[2], options_.headings - node[2]);
    }

    void expand(const Node &node, int ticks)
    {
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                step(node, {node[0] + dx, node[1] + dy, node[2], 0}, ticks);
        for (const int turn : {1, options_.headings - 1})
            step(node, {node[0], node[1], (node[2] + turn) % options_.headings, 0}, ticks);
    }

    void step(const Node &from, Node to, int ticks)
    {
        to[3] = std::min(ticks + 1, restTick_);
        const auto known = reached_.find(to);
        if (known != reached_.end() && known->second.ticks <= ticks + 1)
            return;
        const CarrierPose pose = poseOf(to, ticks + 1);
        const bool inside = (pose.place.array() >= options_.lower.array()).all() &&
                            (pose.place.array() <= options_.upper.array()).all();
        if (!inside || !isStepFree(between(poseOf(from, ticks), pose)))
            return;
        reached_[to] = {ticks + 1, from};
        open_.push({ticks + 1 + left(to), to});
    }

    CarriagePlan found(Node node)
    {
        std::vector<CarrierPose> way;
        while (true)
        {
            const Reached &reached = reached_.at(node);
            way.push_back(poseOf(node, reached.ticks));
            if (reached.from == node)
                break;
            node = reached.from;
        }
        way.push_back(start_);
        std::reverse(way.begin(), way.end());
        for (std::size_t i = 1; i < way.size(); ++i)
            way[i].heading = between(way[i - 1], way[i])[1].heading;
        plan_.way = std::move(way);
        return plan_;
    }

    CarrierPose start_;
    Vector2d goal_;
    double goalHeading_;
    const Carrier &carrier_;
    const ChordObstacles<2> &resting_;
    const std::vector<MovingDisc> &moving_;
    const CarriageOptions &options_;
    double turn_, tick_;
    int restTick_ = 0;
    CarriagePlan plan_;
    std::map<Node, Reached> reached_;
    using Entry = std::pair<int, Node>;  ///< ticks at the goal at best, and among equals the least node: the same plan
                                         ///< on every machine
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};
}  // namespace

std::string toText(CarriageFailure failure)
{
    switch (failure)
    {
        case CarriageFailure::None:
            return "";
        case CarriageFailure::StartBlocked:
            return "start_blocked";
        case CarriageFailure::GoalBlocked:
            return "goal_blocked";
        case CarriageFailure::NoWay:
            return "no_way";
        case CarriageFailure::TooMany:
            return "too_many";
    }
    return "";
}

CarriagePlan planCarriage(const CarrierPose &start, const Vector2d &goal, double goalHeading, const Carrier &carrier,
                          const ChordObstacles<2> &resting, const std::vector<MovingDisc> &moving,
                          const CarriageOptions &options)
{
    if (!(options.spacing > 0.0) || options.headings < 4 || !(options.speed > 0.0) || !(options.turnRate > 0.0) ||
        options.maxStates < 1 || !options.lower.allFinite() || !options.upper.allFinite())
        throw std::invalid_argument("planCarriage: an option is out of range");
    return CarriageSearch(start, goal, goalHeading, carrier, resting, moving, options).run();
}
}  // namespace narrows
