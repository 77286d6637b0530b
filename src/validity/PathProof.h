// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "kernel/PlanarModel.h"
#include "validity/ArmMotion.h"
#include "validity/SupportDistance.h"
#include "validity/Verifier.h"

namespace narrows
{
/// Proves that a piecewise straight path is free of collisions, and bounds its clearance from below, by branch and
/// bound.
///
/// An interval of the path is settled for one link and one convex piece of an obstacle if a single line separates them
/// during all of it: the line found at the middle, minus what the link's ends can move along its normal. Unsettled
/// pairs are passed on to the two halves, level by level, so that coarse views of the whole path come before fine ones
/// of any part. For one path; used once.
class PathProof
{
public:
    /// \param path finite rows of the arm's dimension, at least one. \param clearanceTolerance > 0
    PathProof(const PlanarModel &model, const std::vector<Eigen::VectorXd> &path, double clearanceTolerance);

    /// Accepted with the clearance, or `collision` or `not_certified` with the place.
    Verdict run();

private:
    /// A convex piece of an obstacle.
    struct Piece
    {
        ConvexSet set;
        int obstacle;
        double thickness;  ///< of link and piece together
    };

    /// A link and a piece that have not been proven apart.
    struct Pair
    {
        int link;
        int piece;
        Eigen::Vector2d direction;  ///< of the last separating line; unit
    };

    struct Interval
    {
        int segment;
        double center;  ///< in [0, 1] of the segment
        double half;    ///< half its width
        std::vector<Pair> open;
    };

    enum class Finding
    {
        Settled,
        Open,
        Overlapping
    };

    void estimateRounding();
    void place(const Interval &interval);
    std::vector<Pair> allPairs() const;
    bool checkBase();
    bool visitWaypoints();
    bool visitSegments();
    bool visit(Interval &interval, std::vector<Interval> &halves);
    Finding examine(Pair &pair, double half);
    bool settles(double clearance);
    double roughClearance(const Pair &pair, double half) const;
    double clearanceAlong(const Pair &pair, double half) const;
    bool refuse(const char *reason, const Interval &interval, const Pair &pair);

    const PlanarModel &model_;
    const std::vector<Eigen::VectorXd> &path_;
    double tolerance_;
    ArmMotion motion_;
    std::vector<Piece> pieces_;
    double rounding_ = 0.0;  ///< more than any error of a computed distance
    double least_ =
        std::numeric_limits<double>::infinity();  ///< least clearance met anywhere: bounds the path's from above
    double settled_ =
        std::numeric_limits<double>::infinity();  ///< least clearance settled for: bounds it from below, at the end
    std::size_t openPairs_ = 0;                   ///< handed to the next level so far
    Verdict verdict_;
};
}  // namespace narrows
