// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/beams/CriticalRegion.h"

namespace narrows
{
namespace
{
double angleBetween(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
{
    return 2.0 * std::atan2((a - b).norm(), (a + b).norm());
}

/// Reads the regions to one side of one couple off its beams.
template <int D>
class SideReader
{
public:
    SideReader(const BeamFan<D> &fan, const CriticalRegionOptions &options, int couple, int side)
      : fan_(fan), options_(options), couple_(couple), side_(side)
    {
    }

    void append(std::vector<CriticalRegion> &regions) const
    {
        CriticalRegion region;
        int last = -1;
        for (int k = 0; k + 1 < fan_.count(); ++k)
        {
            const double inner = moved(side_, k), outer = moved(1 - side_, k);
            if (!(inner < options_.slow && inner < options_.ratio * outer))
                continue;
            if (last < 0 || fan_.spacing * (k - last - 1) > options_.gap)
            {
                keep(region, last, regions);
                region = {couple_, side_, k, k, 0.0, 0.0};
            }
            region.turning += angleBetween(fan_.tangents[k], fan_.tangents[k + 1]);
            region.weight += 1.0 - inner;
            last = k;
        }
        keep(region, last, regions);
    }

private:
    /// How far the end of a beam moves to the next station, over the way along the path.
    double moved(int side, int k) const
    {
        return (fan_.end(couple_, side, k + 1) - fan_.end(couple_, side, k)).norm() / fan_.spacing;
    }

    void keep(CriticalRegion region, int last, std::vector<CriticalRegion> &regions) const
    {
        if (last < 0 || region.turning <= options_.turning)
            return;
        region.last = last;
        region.weight *= region.turning;
        regions.push_back(region);
    }

    const BeamFan<D> &fan_;
    const CriticalRegionOptions &options_;
    int couple_;
    int side_;
};

bool coverEachOther(const CriticalRegion &a, const CriticalRegion &b)
{
    const int common = std::min(a.last, b.last) - std::max(a.first, b.first) + 1;
    const int shorter = std::min(a.last - a.first, b.last - b.first) + 1;
    return 2 * common > shorter;
}
}  // namespace

template <int D>
std::vector<CriticalRegion> findCriticalRegions(const BeamFan<D> &fan, const CriticalRegionOptions &options)
{
    std::vector<CriticalRegion> all;
    for (int couple = 0; couple < static_cast<int>(fan.couples.size()); ++couple)
        for (int side = 0; side < 2; ++side)
            SideReader<D>(fan, options, couple, side).append(all);
    std::stable_sort(all.begin(), all.end(),
                     [](const CriticalRegion &a, const CriticalRegion &b) { return a.weight > b.weight; });
    std::vector<CriticalRegion> kept;
    for (const CriticalRegion &region : all)
        if (std::none_of(kept.begin(), kept.end(),
                         [&region](const CriticalRegion &other) { return coverEachOther(region, other); }))
            kept.push_back(region);
    std::stable_sort(kept.begin(), kept.end(),
                     [](const CriticalRegion &a, const CriticalRegion &b)
                     { return a.first + a.last < b.first + b.last; });
    return kept;
}

template std::vector<CriticalRegion> findCriticalRegions(const BeamFan<2> &, const CriticalRegionOptions &);
template std::vector<CriticalRegion> findCriticalRegions(const BeamFan<3> &, const CriticalRegionOptions &);
}  // namespace narrows
