// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/Carriage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "kernel/SegmentDistance.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

constexpr double resolution = 1e-9;  ///< of the whole time

void check(const std::vector<CarrierPose> &way, const Carrier &carrier, const std::vector<MovingDisc> &moving)
{
    bool good = !way.empty() && carrier.behind >= 0.0 && carrier.ahead >= 0.0 && carrier.behind + carrier.ahead > 0.0 &&
                carrier.radius >= 0.0;
    for (std::size_t i = 0; i < way.size(); ++i)
        good = good && std::isfinite(way[i].time) && way[i].place.allFinite() && std::isfinite(way[i].heading) &&
               (i == 0 || way[i].time > way[i - 1].time);
    for (const MovingDisc &disc : moving)
    {
        good = good && disc.radius > 0.0 && !disc.times.empty() && disc.times.size() == disc.places.size();
        for (std::size_t i = 1; good && i < disc.times.size(); ++i)
            good = disc.times[i] > disc.times[i - 1];
    }
    if (!good)
        throw std::invalid_argument("certifyCarriage: a pose, the carrier or a disc is out of range");
}

CarrierPose poseAt(const std::vector<CarrierPose> &way, double time)
{
    const auto after =
        std::upper_bound(way.begin(), way.end(), time, [](double t, const CarrierPose &pose) { return t < pose.time; });
    if (after == way.begin() || after == way.end())
        return after == way.end() ? way.back() : way.front();
    const CarrierPose &a = *(after - 1), &b = *after;
    const double share = (time - a.time) / (b.time - a.time);
    return {time, a.place + share * (b.place - a.place), a.heading + share * (b.heading - a.heading)};
}

/// One carriage under examination.
class Examination
{
public:
    Examination(const std::vector<CarrierPose> &way, const Carrier &carrier, const ChordObstacles<2> &resting,
                const std::vector<MovingDisc> &moving)
      : way_(way), carrier_(carrier), resting_(resting), moving_(moving)
    {
        verdict_.clearance = std::numeric_limits<double>::infinity();
    }

    CarriageVerdict run()
    {
        std::vector<double> times;
        for (const CarrierPose &pose : way_)
            times.push_back(pose.time);
        for (const MovingDisc &disc : moving_)
            for (const double time : disc.times)
                if (time > way_.front().time)
                    times.push_back(time);
        std::sort(times.begin(), times.end());
        shortest_ = resolution * std::max(times.back() - times.front(), 1e-300);
        if (times.size() == 1)
            times.push_back(times.front() + 1.0);  // nothing moves: any time will do
        for (std::size_t i = 1; i < times.size() && verdict_; ++i)
            if (times[i] > times[i - 1])
                examine(times[i - 1], times[i]);
        return verdict_;
    }

private:
    /// A stretch of time in which all velocities are constant.
    void examine(double begin, double end)
    {
        const CarrierPose first = poseAt(way_, begin), last = poseAt(way_, end);
        const double turn = std::abs(last.heading - first.heading) * std::max(carrier_.ahead, carrier_.behind);
        const Vector2d shift = last.place - first.place;
        std::vector<double> ways;  // relative to the discs
        for (const MovingDisc &disc : moving_)
            ways.push_back(((disc.at(end) - disc.at(begin)) - shift).norm() + turn);
        const double length = end - begin;
        std::vector<double> ends{end};
        while (!ends.empty() && verdict_)
        {
            const double part = (ends.back() - begin) / length;
            if (covers(0.5 * (begin + ends.back()), 0.5 * part * (shift.norm() + turn), 0.5 * part, ways,
                       ends.back() - begin <= shortest_))
            {
                begin = ends.back();
                ends.pop_back();
            }
            else
                ends.push_back(0.5 * (begin + ends.back()));
        }
    }

    /// Whether what is known in the middle covers the stretch; if it certainly does not, the verdict says so.
    bool covers(double middle, double moves, double half, const std::vector<double> &ways, bool last)
    {
        const CarrierPose pose = poseAt(way_, middle);
        const Vector2d along(std::cos(pose.heading), std::sin(pose.heading));
        const Vector2d rear = pose.place - carrier_.behind * along, front = pose.place + carrier_.ahead * along;
        const double enough = carrier_.radius + std::max(verdict_.clearance, moves);
        const double room = resting_.clearance(rear, front, enough) - carrier_.radius;
        bool covered = judge(room, moves, -1, middle, last);
        for (std::size_t i = 0; i < moving_.size() && verdict_; ++i)
        {
            const double gap = std::sqrt(squaredDistance(rear, front, moving_[i].at(middle))) - moving_[i].radius;
            covered = judge(gap - carrier_.radius, half * ways[i], static_cast<int>(i), middle, last) && covered;
        }
        return covered;
    }

    bool judge(double room, double moves, int disc, double time, bool last)
    {
        verdict_.clearance = std::min(verdict_.clearance, room);
        if (room <= 0.0 || (last && room <= moves))
        {
            verdict_.free = false;
            verdict_.time = time;
            verdict_.obstacle = disc < 0 ? nearest(time) : static_cast<int>(resting_.obstacles().size()) + disc;
        }
        return room > moves;
    }

    /// The obstacle at rest that is in the way.
    int nearest(double time) const
    {
        const CarrierPose pose = poseAt(way_, time);
        const Vector2d along(std::cos(pose.heading), std::sin(pose.heading));
        int found = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < resting_.obstacles().size(); ++i)
        {
            const ChordObstacles<2> one({resting_.obstacles()[i]});
            const double room =
                one.clearance(pose.place - carrier_.behind * along, pose.place + carrier_.ahead * along, 1e300);
            if (room < least)
                found = static_cast<int>(i);
            least = std::min(least, room);
        }
        return found;
    }

    const std::vector<CarrierPose> &way_;
    const Carrier &carrier_;
    const ChordObstacles<2> &resting_;
    const std::vector<MovingDisc> &moving_;
    double shortest_ = 0.0;
    CarriageVerdict verdict_;
};
}  // namespace

Eigen::Vector2d MovingDisc::at(double time) const
{
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.begin())
        return places.front();
    if (after == times.end())
        return places.back();
    const std::size_t i = static_cast<std::size_t>(after - times.begin());
    return places[i - 1] + (time - times[i - 1]) / (times[i] - times[i - 1]) * (places[i] - places[i - 1]);
}

CarriageVerdict certifyCarriage(const std::vector<CarrierPose> &way, const Carrier &carrier,
                                const ChordObstacles<2> &resting, const std::vector<MovingDisc> &moving)
{
    check(way, carrier, moving);
    return Examination(way, carrier, resting, moving).run();
}
}  // namespace narrows
