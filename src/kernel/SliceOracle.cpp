// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SliceOracle.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>
#include <utility>

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Points of the slice and which of them are neighbours: a grid, and rings about the ends that reach from a tenth of
/// the grid's spacing down to nothing.
class SliceGraph
{
public:
    SliceGraph(const HomotopyCurve &slice, const SliceWindow &window) : window_(window)
    {
        const double scale = slice.lambdaScale();
        lower_ = {-window.deviation, window.lambdaMin * scale};
        cell_ = {2.0 * window.deviation / (window.rows - 1),
                 (window.lambdaMax - window.lambdaMin) * scale / (window.columns - 1)};
        for (int row = 0; row < window.rows; ++row)
            for (int column = 0; column < window.columns; ++column)
                add(lower_ + Vector2d(row * cell_.x(), column * cell_.y()));
        for (int row = 0; row < window.rows; ++row)
            for (int column = 0; column < window.columns; ++column)
                joinGrid(row, column);
        start_ = addEnd(Vector2d::Zero());
        goal_ = addEnd({0.0, scale});
        join(start_, goal_);
    }

    int start() const { return start_; }
    int goal() const { return goal_; }
    const std::vector<Vector2d> &points() const { return points_; }
    const std::vector<int> &neighbours(int point) const { return neighbours_[static_cast<std::size_t>(point)]; }
    double spacing() const { return cell_.norm(); }

private:
    int add(const Vector2d &point)
    {
        points_.push_back(point);
        neighbours_.emplace_back();
        return static_cast<int>(points_.size()) - 1;
    }

    void join(int a, int b)
    {
        neighbours_[static_cast<std::size_t>(a)].push_back(b);
        neighbours_[static_cast<std::size_t>(b)].push_back(a);
    }

    int gridPoint(int row, int column) const { return row * window_.columns + column; }

    void joinGrid(int row, int column)
    {
        const bool below = row + 1 < window_.rows, beside = column + 1 < window_.columns;
        if (below)
            join(gridPoint(row, column), gridPoint(row + 1, column));
        if (beside)
            join(gridPoint(row, column), gridPoint(row, column + 1));
        if (below && beside)
            join(gridPoint(row, column), gridPoint(row + 1, column + 1));
        if (below && column > 0)
            join(gridPoint(row, column), gridPoint(row + 1, column - 1));
    }

    int addEnd(const Vector2d &end)
    {
        constexpr double fullTurn = 2.0 * 3.14159265358979323846;
        const int center = add(end);
        joinToGrid(center);
        double radius = 2.0 * cell_.maxCoeff();
        std::vector<int> outer;
        for (int ring = 0; ring < window_.rings; ++ring, radius *= 0.5)
        {
            std::vector<int> inner;
            for (int spoke = 0; spoke < window_.spokes; ++spoke)
            {
                const double angle = fullTurn * spoke / window_.spokes;
                inner.push_back(add(end + radius * Vector2d(std::cos(angle), std::sin(angle))));
                join(inner.back(), center);
                if (ring == 0)
                    joinToGrid(inner.back());
            }
            joinRings(outer, inner);
            outer = std::move(inner);
        }
        return center;
    }

    void joinRings(const std::vector<int> &outer, const std::vector<int> &inner)
    {
        const std::size_t count = inner.size();
        for (std::size_t i = 0; i < count; ++i)
        {
            join(inner[i], inner[(i + 1) % count]);
            for (const std::size_t j : {i, (i + 1) % count, (i + count - 1) % count})
                if (!outer.empty())
                    join(inner[i], outer[j]);
        }
    }

    /// The grid's points about this one.
    void joinToGrid(int point)
    {
        const Vector2d place = (points_[static_cast<std::size_t>(point)] - lower_).cwiseQuotient(cell_);
        const int row = static_cast<int>(std::floor(place.x())), column = static_cast<int>(std::floor(place.y()));
        for (int i = row - 1; i <= row + 2; ++i)
            for (int j = column - 1; j <= column + 2; ++j)
                if (i >= 0 && j >= 0 && i < window_.rows && j < window_.columns)
                    join(point, gridPoint(i, j));
    }

    SliceWindow window_;
    Vector2d lower_, cell_;
    std::vector<Vector2d> points_;
    std::vector<std::vector<int>> neighbours_;
    int start_, goal_;
};

void check(const HomotopyCurve &slice, const SliceWindow &window)
{
    if (slice.equations() != 1)
        throw std::invalid_argument("only slices of two dimensions can be explored");
    if (!(window.lambdaMin < 0.0 && window.lambdaMax > 1.0 && window.deviation > 0.0))
        throw std::invalid_argument("the window must hold start and goal");
    if (window.columns < 2 || window.rows < 2 || window.rings < 0 || window.spokes < 3)
        throw std::invalid_argument("the grid must have two rows and columns, rings three spokes");
}
}  // namespace

SliceAnswer exploreSlice(const HomotopyCurve &slice, const std::function<double(const VectorXd &)> &clearance,
                         const std::function<bool(const VectorXd &, const VectorXd &)> &isFree,
                         const SliceWindow &window)
{
    check(slice, window);
    const SliceGraph graph(slice, window);
    const std::size_t count = graph.points().size();
    std::vector<VectorXd> configurations(count);
    std::vector<double> clearances(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        slice.configuration(graph.points()[i], configurations[i]);
        clearances[i] = clearance(configurations[i]);
    }

    SliceAnswer answer;
    answer.spacing = graph.spacing();
    // Dijkstra's algorithm for the widest way: points are settled in the order of the least clearance on the way there.
    std::vector<double> widest(count, 0.0);
    std::vector<int> before(count, -1);
    std::vector<char> settled(count, 0);
    std::priority_queue<std::pair<double, int>> open;
    widest[graph.start()] = clearances[graph.start()];
    if (widest[graph.start()] > 0.0)
        open.emplace(widest[graph.start()], graph.start());
    while (!open.empty() && !settled[graph.goal()])
    {
        const int here = open.top().second;
        open.pop();
        if (settled[here])
            continue;
        settled[here] = 1;
        for (const int next : graph.neighbours(here))
        {
            const double width = std::min(widest[here], clearances[next]);
            if (settled[next] || !(width > widest[next]) || !isFree(configurations[here], configurations[next]))
                continue;
            widest[next] = width;
            before[next] = here;
            open.emplace(width, next);
        }
    }
    answer.joins = settled[graph.goal()] != 0;
    if (!answer.joins)
        return answer;
    answer.bottleneck = widest[graph.goal()];
    for (int point = graph.goal(); point >= 0; point = before[point])
        answer.path.push_back(graph.points()[point]);
    std::reverse(answer.path.begin(), answer.path.end());
    return answer;
}
}  // namespace narrows
