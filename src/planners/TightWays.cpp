// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TightWays.h"

#include <algorithm>
#include <cmath>

#include "kernel/fields/DistanceField.h"
#include "kernel/fields/FieldStreamline.h"
#include "kernel/fields/LaplaceSweeps.h"
#include "kernel/fields/ObstacleCells.h"

namespace narrows
{
namespace
{
constexpr double cellsPerLink[] = {40.0, 12.0};  ///< in the plane, in space
constexpr double mostCells = 2e6;   ///< of the first grid; a refined one may have eight times as many, and so on
constexpr double wideEnough = 2.0;  ///< cells, clearance below which a finer grid may show other ways
constexpr double finest = 0.3;      ///< of the first spacing
constexpr double worthRefining = 0.8;
constexpr int vainSearches = 6;  ///< for further corridors
constexpr double surcharge = 4.0;

/// Spacing at which a box has so many cells.
template <int D>
double spacingOf(const Eigen::AlignedBox<double, D> &extent, double cells)
{
    return std::pow(extent.volume() / cells, 1.0 / D);
}
}  // namespace

template <int D>
TightWays<D>::TightWays(const ChordObstacles<D> &obstacles, const ChainSpec &spec, const TightGrid &settings)
  : obstacles_(obstacles), spec_(spec), settings_(settings), start_(Point::Zero()), goal_(Point::Zero())
{
}

template <int D>
std::string TightWays<D>::findFirst(const Point &start, const Point &goal)
{
    start_ = start;
    goal_ = goal;
    ways_.clear();
    refined_ = false;
    vain_ = 0;
    std::string failure;
    for (int refinement = 0; refinement <= settings_.refinements && ways_.empty(); ++refinement)
    {
        const double share = std::ldexp(1.0, refinement);
        const AlignedBox room = extent(share);
        const double spacing = settings_.spacing > 0.0
                                   ? settings_.spacing
                                   : std::max(spec_.length / cellsPerLink[D - 2], spacingOf<D>(room, mostCells));
        failure = open(room, spacing / share);
        if (!failure.empty())
            return failure;
        failure = settings_.field == TightField::Corridor ? corridor() : laplace();
    }
    return failure;
}

template <int D>
bool TightWays<D>::hasMore() const
{
    return settings_.field == TightField::Corridor && static_cast<int>(ways_.size()) < settings_.corridors &&
           vain_ < vainSearches;
}

template <int D>
bool TightWays<D>::findAnother(const std::function<bool()> &stop)
{
    if (!refined_)
        refine();
    refined_ = true;
    while (hasMore() && !stop())
    {
        const std::string failure = corridor(stop);
        if (failure == "timeout")
            return false;
        vain_ = failure.empty() ? 0 : vain_ + 1;
        if (failure.empty())
            return true;
    }
    return false;
}

/// Begins again on a finer grid, if that is of use and there may be so many cells.
template <int D>
void TightWays<D>::refine()
{
    const AlignedBox room = extent(1.0);
    const double now = grid_.spacing(), finer = std::max(finest * now, spacingOf<D>(room, mostCells));
    if (narrowest_ < wideEnough * now && finer < worthRefining * now)
        open(room, finer);
}

/// Around obstacles, start and goal, and a quarter of a link beyond them.
/// \param share of that quarter
template <int D>
typename TightWays<D>::AlignedBox TightWays<D>::extent(double share) const
{
    Point lower = start_.cwiseMin(goal_), upper = start_.cwiseMax(goal_);
    // Obstacles that go on for ever count as far as the chain reaches.
    const double far = spec_.length * spec_.links;
    for (int axis = 0; axis < D; ++axis)
        if (obstacles_.lower()[axis] <= obstacles_.upper()[axis])
        {
            lower[axis] = std::min(lower[axis], std::max(obstacles_.lower()[axis], lower[axis] - far));
            upper[axis] = std::max(upper[axis], std::min(obstacles_.upper()[axis], upper[axis] + far));
        }
    const double beyond = 0.25 * share * spec_.length;
    return {Point(lower.array() - beyond), Point(upper.array() + beyond)};
}

template <int D>
std::string TightWays<D>::open(const AlignedBox &extent, double spacing)
{
    auto made = VoxelGrid<D>::make(extent.min(), extent.max(), spacing);
    if (made.failure != GridFailure::None)
        return toText(made.failure);
    classes_.reset();
    grid_ = std::move(made.grid);
    occupyCells(grid_, obstacles_.obstacles(), std::max(spec_.radius, 0.5 * std::sqrt(D) * grid_.spacing()));
    clearance_ = distanceField(grid_, GridBorder::Open);
    counts_["cells"] += grid_.cells();
    return "";
}

/// The next kind of corridor; "timeout" if the search for it was stopped, and comes again.
template <int D>
std::string TightWays<D>::corridor(const std::function<bool()> &stop)
{
    CorridorOptions options;
    options.wide = spec_.length;
    if (!classes_)
        classes_ = std::make_unique<CorridorClasses<D>>(grid_, clearance_, start_, goal_, options, surcharge);
    const std::optional<Corridor<D>> found = classes_->next(1, stop);
    if (found && found->failure == CorridorFailure::Stopped)
        return "timeout";
    if (!found || found->failure != CorridorFailure::None)
        return "no_corridor";
    if (ways_.empty())
        narrowest_ = found->clearance;
    add(found->path);
    return "";
}

template <int D>
std::string TightWays<D>::laplace()
{
    const LaplaceSystem<D> system(grid_);
    const LaplaceField field =
        system.failure() == LaplaceFailure::None ? system.solve(goal_) : laplaceBySweeps(grid_, goal_);
    if (field.failure != LaplaceFailure::None)
        return field.failure == LaplaceFailure::GoalBlocked ? "no_corridor" : toText(field.failure);
    const Streamline<D> line = followField(grid_, field.phi, start_, goal_);
    if (line.failure != StreamlineFailure::None)
        return line.failure == StreamlineFailure::StartBlocked ? "no_corridor" : toText(line.failure);
    add(line.path);
    return "";
}

template <int D>
void TightWays<D>::add(const PointPath<D> &path)
{
    std::vector<double> room;
    for (const Point &point : path)
        if (const int cell = grid_.cellAround(point); cell >= 0 && std::isfinite(clearance_[cell]))
            room.push_back(clearance_[cell]);
    double width = spec_.length;
    if (!room.empty())
    {
        std::nth_element(room.begin(), room.begin() + room.size() / 2, room.end());
        width = std::clamp(2.0 * room[room.size() / 2], 0.2 * spec_.length, spec_.length);
    }
    constexpr double window = 0.5;  // of the width
    constexpr int passes = 3;
    ways_.push_back({windowedOver<D>(resampled<D>(path, grid_.spacing()), window * width, passes), width});
    counts_["corridors"] = static_cast<double>(ways_.size());
}

template class TightWays<2>;
template class TightWays<3>;
}  // namespace narrows
