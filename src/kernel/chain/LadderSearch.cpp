// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/LadderSearch.h"

#include <deque>
#include <stdexcept>
#include <unordered_map>

#include "kernel/chain/LadderArcs.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector2i;

void check(const LadderTask &task, const LadderSearchOptions &options)
{
    const bool finite = task.entrance.allFinite() && task.direction.allFinite() && task.goal.allFinite() &&
                        task.lower.allFinite() && task.upper.allFinite();
    if (!finite || !(task.length > 0.0) || !(task.radius >= 0.0) || !(task.tolerance >= 0.0) ||
        task.direction.isZero(0.0) || !(task.lower.array() < task.upper.array()).all())
        throw std::invalid_argument("ladder: the task is out of range");
    if (!(options.spacing > 0.0) || !(options.finestAngle > 0.0) || options.links < 1 || options.links > 2 ||
        options.maxNodes < 1)
        throw std::invalid_argument("ladder: the options are out of range");
}

/// The graph of arcs, made as far as it is reached.
class ArcGraph
{
public:
    ArcGraph(const LadderTask &task, const LadderArcs::Distance &distance, const LadderSearchOptions &options)
      : task_(task),
        options_(options),
        arcs_(distance, task.length, task.radius, options.spacing, options.finestAngle),
        counts_(((task.upper - task.lower) / options.spacing).array().ceil().cast<int>().max(1))
    {
    }

    LadderSearch search()
    {
        LadderSearch result;
        result.verdict = explore();
        result.cells = static_cast<long>(cells_.size());
        result.nodes = nodes_;
        result.rays = arcs_.rays();
        return result;
    }

private:
    /// Arcs of the link behind and of the link ahead. Without a link behind, that is arc 0 of one.
    struct Node
    {
        Vector2i place;
        int behind;
        int ahead;
    };
    struct Cell
    {
        std::vector<LadderArc> arcs;
        std::vector<char> reached;  ///< by behind * arcs.size() + ahead
    };

    Vector2d centerOf(const Vector2i &place) const
    {
        return task_.lower + options_.spacing * (place.cast<double>().array() + 0.5).matrix();
    }
    bool contains(const Vector2i &place) const
    {
        return (place.array() >= 0).all() && (place.array() < counts_.array()).all();
    }

    Cell &cellAt(const Vector2i &place)
    {
        const auto [entry, isNew] = cells_.try_emplace(place.y() * static_cast<long>(counts_.x()) + place.x());
        if (isNew)
        {
            entry->second.arcs = arcs_.around(centerOf(place));
            entry->second.reached.assign(entry->second.arcs.size() * entry->second.arcs.size(), 0);
        }
        return entry->second;
    }

    void reach(const Vector2i &place, int behind, int ahead)
    {
        Cell &cell = cellAt(place);
        char &reached = cell.reached[behind * cell.arcs.size() + ahead];
        if (reached != 0)
            return;
        reached = 1;
        ++nodes_;
        open_.push_back({place, behind, ahead});
    }

    LadderVerdict explore()
    {
        const Vector2i first = ((task_.entrance - task_.lower) / options_.spacing).array().floor().cast<int>();
        if (!contains(first) || !begin(first))
            return LadderVerdict::StartBlocked;
        while (!open_.empty())
        {
            const Node node = open_.front();
            open_.pop_front();
            if (isGoal(node))
                return LadderVerdict::Open;
            if (nodes_ > options_.maxNodes)
                return LadderVerdict::TooManyNodes;
            for (const Vector2i &step : {Vector2i(1, 0), Vector2i(-1, 0), Vector2i(0, 1), Vector2i(0, -1)})
                if (contains(node.place + step))
                    enter(node, node.place + step);
        }
        return LadderVerdict::Excluded;
    }

    /// The joint at the entrance: the link behind it lies on the entrance line, the one ahead has any direction.
    bool begin(const Vector2i &place)
    {
        const std::vector<LadderArc> arcs = cellAt(place).arcs;
        const double back = std::atan2(-task_.direction.y(), -task_.direction.x());
        for (int behind = 0; behind < static_cast<int>(arcs.size()); ++behind)
            if (arcs[behind].contains(back))
                for (int ahead = 0; ahead < (options_.links == 2 ? static_cast<int>(arcs.size()) : 1); ++ahead)
                    reach(place, behind, ahead);
        return !open_.empty();
    }

    void enter(const Node &node, const Vector2i &place)
    {
        const std::vector<LadderArc> &next = cellAt(place).arcs;
        const std::vector<LadderArc> &here = cellAt(node.place).arcs;
        for (int behind = 0; behind < static_cast<int>(next.size()); ++behind)
        {
            if (!next[behind].meets(here[node.behind]))
                continue;
            if (options_.links == 1)
            {
                reach(place, behind, 0);
                continue;
            }
            for (int ahead = 0; ahead < static_cast<int>(next.size()); ++ahead)
                if (next[ahead].meets(here[node.ahead]))
                    reach(place, behind, ahead);
        }
    }

    /// Whether the tip may be at the goal: the joint itself with one link, the end of the link ahead with two.
    bool isGoal(const Node &node)
    {
        const Vector2d center = centerOf(node.place), toGoal = task_.goal - center;
        const double slack = task_.tolerance + 0.70710678118654757 * options_.spacing;
        if (options_.links == 1)
            return toGoal.norm() <= slack;
        if (std::abs(toGoal.norm() - task_.length) > slack)
            return false;
        const double angle = std::atan2(toGoal.y(), toGoal.x());
        // Directions that come within the slack of the goal are no further from it than this.
        const double wide = slack >= toGoal.norm() ? M_PI : std::asin(slack / toGoal.norm());
        return cellAt(node.place).arcs[node.ahead].meets({angle - wide, angle + wide});
    }

    const LadderTask &task_;
    const LadderSearchOptions &options_;
    LadderArcs arcs_;
    Vector2i counts_;
    std::unordered_map<long, Cell> cells_;
    std::deque<Node> open_;
    long nodes_ = 0;
};
}  // namespace

std::string toText(LadderVerdict verdict)
{
    switch (verdict)
    {
        case LadderVerdict::Excluded:
            return "excluded";
        case LadderVerdict::Open:
            return "open";
        case LadderVerdict::StartBlocked:
            return "start_blocked";
        case LadderVerdict::TooManyNodes:
            return "too_many_nodes";
    }
    return "unknown";
}

LadderSearch excludeLadder(const LadderTask &task, const std::function<double(const Vector2d &)> &distance,
                           const LadderSearchOptions &options)
{
    check(task, options);
    return ArcGraph(task, distance, options).search();
}
}  // namespace narrows
