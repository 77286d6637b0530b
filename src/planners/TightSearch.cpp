// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TightSearch.h"

#include <algorithm>
#include <cmath>

#include "kernel/beams/BeamPath.h"

namespace narrows
{
namespace
{
constexpr double firstShare = 0.5;  ///< of the link length, where growing begins
constexpr double growth = 0.05;
constexpr int mostAdvances = 6;    ///< of the start along the entrance line
constexpr double mostSpare = 0.5;  ///< of a link: how much further than necessary
constexpr double leastSpare = 0.1;
}  // namespace

template <int D>
TightSearch<D>::TightSearch(const ChordObstacles<D> &obstacles, const ChainSpec &spec, const TightSettings &settings,
                            const Point &start, const Point &entrance, const Point &goal, double goalRoom)
  : obstacles_(obstacles),
    spec_(spec),
    settings_(settings),
    start_(start),
    entrance_(entrance),
    goal_(goal),
    goalRoom_(goalRoom),
    ways_(obstacles, spec, settings.grid)
{
}

template <int D>
TightAttempt<D> TightSearch<D>::next(const std::function<bool()> &stop)
{
    TightAttempt<D> attempt;
    if (between_)
    {
        advance(stop);
        if (between_)
            attempt.failure = "timeout";
        if (between_ || done_)
            return attempt;
    }
    if (ways_.found().empty())
    {
        attempt.failure = findWays();
        done_ = !attempt.failure.empty();
        if (done_)
            return attempt;
    }
    attempt = tryWay(ways_.found()[way_], stop);
    if (!attempt.failure.empty() && stop())
        attempt.failure = "timeout";
    else
    {
        if (attempt.failure == toText(ChainFailure::TooShort) && tooLong_.empty())
            tooLong_ = attempt.nodes;
        between_ = true;
        if (!attempt.failure.empty())
            advance(stop);
    }
    return attempt;
}

template <int D>
TightAttempt<D> TightSearch<D>::tryWay(const Way &way, const std::function<bool()> &stop)
{
    if (settings_.mode == TightMode::Middle)
        return certified(way.middle);
    if (settings_.mode == TightMode::Beams)
        return tryBeams(way, stop);
    switch (kind_)
    {
        case Start::Middle:
            return relaxed(way, way.middle, spec_.length, 1.0, stop);
        case Start::Coarse:
            return relaxed(way, way.middle, spec_.length, 2.0, stop);
        case Start::Beams:
            return tryBeams(way, stop);
        case Start::Growing:
            return grow(way, 1.0, stop);
        case Start::GrowingFine:
            return grow(way, 0.5, stop);
    }
    return {};
}

/// Quick tries in one corridor, then in the next one that is found; when there is none left, those that take longer, in
/// all of them. Stays between two tries if it is stopped.
template <int D>
void TightSearch<D>::advance(const std::function<bool()> &stop)
{
    // In the plane the path through beams' ends is the best start there is; in space it is long and winds.
    constexpr Start lastQuick = D == 2 ? Start::Beams : Start::Coarse;
    const std::size_t count = ways_.found().size();
    const bool once = settings_.mode != TightMode::Relax;
    if (!once && kind_ == lastQuick && ways_.findAnother(stop))
    {
        kind_ = Start::Middle;
        way_ = count;
    }
    else if (!once && kind_ == lastQuick && ways_.hasMore())
        return;
    else if (kind_ < lastQuick)
        kind_ = static_cast<Start>(static_cast<int>(kind_) + 1);
    else if (kind_ == lastQuick || ++way_ == count)
    {
        way_ = 0;
        done_ = kind_ == Start::GrowingFine;
        kind_ = static_cast<Start>(static_cast<int>(kind_) + 1);
    }
    between_ = false;
    done_ = done_ || once;
    // Relaxed paths are longer than the ways that they come from: all again, from a start that has been moved on.
    if (done_ && !tooLong_.empty() && feedStraight(tooLong_))
        restart();
}

template <int D>
void TightSearch<D>::restart()
{
    tooLong_.clear();
    kind_ = Start::Middle;
    way_ = 0;
    done_ = !findWays().empty();
}

template <int D>
std::string TightSearch<D>::findWays()
{
    std::string failure = ways_.findFirst(start_, goal_);
    while (failure.empty() && feedStraight(ways_.found().front().middle))
        failure = ways_.findFirst(start_, goal_);
    return failure;
}

template <int D>
std::map<std::string, double> TightSearch<D>::counts() const
{
    std::map<std::string, double> all = counts_;
    for (const auto &[name, count] : ways_.counts())
        all[name] = count;
    return all;
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
    options.window = 0.25 * way.width;
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
    options.goalRoom = goalRoom_;
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
