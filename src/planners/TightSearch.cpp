// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TightSearch.h"

#include <algorithm>
#include <cmath>

#include "kernel/beams/BeamPath.h"
#include "kernel/fields/CorridorClasses.h"
#include "kernel/fields/DistanceField.h"
#include "kernel/fields/FieldStreamline.h"
#include "kernel/fields/LaplaceSweeps.h"
#include "kernel/fields/ObstacleCells.h"

namespace narrows
{
namespace
{
constexpr double cellsPerLink = 12.0;
constexpr double mostCells = 2e6;   ///< of the first grid; a refined one may have eight times as many, and so on
constexpr double firstShare = 0.5;  ///< of the link length, where growing begins
constexpr double growth = 0.05;
constexpr int mostAdvances = 6;    ///< of the start along the entrance line
constexpr double mostSpare = 0.5;  ///< of a link: how much further than necessary
constexpr double leastSpare = 0.1;

/// The sides of a box, those at infinity replaced.
template <class Point>
void enclose(const Point &lower, const Point &upper, double far, Point &least, Point &most)
{
    for (Eigen::Index axis = 0; axis < least.size(); ++axis)
    {
        if (!(lower[axis] <= upper[axis]))
            continue;
        least[axis] = std::min(least[axis], std::max(lower[axis], least[axis] - far));
        most[axis] = std::max(most[axis], std::min(upper[axis], most[axis] + far));
    }
}
}  // namespace

template <int D>
TightSearch<D>::TightSearch(const ChordObstacles<D> &obstacles, const ChainSpec &spec, const TightSettings &settings,
                            const Point &start, const Point &entrance, const Point &goal)
  : obstacles_(obstacles), spec_(spec), settings_(settings), start_(start), entrance_(entrance), goal_(goal)
{
}

template <int D>
TightAttempt<D> TightSearch<D>::next(const std::function<bool()> &stop)
{
    TightAttempt<D> attempt;
    if (ways_.empty())
    {
        attempt.failure = findWays();
        done_ = !attempt.failure.empty();
        if (done_)
            return attempt;
    }
    const Way &way = ways_[way_];
    if (settings_.mode == TightMode::Middle)
        attempt = certified(way.middle);
    else if (settings_.mode == TightMode::Beams || kind_ == Start::Beams)
        attempt = tryBeams(way, stop);
    else if (kind_ == Start::Middle)
        attempt = relaxed(way, way.middle, spec_.length, 1.0, stop);
    else
        attempt = grow(way, kind_ == Start::Growing ? 1.0 : 0.5, stop);
    if (!attempt.failure.empty() && stop())
        attempt.failure = "timeout";
    else
    {
        if (attempt.failure == toText(ChainFailure::TooShort) && tooLong_.empty())
            tooLong_ = attempt.nodes;
        advance();
    }
    return attempt;
}

/// To the same try in the next corridor, then to the next kind of tries. Further corridors are looked for when the
/// cheapest one has not let the chain through at once.
template <int D>
void TightSearch<D>::advance()
{
    const bool several = settings_.mode == TightMode::Relax && settings_.field == TightField::Corridor;
    if (kind_ == Start::Beams && !searchedAll_ && several && settings_.corridors > 1)
    {
        searchedAll_ = true;
        corridorWays(grid_, clearance_, settings_.corridors);
        counts_["corridors"] = static_cast<double>(ways_.size());
        // The first one is the cheapest: it has been tried.
        kind_ = ways_.size() > 1 ? Start::Middle : Start::Beams;
        way_ = 0;
    }
    if (++way_ < ways_.size())
        return;
    way_ = 0;
    done_ = settings_.mode != TightMode::Relax || kind_ == Start::GrowingFine;
    kind_ = static_cast<Start>(static_cast<int>(kind_) + 1);
    // Relaxed paths are longer than the ways that they come from: all again, from a start that has been moved on.
    if (done_ && !tooLong_.empty() && feedStraight(tooLong_))
        restart();
}

template <int D>
void TightSearch<D>::restart()
{
    ways_.clear();
    tooLong_.clear();
    kind_ = Start::Middle;
    searchedAll_ = false;
    done_ = false;
}

template <int D>
std::string TightSearch<D>::findWays()
{
    std::string failure;
    for (int refinement = 0; refinement <= settings_.refinements && ways_.empty(); ++refinement)
    {
        VoxelGrid<D> grid;
        failure = openGrid(refinement, grid);
        if (!failure.empty())
            break;
        counts_["cells"] += grid.cells();
        std::vector<float> clearance = distanceField(grid, GridBorder::Open);
        failure = firstWay(grid, clearance);
        while (failure.empty() && feedStraight(ways_.front().middle))
            failure = firstWay(grid, clearance);
        grid_ = std::move(grid);
        clearance_ = std::move(clearance);
    }
    counts_["corridors"] = static_cast<double>(ways_.size());
    return failure;
}

template <int D>
std::string TightSearch<D>::firstWay(const VoxelGrid<D> &grid, const std::vector<float> &clearance)
{
    ways_.clear();
    return settings_.field == TightField::Corridor ? corridorWays(grid, clearance, 1) : laplaceWay(grid, clearance);
}

/// Moves the start on along the entrance line if the chain would not reach back to it from the end of a path, and if
/// there is room; says whether.
template <int D>
bool TightSearch<D>::feedStraight(const PointPath<D> &nodes)
{
    const LeaderPath<D> path(nodes, entrance_);
    const double missing = jointPlaces<D>(path, path.length(), spec_.length, spec_.links).back();
    if (missing <= 0.0 || advances_ >= mostAdvances)
        return false;
    const double room = spec_.radius + 0.1 * spec_.length;
    for (double share = mostSpare; share >= leastSpare; share *= 0.5)
    {
        const Point ahead = start_ + (missing + share * spec_.length) * entrance_;
        if (obstacles_.clearance(start_, ahead, room) < room)
            continue;
        start_ = ahead;
        ++advances_;
        return true;
    }
    return false;
}

/// A grid around obstacles, start and goal, finer and reaching further with every refinement.
template <int D>
std::string TightSearch<D>::openGrid(int refinement, VoxelGrid<D> &grid) const
{
    const double share = std::ldexp(1.0, refinement);
    Point lower = start_.cwiseMin(goal_), upper = start_.cwiseMax(goal_);
    enclose<Point>(obstacles_.lower(), obstacles_.upper(), spec_.length * spec_.links, lower, upper);
    lower.array() -= 0.25 * share * spec_.length;
    upper.array() += 0.25 * share * spec_.length;
    double spacing = settings_.spacing > 0.0 ? settings_.spacing : spec_.length / cellsPerLink;
    if (settings_.spacing == 0.0)
        spacing = std::max(spacing, std::pow((upper - lower).prod() / mostCells, 1.0 / D));
    auto made = VoxelGrid<D>::make(lower, upper, spacing / share);
    if (made.failure != GridFailure::None)
        return toText(made.failure);
    grid = std::move(made.grid);
    occupyCells(grid, obstacles_.obstacles(), std::max(spec_.radius, 0.5 * std::sqrt(D) * grid.spacing()));
    return "";
}

template <int D>
std::string TightSearch<D>::corridorWays(const VoxelGrid<D> &grid, const std::vector<float> &clearance, int count)
{
    CorridorClassOptions options;
    options.count = count;
    options.searches = 3 * count;
    options.corridor.wide = spec_.length;
    ways_.clear();
    for (const Corridor<D> &corridor : findCorridors(grid, clearance, start_, goal_, options))
    {
        if (corridor.failure != CorridorFailure::None)
            return "no_corridor";
        addWay(grid, clearance, corridor.path);
    }
    return "";
}

template <int D>
std::string TightSearch<D>::laplaceWay(const VoxelGrid<D> &grid, const std::vector<float> &clearance)
{
    const LaplaceSystem<D> system(grid);
    const LaplaceField field =
        system.failure() == LaplaceFailure::None ? system.solve(goal_) : laplaceBySweeps(grid, goal_);
    if (field.failure != LaplaceFailure::None)
        return field.failure == LaplaceFailure::GoalBlocked ? "no_corridor" : toText(field.failure);
    const Streamline<D> line = followField(grid, field.phi, start_, goal_);
    if (line.failure != StreamlineFailure::None)
        return line.failure == StreamlineFailure::StartBlocked ? "no_corridor" : toText(line.failure);
    addWay(grid, clearance, line.path);
    return "";
}

template <int D>
void TightSearch<D>::addWay(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const PointPath<D> &path)
{
    std::vector<double> room;
    for (const Point &point : path)
        if (const int cell = grid.cellAround(point); cell >= 0 && std::isfinite(clearance[cell]))
            room.push_back(clearance[cell]);
    double width = spec_.length;
    if (!room.empty())
    {
        std::nth_element(room.begin(), room.begin() + room.size() / 2, room.end());
        width = std::clamp(2.0 * room[room.size() / 2], 0.2 * spec_.length, spec_.length);
    }
    constexpr int window = 4, passes = 3;
    ways_.push_back({windowed<D>(resampled<D>(path, grid.spacing()), window, passes), width});
}

template <int D>
TightAttempt<D> TightSearch<D>::certified(const PointPath<D> &nodes)
{
    const ChainCertificate certificate = certifyChain<D>(LeaderPath<D>(nodes, entrance_), obstacles_, spec_);
    counts_["certificates"] += 1.0;
    counts_["chords"] += certificate.chords;
    return {nodes, toText(certificate.failure), certificate};
}

template <int D>
TightAttempt<D> TightSearch<D>::tryBeams(const Way &way, const std::function<bool()> &stop)
{
    BeamOptions options;
    options.fan.linkLength = spec_.length;
    options.fan.radius = spec_.radius;
    options.fan.spacing = 0.05 * way.width;
    options.fan.couples = settings_.couples;
    const auto distance = [this](const Point &point)
    {
        return obstacles_.clearance(point, 4.0 * spec_.length);
    };
    const BeamPath<D> beams = beamPath<D>(way.middle, distance, options);
    counts_["beams"] += beams.beams;
    if (beams.failure != BeamFailure::None)
        return {way.middle, toText(beams.failure), {}};
    if (settings_.mode == TightMode::Beams)
        return certified(beams.path);
    return relaxed(way, beams.path, spec_.length, 1.0, stop);
}

template <int D>
TightAttempt<D> TightSearch<D>::relaxed(const Way &way, const PointPath<D> &nodes, double length, double fineness,
                                        const std::function<bool()> &stop)
{
    RelaxationOptions options = relaxationOptions(fineness * way.width);
    options.rounds = settings_.rounds;
    ChainSpec spec = spec_;
    spec.length = length;
    spec.links = static_cast<int>(std::ceil(spec_.links * spec_.length / length));
    const RelaxedPath<D> found = relaxChords<D>(nodes, entrance_, obstacles_, spec, options, stop);
    counts_["relaxation_rounds"] += found.rounds;
    counts_["chords"] += static_cast<double>(found.chords);
    counts_["certificates"] += found.certificates;
    return {found.nodes, toText(found.certificate.failure), found.certificate};
}

/// Relaxes for shorter links first.
template <int D>
TightAttempt<D> TightSearch<D>::grow(const Way &way, double fineness, const std::function<bool()> &stop)
{
    TightAttempt<D> attempt{way.middle, "", {}};
    for (double share = firstShare; share < 1.0 && !stop(); share += growth * fineness)
        attempt = relaxed(way, attempt.nodes, share * spec_.length, fineness, stop);
    return relaxed(way, attempt.nodes, spec_.length, fineness, stop);
}

template class TightSearch<2>;
template class TightSearch<3>;
}  // namespace narrows
