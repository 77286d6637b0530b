// SPDX-License-Identifier: BSD-3-Clause
// The brute-force second way to know whether there is a path: all of the joint space in cells, each proven blocked or
// proven free by geometry of its own, or left open. For planar chains of circles, superellipses and polygons in at most
// three joints that turn freely, or slide.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "kernel/PlanarModel.h"
#include "kernel/SegmentDistance.h"

namespace narrows
{
/// How far a point is outside of a shape, at least; or, negative, how deep inside, at least.
struct SignedDistance
{
    const Eigen::Vector2d &point;

    double operator()(const Circle &circle) const { return (point - circle.center).norm() - circle.radius; }

    /// f, the p-norm of (x / a, y / b), grows by no more than the way over min(a, b), since p >= 2.
    double operator()(const Superellipse &shape) const
    {
        const Eigen::Array2d scaled = ((point - shape.center).array() / shape.halfExtents.array()).abs();
        const double f = std::pow(scaled.pow(shape.exponent).sum(), 1.0 / shape.exponent);
        return (f - 1.0) * shape.halfExtents.minCoeff();
    }

    double operator()(const Polygon &polygon) const
    {
        double squared = std::numeric_limits<double>::infinity();
        bool inside = false;
        const auto &v = polygon.vertices;
        for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++)
        {
            squared = std::min(squared, squaredDistance(v[j], v[i], point));
            if ((v[i].y() > point.y()) != (v[j].y() > point.y()) &&
                point.x() < v[i].x() + (point.y() - v[i].y()) / (v[j].y() - v[i].y()) * (v[j].x() - v[i].x()))
                inside = !inside;
        }
        return inside ? -std::sqrt(squared) : std::sqrt(squared);
    }
};

class JointCells
{
public:
    enum class Cell : std::uint8_t
    {
        Open,
        Blocked,  ///< every configuration in it is in collision
        Free      ///< none is
    };

    /// \param counts of cells along each joint; angles go all the way round
    /// \param looks at points of each link; with more of them more cells are found free
    JointCells(const PlanarModel &model, std::vector<int> counts, int looks = 40)
      : model_(model), counts_(std::move(counts)), looks_(looks)
    {
        std::size_t cells = 1;
        for (const int count : counts_)
            cells *= static_cast<std::size_t>(count);
        kinds_.resize(cells);
        for (std::size_t i = 0; i < cells; ++i)
            kinds_[i] = judge(i);
    }

    Cell at(const Eigen::VectorXd &q) const { return kinds_[indexOf(q)]; }

