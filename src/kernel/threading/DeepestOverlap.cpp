// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/DeepestOverlap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kernel/SineCosine.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

constexpr int boxesAtOnce = 4;      ///< that BoxArrays compares
constexpr double surelyLess = 3.0;  ///< radians, than half a turn: the sum of two directions then lies between them
}  // namespace

DeepestOverlap::DeepestOverlap(const PlanarModel &model)
  : arm_(model.arm),
    shapes_(model.obstacles),
    obstacles_(model.obstacles.size()),
    points_(model.arm.links().size() + 1),
    links_(model.arm.links().size())
{
    for (std::size_t t = 0; t < links_.size(); ++t)
    {
        const double length = arm_.links()[t].length;
        links_[t].inverseSquare = 1.0 / (length * length);
        longestLink_ = std::max(longestLink_, length);
    }
    for (const PlanarObstacle &obstacle : model.obstacles)
    {
        boxes_.push_back(bounds(obstacle));
        boxes_.back().lower.array() -= arm_.radius();
        boxes_.back().upper.array() += arm_.radius();
    }
    obstacleBoxes_.resize(static_cast<int>(boxes_.size()));
    for (int i = 0; i < obstacleBoxes_.count(); ++i)
        obstacleBoxes_.set(i, boxes_[static_cast<std::size_t>(i)].lower, boxes_[static_cast<std::size_t>(i)].upper,
                           0.0);
    linkBoxes_.resize(boxesAtOnce);
}

void DeepestOverlap::direct(ConfigurationRef q, Directions &directions) const
{
    const int count = arm_.linkCount();
    const double *angles = q.data() + arm_.firstAngle();
    directions.resize(links_.size());
    SineCosineBlock turns;
    for (int first = 0; first < count; first += turns.most)
    {
        const int size = std::min(turns.most, count - first);
        std::copy_n(angles + first, size, turns.angles);
        turns.evaluate(size);
        for (int i = 0; i < size; ++i)
            directions[static_cast<std::size_t>(first + i)] = {turns.cosines[i], turns.sines[i]};
    }
}

void DeepestOverlap::halve(const Directions &from, const Directions &to, ConfigurationRef q, ConfigurationRef delta,
                           double t, double half, Directions &result) const
{
    result.resize(links_.size());
    Eigen::Index joint = arm_.firstAngle();
    for (std::size_t i = 0; i < result.size(); ++i, ++joint)
        if (2.0 * half * std::abs(delta[joint]) < surelyLess)
        {
            const Vector2d sum = from[i] + to[i];
            result[i] = sum / std::sqrt(sum.squaredNorm());
        }
        else
        {
            const double angle = q[joint] + t * delta[joint];
            result[i] = {std::cos(angle), std::sin(angle)};
        }
}

void DeepestOverlap::placeBase(double slide)
{
    points_[0] = arm_.base();
    if (arm_.slide())
        points_[0] += slide * arm_.slide()->axis;
}

void DeepestOverlap::place(std::size_t link, const Directions &directions)
{
    const PlanarLink &shape = arm_.links()[link];
    links_[link].base = points_[static_cast<std::size_t>(shape.parent + 1)];
    links_[link].along = shape.length * directions[link];
    points_[link + 1] = links_[link].base + links_[link].along;
}

double DeepestOverlap::deepest(ConfigurationRef q, Eigen::VectorXd &gradient)
{
    direct(q, directions_[0]);
    placeBase(q[0]);
    double depth = 0.0;
    std::size_t deepestLink = 0;
    LinkForce force;
    for (std::size_t first = 0; first < links_.size(); first += boxesAtOnce)
        for (int i = 0, count = placeSome(first, directions_[0]); i < count; ++i)
            visitNear(first + i, i,
                      [&](const LinkObstacle &obstacle)
                      {
                          const Segment &link = links_[first + i];
                          if (!obstacle.isMet(link))
                              return true;
                          const LinkTerm term = obstacle.pole(link);
                          if (term.value < depth)
                          {
                              depth = term.value;
                              deepestLink = first + i;
                              force = term.slope;
                          }
                          return true;
                      });
    if (depth < 0.0)
    {
        forces_.assign(links_.size(), {});
        forces_[deepestLink] = force;
        gatherGradient(arm_, points_, forces_, carried_, gradient);
    }
    return depth;
}

const LinkObstacle &DeepestOverlap::obstacle(std::size_t i)
{
    if (!obstacles_[i])
        obstacles_[i] = makeLinkObstacle(shapes_[i], arm_.radius(), 0.5 * longestLink_);
    return *obstacles_[i];
}

int DeepestOverlap::placeSome(std::size_t link, const Directions &directions)
{
    const int count = static_cast<int>(std::min<std::size_t>(boxesAtOnce, links_.size() - link));
    for (int i = 0; i < count; ++i)
    {
        place(link + i, directions);
        linkBoxes_.set(i, links_[link + i].base, links_[link + i].tip(), 0.0);
    }
    linkBoxes_.findMeetings(obstacleBoxes_, near_);
    return count;
}

template <class Visit>
bool DeepestOverlap::visitNear(std::size_t link, int i, const Visit &visit)
{
    const ObstacleBits near = near_[static_cast<std::size_t>(i)];
    if (near == 0)
        return true;
    const Bounds box = Bounds::around(links_[link].base, links_[link].tip());
    for (std::size_t first = 0; first < boxes_.size(); first += 32)
        for (ObstacleBits bits = near; bits != 0; bits &= bits - 1)
        {
            const std::size_t k = first + static_cast<std::size_t>(__builtin_ctz(bits));
            if (k < boxes_.size() && box.meets(boxes_[k]) && !visit(obstacle(k)))
                return false;
        }
    return true;
}

int DeepestOverlap::firstOverlap(const Directions &directions, double slide, std::size_t link)
{
    placeBase(slide);
    for (std::size_t t = 0; t < std::min(link, links_.size()); ++t)
        place(t, directions);
    for (std::size_t first = link; first < links_.size(); first += boxesAtOnce)
        for (int i = 0, count = placeSome(first, directions); i < count; ++i)
        {
            const Segment &it = links_[first + i];
            if (!visitNear(first + i, i, [&it](const LinkObstacle &obstacle) { return !obstacle.isMet(it); }))
                return static_cast<int>(first) + i;
        }
    return -1;
}

int DeepestOverlap::firstMet(ConfigurationRef q, int joint)
{
    direct(q, directions_[0]);
    const int offset = arm_.firstAngle();
    const int link = firstOverlap(directions_[0], q[0], static_cast<std::size_t>(std::max(joint - offset, 0)));
    return link > 0 ? link + offset : link;
}

bool DeepestOverlap::isMetBetween(ConfigurationRef q, ConfigurationRef delta, int parts)
{
    if (parts != 1 && parts != 2 && parts != 4 && parts != mostParts)
        throw std::invalid_argument("a motion is looked at in 1, 2, 4 or 8 parts");
    if (parts == 1)
        return false;
    const auto at = [this](int part) -> Directions &
    {
        return directions_[static_cast<std::size_t>(part)];
    };
    direct(q, directions_[0]);
    direct(q + delta, directions_[static_cast<std::size_t>(parts)]);
    for (int stride = parts / 2; stride > 0; stride /= 2)
        for (int i = stride; i < parts; i += 2 * stride)
        {
            const double t = double(i) / parts;
            halve(at(i - stride), at(i + stride), q, delta, t, double(stride) / parts, at(i));
            if (firstOverlap(at(i), q[0] + t * delta[0], 0) >= 0)
                return true;
        }
    return false;
}
}  // namespace narrows
