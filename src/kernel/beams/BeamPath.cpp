// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/beams/BeamPath.h"

#include <stdexcept>

namespace narrows
{
namespace
{
constexpr double shrink = 0.85;
constexpr int mostRepairs = 100;  // per station: 0.85^100 is nothing

void check(const BeamOptions &options)
{
    const BeamFanOptions &fan = options.fan;
    if (!(fan.linkLength > 0.0) || !(fan.spacing > 0.0) || !(fan.radius >= 0.0) || !(fan.longest > 0.0) ||
        !(fan.openSpace > 0.0))
        throw std::invalid_argument("beams: lengths must be positive");
    if (fan.couples < 1 || fan.couples > 4)
        throw std::invalid_argument("beams: there are 1 to 4 couples");
    if (!(options.window >= 0.0) || !std::isfinite(options.window) || options.passes < 0 ||
        !(options.switchAt >= 0.0) || !(options.switchAt <= 1.0) || !(options.early > 0.0) || !(options.ramp >= 0.0))
        throw std::invalid_argument("beams: window, passes, switchAt, early or ramp is out of range");
}

/// Where the region after `before` takes over, as a station, and not a whole one.
double switchStation(const CriticalRegion &before, const CriticalRegion &after, double spacing,
                     const BeamOptions &options)
{
    const double apart = spacing * (after.first - before.last);
    if (apart > options.fan.linkLength)
        return before.last + options.early * options.fan.linkLength / spacing;
    return before.last + options.switchAt * (after.first - before.last);
}

/// From every station to the far end that the path goes through.
template <int D>
PointPath<D> offsetsOf(const BeamFan<D> &fan, const std::vector<CriticalRegion> &regions, const BeamOptions &options)
{
    PointPath<D> offsets(fan.stations.size(), Eigen::Matrix<double, D, 1>::Zero());
    if (regions.empty())
        return offsets;
    const auto opposite = [&fan](const CriticalRegion &region, int station)
    {
        return fan.couples[region.couple].offset(1 - region.side, station);
    };
    std::size_t charge = 0;
    const double halfRamp = 0.5 * options.ramp / fan.spacing;
    for (int k = 1; k + 1 < fan.count(); ++k)
    {
        while (charge + 1 < regions.size() &&
               k > switchStation(regions[charge], regions[charge + 1], fan.spacing, options) + halfRamp)
            ++charge;
        offsets[k] = opposite(regions[charge], k);
        if (charge + 1 == regions.size())
            continue;
        const double from = switchStation(regions[charge], regions[charge + 1], fan.spacing, options) - halfRamp;
        if (k > from)
        {
            const double share = halfRamp > 0.0 ? std::min((k - from) / (2.0 * halfRamp), 1.0) : 1.0;
            offsets[k] += share * (opposite(regions[charge + 1], k) - offsets[k]);
        }
    }
    return offsets;
}

/// Whether a ball can go straight from a to b: two balls of free room around the ends reach each other, or halves.
template <int D>
bool isFree(const Eigen::Matrix<double, D, 1> &a, const Eigen::Matrix<double, D, 1> &b,
            const PointDistance<D> &distance, double radius, double tolerance)
{
    const double half = 0.5 * (b - a).norm();
    const Eigen::Matrix<double, D, 1> middle = 0.5 * (a + b);
    const double room = distance(middle) - radius;
    if (room < 0.0)
        return false;
    if (room >= half || half <= tolerance)
        return true;
    return isFree<D>(a, middle, distance, radius, tolerance) && isFree<D>(middle, b, distance, radius, tolerance);
}

/// Shortens the longer of two neighbouring offsets (both, if they are similar) until the way between them is free.
/// \return how often, or -1 if that did not help
template <int D>
int repairOffsets(const BeamFan<D> &fan, PointPath<D> &offsets, const PointDistance<D> &distance,
                  const BeamFanOptions &options)
{
    int repairs = 0;
    for (int round = 0; round < mostRepairs; ++round)
    {
        bool clean = true;
        for (int k = 0; k + 1 < fan.count(); ++k)
        {
            auto &one = offsets[k], &other = offsets[k + 1];
            if (isFree<D>(fan.stations[k] + one, fan.stations[k + 1] + other, distance, options.radius,
                          1e-3 * options.spacing))
                continue;
            clean = false;
            ++repairs;
            const bool isLonger = one.norm() >= shrink * other.norm(),
                       otherIsLonger = other.norm() >= shrink * one.norm();
            if (isLonger)
                one *= shrink;
            if (otherIsLonger)
                other *= shrink;
        }
        if (clean)
            return repairs;
    }
    return -1;
}

template <int D>
bool isUsable(const PointPath<D> &middle)
{
    return middle.size() > 1 && lengthOf<D>(middle) > 0.0 && std::isfinite(lengthOf<D>(middle));
}
}  // namespace

std::string toText(BeamFailure failure)
{
    switch (failure)
    {
        case BeamFailure::None:
            return "none";
        case BeamFailure::MiddleTooShort:
            return "middle_too_short";
        case BeamFailure::MiddleBlocked:
            return "middle_blocked";
        case BeamFailure::NotRepaired:
            return "not_repaired";
    }
    return "unknown";
}

template <int D>
BeamPath<D> beamPath(const PointPath<D> &middle, const PointDistance<D> &distance, const BeamOptions &options)
{
    check(options);
    BeamPath<D> result;
    if (!isUsable<D>(middle))
    {
        result.failure = BeamFailure::MiddleTooShort;
        return result;
    }
    const PointPath<D> smooth =
        windowedOver<D>(resampled<D>(middle, options.fan.spacing), options.window, options.passes);
    const BeamFan<D> fan = castBeams<D>(smooth, distance, options.fan);
    result.beams = 2 * static_cast<int>(fan.couples.size()) * fan.count();
    if (*std::min_element(fan.clearance.begin(), fan.clearance.end()) < 0.0)
    {
        result.failure = BeamFailure::MiddleBlocked;
        return result;
    }
    const double width = 2.0 * (fan.typicalClearance + options.fan.radius);
    result.regions = findCriticalRegions<D>(fan, options.regions.value_or(standardRegions<D>(width)));
    PointPath<D> offsets = offsetsOf<D>(fan, result.regions, options);
    if (options.repair)
        result.repairs = repairOffsets<D>(fan, offsets, distance, options.fan);
    if (result.repairs < 0)
    {
        result.failure = BeamFailure::NotRepaired;
        return result;
    }
    for (int k = 0; k < fan.count(); ++k)
        result.path.push_back(fan.stations[k] + offsets[k]);
    return result;
}

template BeamPath<2> beamPath(const PointPath<2> &, const PointDistance<2> &, const BeamOptions &);
template BeamPath<3> beamPath(const PointPath<3> &, const PointDistance<3> &, const BeamOptions &);
}  // namespace narrows