    /// Whether cells that are not blocked join the two: if they do not, there is no path.
    bool mayJoin(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const
    {
        return joins(from, to, [](Cell cell) { return cell != Cell::Blocked; });
    }

    /// Whether free cells join the two: if they do, there is a path.
    bool join(const Eigen::VectorXd &from, const Eigen::VectorXd &to) const
    {
        return joins(from, to, [](Cell cell) { return cell == Cell::Free; });
    }

private:
    bool slides(std::size_t joint) const { return joint == 0 && model_.arm.slide().has_value(); }
    double lower(std::size_t joint) const { return slides(joint) ? model_.arm.slide()->lower : 0.0; }
    double width(std::size_t joint) const
    {
        const double whole = slides(joint) ? model_.arm.slide()->upper - model_.arm.slide()->lower : 2.0 * M_PI;
        return whole / counts_[joint];
    }

    std::size_t indexOf(const Eigen::VectorXd &q) const
    {
        std::size_t index = 0;
        for (std::size_t joint = 0; joint < counts_.size(); ++joint)
        {
            int place = static_cast<int>(std::floor((q[static_cast<int>(joint)] - lower(joint)) / width(joint)));
            if (slides(joint))
                place = std::min(place, counts_[joint] - 1);  // the upper limit belongs to the last cell
            else
                place = ((place % counts_[joint]) + counts_[joint]) % counts_[joint];
            index = index * static_cast<std::size_t>(counts_[joint]) + static_cast<std::size_t>(place);
        }
        return index;
    }

    std::vector<int> placesOf(std::size_t index) const
    {
        std::vector<int> places(counts_.size());
        for (std::size_t joint = counts_.size(); joint-- > 0; index /= static_cast<std::size_t>(counts_[joint]))
            places[joint] = static_cast<int>(index % static_cast<std::size_t>(counts_[joint]));
        return places;
    }

    /// From points on the links: within a cell each is no farther from where it is in the middle than the joints before
    /// it can carry it, and no point of a link is farther than half a step from one of them.
    Cell judge(std::size_t index) const
    {
        const std::vector<int> places = placesOf(index);
        Eigen::VectorXd q(static_cast<Eigen::Index>(places.size()));
        for (std::size_t joint = 0; joint < places.size(); ++joint)
            q[static_cast<int>(joint)] = lower(joint) + (places[joint] + 0.5) * width(joint);
        const int first = model_.arm.firstAngle();
        Eigen::Vector2d begin = model_.arm.base();
        double carried = first == 1 ? 0.5 * width(0) : 0.0;
        if (first == 1)
            begin += q[0] * model_.arm.slide()->axis;
        bool free = true;
        for (int link = 0; link < model_.arm.linkCount(); ++link)
        {
            const double length = model_.arm.links()[static_cast<std::size_t>(link)].length;
            const double angle = q[first + link];
            const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
            const double turned = 0.5 * width(static_cast<std::size_t>(first + link)) * length;
            for (int i = 0; i <= looks_; ++i)
            {
                const double share = static_cast<double>(i) / looks_;
                const double distance = distanceOf(begin + share * length * along) - model_.arm.radius();
                if (distance < -(carried + share * turned))
                    return Cell::Blocked;
                free = free && distance > carried + share * turned + 0.5 * length / looks_;
            }
            begin += length * along;
            carried += turned;
        }
        return free ? Cell::Free : Cell::Open;
    }

    double distanceOf(const Eigen::Vector2d &point) const
    {
        double distance = std::numeric_limits<double>::infinity();
        for (const PlanarObstacle &obstacle : model_.obstacles)
            distance = std::min(distance, std::visit(SignedDistance{point}, obstacle.shape));
        return distance;
    }

    template <class Passable>
    bool joins(const Eigen::VectorXd &from, const Eigen::VectorXd &to, Passable passable) const
    {
        std::vector<bool> reached(kinds_.size());
        std::deque<std::size_t> open{indexOf(from)};
        const std::size_t target = indexOf(to);
        if (!passable(kinds_[open.front()]) || !passable(kinds_[target]))
            return false;
        reached[open.front()] = true;
        while (!open.empty() && !reached[target])
        {
            const std::size_t index = open.front();
            open.pop_front();
            for (const std::size_t next : neighbours(index))
                if (!reached[next] && passable(kinds_[next]))
                {
                    reached[next] = true;
                    open.push_back(next);
                }
        }
        return reached[target];
    }

    /// Those that share a face: a path through an edge or a corner comes as near as one likes to one through faces of
    /// cells that it touches, which are not blocked either.
    std::vector<std::size_t> neighbours(std::size_t index) const
    {
        std::vector<std::size_t> all;
        std::size_t stride = 1;
        const std::vector<int> places = placesOf(index);
        for (std::size_t joint = counts_.size(); joint-- > 0; stride *= static_cast<std::size_t>(counts_[joint]))
            for (const int step : {-1, 1})
            {
                const int place = places[joint] + step;
                const int wrapped = (place + counts_[joint]) % counts_[joint];
                if (place == wrapped || !slides(joint))
                    all.push_back(index + static_cast<std::size_t>(wrapped) * stride -
                                  static_cast<std::size_t>(places[joint]) * stride);
            }
        return all;
    }

    const PlanarModel &model_;
    std::vector<int> counts_;
    int looks_;
    std::vector<Cell> kinds_;
};
}  // namespace narrows
