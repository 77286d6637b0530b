// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/fields/CorridorClasses.h"

#include <stdexcept>

#include "kernel/fields/DistanceField.h"
#include "kernel/fields/HomotopyWords.h"
#include "kernel/fields/PathWindow.h"

namespace narrows
{
namespace
{
/// Whether all points of a segment that are half a cell apart are in free cells.
template <int D>
bool seesThrough(const VoxelGrid<D> &grid, const Eigen::Matrix<double, D, 1> &from,
                 const Eigen::Matrix<double, D, 1> &to)
{
    const int pieces = static_cast<int>(std::ceil(2.0 * (to - from).norm() / grid.spacing())) + 1;
    for (int i = 0; i <= pieces; ++i)
    {
        const int cell = grid.cellAround(from + static_cast<double>(i) / pieces * (to - from));
        if (cell < 0 || grid.occupied(cell))
            return false;
    }
    return true;
}

/// Knows the kinds seen so far.
template <int D>
class Kinds;

template <>
class Kinds<2>
{
public:
    explicit Kinds(const VoxelGrid<2> &grid) : words_(grid) {}

    bool isNew(const Corridor<2> &corridor)
    {
        std::vector<int> word = words_.word(corridor.cells);
        if (std::find(seen_.begin(), seen_.end(), word) != seen_.end())
            return false;
        seen_.push_back(std::move(word));
        return true;
    }

private:
    HomotopyWords words_;
    std::vector<std::vector<int>> seen_;
};

template <>
class Kinds<3>
{
public:
    explicit Kinds(const VoxelGrid<3> &grid) : grid_(grid) {}

    bool isNew(const Corridor<3> &corridor)
    {
        if (std::any_of(seen_.begin(), seen_.end(),
                        [&](const PointPath<3> &other) { return movesInto(other, corridor.path); }))
            return false;
        seen_.push_back(corridor.path);
        return true;
    }

private:
    /// Whether two points can go along the paths, each only forwards, and see each other all the time.
    bool movesInto(const PointPath<3> &a, const PointPath<3> &b) const
    {
        const PointPath<3> first = resampled<3>(a, 2.0 * grid_.spacing());
        const PointPath<3> second = resampled<3>(b, 2.0 * grid_.spacing());
        // Where on `second` the other point may be, for one point of `first` after the other.
        std::vector<char> before(second.size(), 0), here(second.size(), 0);
        for (std::size_t i = 0; i < first.size(); ++i)
        {
            for (std::size_t j = 0; j < second.size(); ++j)
            {
                const bool begins = i == 0 && j == 0;
                const bool comes = before[j] || (j > 0 && (before[j - 1] || here[j - 1]));
                here[j] = (begins || comes) && seesThrough<3>(grid_, first[i], second[j]) ? 1 : 0;
            }
            before.swap(here);
        }
        return before.back() != 0;
    }

    const VoxelGrid<3> &grid_;
    std::vector<PointPath<3>> seen_;
};

/// Makes length dearer around a path.
template <int D>
void charge(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const Corridor<D> &corridor, double factor,
            std::vector<float> &surcharge)
{
    VoxelGrid<D> trail = grid;
    trail.clear();
    for (int cell : corridor.cells)
        trail.occupy(cell);
    const std::vector<float> away = distanceField(trail, GridBorder::Open);
    for (std::size_t i = 0; i < away.size(); ++i)
        if (away[i] <= 3.0F * clearance[i])
            surcharge[i] *= static_cast<float>(factor);
}

/// What a path costs without surcharge.
template <int D>
double costOf(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const CorridorOptions &options,
              const std::vector<int> &cells)
{
    const CorridorCost cost(grid, clearance, options);
    double sum = 0.0;
    for (std::size_t i = 1; i < cells.size(); ++i)
        sum += 0.5 * (grid.center(cells[i]) - grid.center(cells[i - 1])).norm() * (cost(cells[i]) + cost(cells[i - 1]));
    return sum;
}
}  // namespace

template <int D>
std::vector<Corridor<D>> findCorridors(const VoxelGrid<D> &grid, const std::vector<float> &clearance,
                                       const Eigen::Matrix<double, D, 1> &start,
                                       const Eigen::Matrix<double, D, 1> &goal, const CorridorClassOptions &options)
{
    if (options.count < 1 || options.searches < options.count || !(options.surcharge > 1.0))
        throw std::invalid_argument("findCorridors: count >= 1, searches >= count and surcharge > 1 are needed");
    std::vector<Corridor<D>> found{findCorridor(grid, clearance, start, goal, options.corridor)};
    if (found[0].failure != CorridorFailure::None || options.count == 1)
        return found;

    Kinds<D> kinds(grid);
    kinds.isNew(found[0]);
    std::vector<float> surcharge(grid.cells(), 1.0F);
    Corridor<D> last = found[0];
    for (int search = 1; search < options.searches && static_cast<int>(found.size()) < options.count; ++search)
    {
        charge(grid, clearance, last, options.surcharge, surcharge);
        last = findCorridor(grid, clearance, start, goal, options.corridor, surcharge);
        if (!kinds.isNew(last))
            continue;
        found.push_back(last);
        found.back().cost = costOf(grid, clearance, options.corridor, last.cells);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Corridor<D> &a, const Corridor<D> &b) { return a.cost < b.cost; });
    return found;
}

template std::vector<Corridor<2>> findCorridors(const VoxelGrid<2> &, const std::vector<float> &,
                                                const Eigen::Vector2d &, const Eigen::Vector2d &,
                                                const CorridorClassOptions &);
template std::vector<Corridor<3>> findCorridors(const VoxelGrid<3> &, const std::vector<float> &,
                                                const Eigen::Vector3d &, const Eigen::Vector3d &,
                                                const CorridorClassOptions &);
}  // namespace narrows
