// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "kernel/chain/ChordRelaxation.h"
#include "kernel/fields/VoxelGrid.h"

namespace narrows
{
/// How a path is made.
enum class TightMode
{
    Relax,   ///< chord relaxation from several starts (ours)
    Middle,  ///< the middle path as it is
    Beams    ///< the paper's: through the ends of beams
};

/// Where the middle path comes from.
enum class TightField
{
    Corridor,  ///< the cheapest path, clearance being cheap
    Laplace    ///< the paper's potential
};

struct TightSettings
{
    TightMode mode = TightMode::Relax;
    TightField field = TightField::Corridor;
    double spacing = 0.0;  ///< of the grid; 0: a twelfth of a link
    int corridors = 4;     ///< >= 1, how many are tried at most
    int refinements = 2;   ///< >= 0, how often the grid is refined if there is no way through it
    int rounds = 400;      ///< >= 1, of relaxation per try
    int couples = 2;       ///< 1 to 4, of beams in space
};

/// A path that was tried, from the start or from further on along the entrance line, and what the certificate says of
/// it.
template <int D>
struct TightAttempt
{
    PointPath<D> nodes;
    std::string failure;  ///< empty if a chain can follow the path
    ChainCertificate certificate;
};

/// Looks for paths that a chain can follow, one try after the other: through the cheapest corridor of a grid, then
/// through further ones; in each of them the middle path relaxed, the beams' path relaxed, then, in all of them, the
/// link length grown slowly, and that with half the spacing. A chain too short to reach back from the goal to where its
/// tip begins is fed straight on first, as far as necessary: its paths begin there.
template <int D>
class TightSearch
{
public:
    using Point = Eigen::Matrix<double, D, 1>;

    /// Obstacles, spec and settings are referred to.
    TightSearch(const ChordObstacles<D> &obstacles, const ChainSpec &spec, const TightSettings &settings,
                const Point &start, const Point &entrance, const Point &goal);

    /// Whether everything has been tried.
    bool isDone() const { return done_; }
    /// The next try. If stopped in the middle of it, the failure is "timeout" and the try comes again.
    TightAttempt<D> next(const std::function<bool()> &stop);
    /// cells, corridors, relaxation_rounds, chords, certificates.
    const std::map<std::string, double> &counts() const { return counts_; }

private:
    enum class Start
    {
        Middle,
        Beams,
        Growing,
        GrowingFine
    };
    struct Way
    {
        PointPath<D> middle;
        double width;  ///< of the corridor, typically
    };

    std::string findWays();
    std::string openGrid(int refinement, VoxelGrid<D> &grid) const;
    std::string firstWay(const VoxelGrid<D> &grid, const std::vector<float> &clearance);
    bool feedStraight(const PointPath<D> &nodes);
    std::string corridorWays(const VoxelGrid<D> &grid, const std::vector<float> &clearance, int count);
    std::string laplaceWay(const VoxelGrid<D> &grid, const std::vector<float> &clearance);
    void addWay(const VoxelGrid<D> &grid, const std::vector<float> &clearance, const PointPath<D> &path);

    TightAttempt<D> certified(const PointPath<D> &nodes);
    TightAttempt<D> tryBeams(const Way &way, const std::function<bool()> &stop);
    TightAttempt<D> relaxed(const Way &way, const PointPath<D> &nodes, double length, double fineness,
                            const std::function<bool()> &stop);
    TightAttempt<D> grow(const Way &way, double fineness, const std::function<bool()> &stop);
    void advance();
    void restart();

    const ChordObstacles<D> &obstacles_;
    const ChainSpec &spec_;
    const TightSettings &settings_;
    Point start_, entrance_, goal_;
    std::map<std::string, double> counts_;
    VoxelGrid<D> grid_;
    std::vector<float> clearance_;
    std::vector<Way> ways_;
    std::size_t way_ = 0;
    Start kind_ = Start::Middle;
    bool searchedAll_ = false;
    int advances_ = 0;      ///< of the start
    PointPath<D> tooLong_;  ///< the first path that the chain was too short for, since the start was moved
    bool done_ = false;
};

extern template class TightSearch<2>;
extern template class TightSearch<3>;
}  // namespace narrows
