// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/MotionPeaks.h"

#include <limits>

namespace narrows
{
namespace
{
constexpr int orders = 4;
constexpr int firstSamples = 16;        // per piece
constexpr double shortestCell = 1e-13;  // of a piece: there its ends are as good as any bound

struct Cell
{
    double from, to;
};

class PeakSearch
{
public:
    PeakSearch(const PiecewiseMotion &motion, double tolerance) : motion_(motion), tolerance_(tolerance)
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        peaks_.fill({infinity, 0.0, -infinity, 0.0});
    }

    void sample(std::size_t piece, const Cell &cell)
    {
        for (int i = 0; i <= firstSamples; ++i)
            seen(piece, i == firstSamples ? cell.to : cell.from + (cell.to - cell.from) * i / firstSamples);
    }

    void search(std::size_t piece, const Cell &whole)
    {
        cells_.assign(1, whole);
        const double shortest = shortestCell * (whole.to - whole.from);
        while (!cells_.empty())
        {
            const Cell cell = cells_.back();
            cells_.pop_back();
            const double middle = 0.5 * (cell.from + cell.to), half = 0.5 * (cell.to - cell.from);
            const Series<4, Enclosure> center = seen(piece, middle);
            if (half < shortest || settled(motion_.over(piece, {cell.from, cell.to}), center, half))
                continue;
            cells_.push_back({cell.from, middle});
            cells_.push_back({middle, cell.to});
        }
    }

    const MotionPeaks &peaks() const { return peaks_; }

private:
    Series<4, Enclosure> seen(std::size_t piece, double t)
    {
        const Series<4, Enclosure> values = motion_.over(piece, t);
        for (int k = 0; k < orders; ++k)
        {
            Extremes &extremes = peaks_[k];
            if (values[k].lower < extremes.lowest)
                extremes.lowest = values[k].lower, extremes.lowestAt = t;
            if (values[k].upper > extremes.highest)
                extremes.highest = values[k].upper, extremes.highestAt = t;
        }
        return values;
    }

    /// Can no point of the cell move any extreme by more than the tolerance? Its ends have been seen.
    bool settled(const Series<4, Enclosure> &cell, const Series<4, Enclosure> &center, double half) const
    {
        for (int k = 0; k < orders; ++k)
        {
            if (!cell[k + 1].hasZero())
                continue;  // monotone
            double swing = half * cell[k + 1].magnitude();
            if (k + 2 <= orders)
                swing = std::min(swing, half * (center[k + 1].magnitude() + 0.5 * half * cell[k + 2].magnitude()));
            const double lower = std::max(cell[k].lower, center[k].lower - swing);
            const double upper = std::min(cell[k].upper, center[k].upper + swing);
            const Extremes &e = peaks_[k];
            const double slack = tolerance_ * std::max(e.magnitude(), e.highest - e.lowest);
            if (!(lower >= e.lowest - slack && upper <= e.highest + slack))
                return false;
        }
        return true;
    }

    const PiecewiseMotion &motion_;
    double tolerance_;
    MotionPeaks peaks_;
    std::vector<Cell> cells_;
};
}  // namespace

MotionPeaks motionPeaks(const PiecewiseMotion &motion, double tolerance)
{
    const std::vector<double> knots = motion.knots();
    PeakSearch search(motion, tolerance);
    // All samples first: the higher the best, the more cells are settled at once.
    for (std::size_t piece = 0; piece + 1 < knots.size(); ++piece)
        search.sample(piece, {knots[piece], knots[piece + 1]});
    for (std::size_t piece = 0; piece + 1 < knots.size(); ++piece)
        search.search(piece, {knots[piece], knots[piece + 1]});
    return search.peaks();
}

bool MotionLimits::valid() const
{
    return velocity > 0.0 && acceleration > 0.0 && jerk > 0.0 && std::isfinite(velocity) &&
           std::isfinite(acceleration) && std::isfinite(jerk);
}

double stretchFor(const MotionPeaks &peaks, const MotionLimits &limits)
{
    return std::max({peaks[1].magnitude() / limits.velocity, std::sqrt(peaks[2].magnitude() / limits.acceleration),
                     std::cbrt(peaks[3].magnitude() / limits.jerk)});
}
}  // namespace narrows
