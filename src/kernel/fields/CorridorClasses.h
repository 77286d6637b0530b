// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "kernel/fields/CorridorPath.h"

namespace narrows
{
/// How many corridors, and which.
struct CorridorClassOptions
{
    CorridorOptions corridor;  ///< how each is found
    int count = 3;             ///< >= 1, how many at most
    int searches = 12;         ///< >= count, how many searches at most
    double surcharge = 4.0;    ///< > 1, what length costs more after each search, where it went
};

/// Ways to the goal that go different ways around things, one after the other. A planner may find that a chain fits
/// through another one than the cheapest.
///
/// Where a path was found, passing gets dearer (every cell that is no further from it than three times its clearance),
/// and the search is repeated; a path of a kind not seen yet is kept, with its true cost. That is no complete
/// enumeration: that no further kind is found does not prove that there is none. Kinds are told apart
/// - in the plane exactly, by their homotopy (HomotopyWords.h);
/// - in space by whether two points can go along the two paths, each only forwards, and see each other all the time
///   through free cells (looked at every half a cell, points two cells apart). Homotopy says little there: around
///   separate solids all paths are of one class, because each can be lifted over them.
template <int D>
class CorridorClasses
{
public:
    using Point = Eigen::Matrix<double, D, 1>;  ///< in the plane or in space

    /// Grid and clearance are referred to.
    /// \throws std::invalid_argument as findCorridor() does, and for a surcharge out of range
    CorridorClasses(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const Point &start,
                    const Point &goal, const CorridorOptions &options, double surcharge);
    ~CorridorClasses();

    /// The cheapest path at first (which may have failed: then there is nothing else), later a path of a new kind, or
    /// nothing if `searches` (>= 1) have not shown any. If `stop` says so, a path that has failed with Stopped: the
    /// same search comes again.
    std::optional<Corridor<D>> next(int searches, const std::function<bool()> &stop = {});
    /// How many searches there have been.
    int searches() const { return searches_; }

private:
    class State;

    int searches_ = 0;
    std::unique_ptr<State> state_;
};

/// The first kinds that CorridorClasses finds, the cheapest first.
///
/// \return at least one; only the first may have failed
/// \throws std::invalid_argument as findCorridor() does, and for options out of range
template <int D>
std::vector<Corridor<D>> findCorridors(const VoxelGrid<D> &grid, const std::vector<float> &clearance,
                                       const Eigen::Matrix<double, D, 1> &start,
                                       const Eigen::Matrix<double, D, 1> &goal,
                                       const CorridorClassOptions &options = {});

extern template class CorridorClasses<2>;
extern template class CorridorClasses<3>;
extern template std::vector<Corridor<2>> findCorridors(const VoxelGrid<2> &, const std::vector<float> &,
                                                       const Eigen::Vector2d &, const Eigen::Vector2d &,
                                                       const CorridorClassOptions &);
extern template std::vector<Corridor<3>> findCorridors(const VoxelGrid<3> &, const std::vector<float> &,
                                                       const Eigen::Vector3d &, const Eigen::Vector3d &,
                                                       const CorridorClassOptions &);
}  // namespace narrows
