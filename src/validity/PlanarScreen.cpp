// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PlanarScreen.h"

#include <algorithm>
#include <cmath>

#include "validity/LaneQueue.h"

namespace narrows
{
namespace
{
using Rows = Eigen::Ref<const Eigen::MatrixXd>;

constexpr std::uint32_t allLanes = (1u << lanes::count) - 1;

/// Largest coordinate that an arm's points can have.
double sizeOf(const PlanarArm &arm)
{
    const double slide = arm.slide() ? std::max(std::abs(arm.slide()->lower), std::abs(arm.slide()->upper)) : 0.0;
    return arm.base().norm() + slide + arm.reach();
}

constexpr int word = 32;  // bits

/// Has it many bits, as many as make it worthwhile not to wait for more?
bool areMany(std::uint32_t bits)
{
    for (int i = 0; i < 5; ++i)
        bits &= bits - 1;
    return bits != 0;
}
}  // namespace

/// What one thread needs.
struct PlanarScreen::Work
{
    void begin(std::size_t obstacleCount, Eigen::Index rowCount)
    {
        findings.assign(static_cast<std::size_t>(rowCount), Finding::Clear);
        queues.resize(obstacleCount);
    }

    void note(Eigen::Index row, std::int32_t finding)
    {
        findings[row] = std::max(findings[row], static_cast<Finding>(finding));
    }

    /// Lanes that touch something need not be looked at any more.
    void dropTouching()
    {
        for (int l = 0; l < lanes::count; ++l)
            if (found.of[l] == 2)
                open &= ~(1u << l);
    }

    std::vector<Finding> findings;
    std::vector<lanes::Queue> queues;  ///< per obstacle
    // of the block at hand
    Eigen::Index first = 0;
    std::uint32_t open = 0;  ///< lanes whose finding may still become worse
    std::vector<lanes::Points> points;
    std::vector<lanes::Meetings> meetings;  ///< per link
    lanes::Findings found;
    Eigen::MatrixXd padded;
};

/// Each link adds two roundings of a number up to the arm's size to its tip, on top of its own sine's; the distances
/// have fewer than 24 more.
PlanarScreen::PlanarScreen(const PlanarModel &model, std::vector<LinkPair> pairs)
  : arm_(model.arm),
    pairs_(std::move(pairs)),
    room_((24 + 2 * arm_.linkCount()) * lanes::rounding * sizeOf(arm_)),
    pairRange_(laneRange(2.0 * arm_.radius(), 2.0 * room_)),
    obstacles_(model.obstacles, arm_.radius(), room_)
{
    for (const PlanarLink &link : arm_.links())
        links_.push_back({static_cast<float>(link.length), link.parent});
}

void PlanarScreen::examine(const Rows &configurations, std::vector<Finding> &findings) const
{
    thread_local Work work;
    const Eigen::Index rowCount = configurations.rows();
    work.begin(obstacles_.boxes().size(), rowCount);
    for (work.first = 0; work.first + lanes::count <= rowCount; work.first += lanes::count)
    {
        work.open = allLanes;
        examineBlock(configurations.middleRows(work.first, lanes::count), work);
    }
    if (const Eigen::Index rest = rowCount - work.first; rest > 0)
    {
        work.open = (1u << rest) - 1;
        work.padded.setZero(lanes::count, configurations.cols());
        work.padded.topRows(rest) = configurations.bottomRows(rest);
        examineBlock(work.padded, work);
    }
    for (std::size_t k = 0; k < work.queues.size(); ++k)
        flush(k, work);
    findings.swap(work.findings);
}

void PlanarScreen::flush(std::size_t k, Work &work) const
{
    lanes::Queue &queue = work.queues[k];
    if (queue.size == 0)
        return;
    lanes::Findings found;
    obstacles_.examine(k, queue.a, queue.b, found);
    for (int i = 0; i < queue.size; ++i)
        work.note(queue.rows[i], found.of[i]);
    queue.size = 0;
}

void PlanarScreen::examineBlock(const Rows &block, Work &work) const
{
    work.found = {};
    const std::uint32_t strange = work.open & place(block, work);
    work.open &= ~strange;
    const std::uint32_t placed = work.open;
    examineObstacles(work);
    examinePairs(work);
    lanes::forEachBit(placed, [&work](int l) { work.note(work.first + l, work.found.of[l]); });
    lanes::forEachBit(strange, [&work](int l) { work.note(work.first + l, 1); });
}

/// \return lanes with angles or slides that cannot be placed well
std::uint32_t PlanarScreen::place(const Rows &block, Work &work) const
{
    lanes::Findings strange;
    work.points.resize(links_.size() + 1);
    for (int l = 0; l < lanes::count; ++l)
    {
        Eigen::Vector2d base = arm_.base();
        if (const auto &slide = arm_.slide())
        {
            const double way = block(l, 0);
            strange.of[l] = way >= slide->lower && way <= slide->upper ? 0 : 1;
            base += way * slide->axis;
        }
        work.points[0].x[l] = static_cast<float>(base.x());
        work.points[0].y[l] = static_cast<float>(base.y());
    }
    lanes::placeLinks(block.data() + arm_.firstAngle() * block.outerStride(), block.outerStride(), links_.data(),
                      arm_.linkCount(), work.points.data(), strange);
    std::uint32_t result = 0;
    for (int l = 0; l < lanes::count; ++l)
        result |= strange.of[l] != 0 ? 1u << l : 0u;
    return result;
}

void PlanarScreen::examineObstacles(Work &work) const
{
    const std::vector<lanes::Box> &boxes = obstacles_.boxes();
    work.meetings.resize(links_.size());
    for (std::size_t first = 0; first < boxes.size(); first += word)
    {
        const int boxCount = static_cast<int>(std::min<std::size_t>(word, boxes.size() - first));
        lanes::findMeetings(work.points.data(), links_.data(), arm_.linkCount(), &boxes[first], boxCount,
                            work.meetings.data());
        for (std::size_t i = 0; i < links_.size() && work.open != 0; ++i)
            lanes::forEachBit(work.meetings[i].any,
                              [&](int k)
                              {
                                  examineObstacle(first + k, work.points[links_[i].parent + 1], work.points[i + 1],
                                                  lanes::lanesThatMeet(work.meetings[i], k) & work.open, work);
                              });
    }
}

/// Where many lanes are near an obstacle it is looked at at once; where few are, they wait for others.
void PlanarScreen::examineObstacle(std::size_t k, const lanes::Points &a, const lanes::Points &b, std::uint32_t near,
                                   Work &work) const
{
    if (areMany(near))
    {
        obstacles_.examine(k, a, b, work.found);
        work.dropTouching();
        return;
    }
    lanes::forEachBit(near,
                      [&](int l)
                      {
                          if (work.queues[k].add(a, b, l, work.first + l))
                              flush(k, work);
                      });
}

void PlanarScreen::examinePairs(Work &work) const
{
    const auto room = static_cast<float>(2.0 * arm_.radius() + 2.0 * room_);
    for (const auto &[link, other] : pairs_)
    {
        if (work.open == 0)
            return;
        const lanes::Points &a = work.points[links_[link].parent + 1], &b = work.points[link + 1];
        const lanes::Points &c = work.points[links_[other].parent + 1], &d = work.points[other + 1];
        if ((lanes::findMeetings(a, b, c, d, room) & work.open) == 0)
            continue;
        lanes::examine(a, b, c, d, pairRange_, work.found);
        work.dropTouching();
    }
}
}  // namespace narrows
