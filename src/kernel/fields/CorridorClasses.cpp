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
class CorridorClasses<D>::State
{
public:
    State(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const Point &start, const Point &goal,
          const CorridorOptions &options, double factor)
      : grid_(grid),
        clearance_(clearance),
        start_(start),
        goal_(goal),
        options_(options),
        factor_(factor),
        surcharge_(grid.cells(), 1.0F)
    {
    }

    Corridor<D> first(const std::function<bool()> &stop)
    {
        last_ = search(stop);
        return last_;
    }

    /// What the next search finds, if its kind is new.
    std::optional<Corridor<D>> another(const std::function<bool()> &stop)
    {
        if (last_.failure != CorridorFailure::None)
            return std::nullopt;
        if (!kinds_)
            kinds_.emplace(grid_).isNew(last_);
        if (!charged_)
            charge(grid_, clearance_, last_, factor_, surcharge_);
        charged_ = true;
        Corridor<D> found = search(stop);
        if (found.failure == CorridorFailure::Stopped)
            return found;
        charged_ = false;
        last_ = found;
        if (!kinds_->isNew(found))
            return std::nullopt;
        found.cost = costOf(grid_, clearance_, options_, found.cells);
        return found;
    }

private:
    Corridor<D> search(const std::function<bool()> &stop)
    {
        options_.stop = stop;
        return findCorridor(grid_, clearance_, start_, goal_, options_, surcharge_);
    }

    const VoxelGrid<D> &grid_;
    const std::vector<float> &clearance_;
    Point start_, goal_;
    CorridorOptions options_;
    double factor_;
    std::vector<float> surcharge_;
    Corridor<D> last_;
    bool charged_ = false;           ///< for the path found last, by a search that was stopped
    std::optional<Kinds<D>> kinds_;  ///< prepared only if there is a second search
};

template <int D>
CorridorClasses<D>::CorridorClasses(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const Point &start,
                                    const Point &goal, const CorridorOptions &options, double surcharge)
  : state_(std::make_unique<State>(grid, clearance, start, goal, options, surcharge))
{
    if (!(surcharge > 1.0))
        throw std::invalid_argument("CorridorClasses: a surcharge > 1 is needed");
}

template <int D>
CorridorClasses<D>::~CorridorClasses() = default;

template <int D>
std::optional<Corridor<D>> CorridorClasses<D>::next(int searches, const std::function<bool()> &stop)
{
    for (int search = 0; search < searches; ++search)
    {
        const std::optional<Corridor<D>> found = searches_ == 0 ? state_->first(stop) : state_->another(stop);
        if (!found || found->failure != CorridorFailure::Stopped)
            ++searches_;
        if (found)
            return found;
    }
    return std::nullopt;
}

template <int D>
std::vector<Corridor<D>> findCorridors(const VoxelGrid<D> &grid, const std::vector<float> &clearance,
                                       const Eigen::Matrix<double, D, 1> &start,
                                       const Eigen::Matrix<double, D, 1> &goal, const CorridorClassOptions &options)
{
    if (options.count < 1 || options.searches < options.count || !(options.surcharge > 1.0))
        throw std::invalid_argument("findCorridors: count >= 1, searches >= count and surcharge > 1 are needed");
    CorridorClasses<D> classes(grid, clearance, start, goal, options.corridor, options.surcharge);
    std::vector<Corridor<D>> found{*classes.next(1)};
    const bool failed = found[0].failure != CorridorFailure::None;
    while (!failed && static_cast<int>(found.size()) < options.count && classes.searches() < options.searches)
        if (const std::optional<Corridor<D>> next = classes.next(options.searches - classes.searches()))
            found.push_back(*next);
    std::stable_sort(found.begin(), found.end(),
                     [](const Corridor<D> &a, const Corridor<D> &b) { return a.cost < b.cost; });
    return found;
}

template class CorridorClasses<2>;
template class CorridorClasses<3>;
template std::vector<Corridor<2>> findCorridors(const VoxelGrid<2> &, const std::vector<float> &,
                                                const Eigen::Vector2d &, const Eigen::Vector2d &,
                                                const CorridorClassOptions &);
template std::vector<Corridor<3>> findCorridors(const VoxelGrid<3> &, const std::vector<float> &,
                                                const Eigen::Vector3d &, const Eigen::Vector3d &,
                                                const CorridorClassOptions &);
}  // namespace narrows
