// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "kernel/chain/ChordRelaxation.h"
#include "planners/TightWays.h"

namespace narrows
{
/// How a path is made.
enum class TightMode
{
    Relax,   ///< chord relaxation from several starts (ours)
    Middle,  ///< the middle path as it is
    Beams    ///< the paper's: through the ends of beams
};

/// How paths are looked for.
struct TightSettings
{
    TightMode mode = TightMode::Relax;  ///< how a path is made
    TightGrid grid;                     ///< for the middle paths
    int rounds = 400;                   ///< >= 1, of relaxation per try
    int couples = 2;                    ///< 1 to 4, of beams in space
};

/// A path that was tried, from the start or from further on along the entrance line, and what the certificate says of
/// it.
template <int D>
struct TightAttempt
{
    PointPath<D> nodes;            ///< corners of the path
    std::string failure;           ///< empty if a chain can follow the path
    ChainCertificate certificate;  ///< of the path, for the chain
};

/// Looks for paths that a chain can follow, one try after the other. In the cheapest corridor of a grid, then in each
/// further one: the middle path relaxed, the same with nodes twice as far apart, and (in space after all corridors) the
/// beams' path relaxed. Then, in all of them, the link length grown slowly, and that with half the spacing. A chain too
/// short to reach back from the goal to where its tip begins is fed straight on first, as far as necessary: its paths
/// begin there.
template <int D>
class TightSearch
{
public:
    using Point = Eigen::Matrix<double, D, 1>;  ///< of the plane or of space

    /// Obstacles, spec and settings are referred to.
    /// \param obstacles, spec, settings where, for which chain and how paths are looked for
    /// \param start, goal of the chain's tip \param entrance unit vector along which the chain is fed
    /// \param goalRoom how far from the goal relaxed paths may end, >= 0
    TightSearch(const ChordObstacles<D> &obstacles, const ChainSpec &spec, const TightSettings &settings,
                const Point &start, const Point &entrance, const Point &goal, double goalRoom = 0.0);

    /// Whether everything has been tried.
    bool isDone() const { return done_; }
    /// The next try. If stopped in the middle of it, the failure is "timeout" and the try comes again. Without nodes
    /// and failure if it turns out that everything has been tried.
    TightAttempt<D> next(const std::function<bool()> &stop);
    /// cells, corridors, relaxation_rounds, chords, certificates.
    std::map<std::string, double> counts() const;

private:
    enum class Start
    {
        Middle,
        Coarse,
        Beams,
        Growing,
        GrowingFine
    };
    using Way = TightWay<D>;

    std::string findWays();
    bool feedStraight(const PointPath<D> &nodes);

    TightAttempt<D> tryWay(const Way &way, const std::function<bool()> &stop);
    TightAttempt<D> certified(const PointPath<D> &nodes);
    TightAttempt<D> tryBeams(const Way &way, const std::function<bool()> &stop);
    TightAttempt<D> relaxed(const Way &way, const PointPath<D> &nodes, double length, double fineness,
                            const std::function<bool()> &stop);
    TightAttempt<D> grow(const Way &way, double fineness, const std::function<bool()> &stop);
    void advance(const std::function<bool()> &stop);
    void restart();

    const ChordObstacles<D> &obstacles_;
    const ChainSpec &spec_;
    const TightSettings &settings_;
    Point start_, entrance_, goal_;
    double goalRoom_;
    std::map<std::string, double> counts_;
    TightWays<D> ways_;
    std::size_t way_ = 0;
    Start kind_ = Start::Middle;
    bool between_ = false;  ///< the last try is over, what comes next is not settled yet
    int advances_ = 0;      ///< of the start
    PointPath<D> tooLong_;  ///< the first path that the chain was too short for, since the start was moved
    bool done_ = false;
};

extern template class TightSearch<2>;
extern template class TightSearch<3>;
}  // namespace narrows
