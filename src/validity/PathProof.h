// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "validity/ConvexSets.h"
#include "validity/PlanarMotion.h"
#include "validity/SpatialMotion.h"
#include "validity/Verifier.h"

namespace narrows::proof
{
template <class Model>
struct MotionOf;

template <>
struct MotionOf<PlanarModel>
{
    using Type = PlanarMotion;
};

template <>
struct MotionOf<SpatialModel>
{
    using Type = SpatialMotion;
};

/// Proves that a piecewise straight path is free of collisions, and bounds its clearance from below, by branch and
/// bound.
///
/// An interval of the path is settled for a link and a convex part of an obstacle, or for two links, if one line (in
/// space: plane) keeps them apart during all of it: the one found at the middle, at rest or turning with what it
/// separates. Pairs that are not settled are passed on to the two halves, level by level, so that coarse views of the
/// whole path come before fine ones of any part. A box around parts gives way to these once it is larger than what the
/// link moves. For one path; used once.
template <class Model>
class PathProof
{
public:
    /// \param path finite rows of the arm's dimension, at least one. \param clearanceTolerance > 0
    PathProof(const Model &model, const std::vector<Eigen::VectorXd> &path, double clearanceTolerance);

    /// Accepted with the clearance, or `collision`, `self_collision` or `not_certified` with the place.
    Verdict run();

private:
    using Motion = typename MotionOf<Model>::Type;
    static constexpr int Dim = Motion::Dim;
    static constexpr int none = -1;

    /// A link, and a part or a second link, that have not been proven apart.
    struct Pair
    {
        int link;
        int part;                                   ///< none if there is a second link
        int secondLink;                             ///< none if there is a part, else less than `link`
        Point<Dim> direction = Point<Dim>::Zero();  ///< unit normal, towards the link, of the line or plane that last
                                                    ///< separated them; zero before there is one
    };

    struct Ball
    {
        Point<Dim> center;
        double radius;
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
        Overlapping,
        Splitting  ///< not settled, and a box that should give way
    };

    void place(const Interval &interval);
    std::vector<Pair> allPairs() const;
    bool checkEnclosure();
    bool visitWaypoints();
    bool visitSegments();
    bool visit(Interval &interval, std::vector<Interval> &halves);
    bool visit(const Interval &interval, Pair &pair, std::vector<Pair> &open);
    bool visitHalves(const Interval &interval, const Pair &box, std::vector<Pair> &open);
    Finding examine(Pair &pair, double half);
    Separation<Dim> separation(const Pair &pair, double half) const;
    bool isEnough(double clearance) const;
    bool settles(double clearance);
    double thickness(const Pair &pair) const;
    double travel(const Pair &pair, double half) const;
    double bendingWay(const Pair &pair, double half) const;
    Ball ballAround(const Pair &pair) const;
    bool settlesAlong(const Pair &pair, double half);
    bool settlesTurning(const Pair &pair, double half);
    bool settlesBetweenLinks(const Pair &pair, double half);
    bool settlesBesidePart(const Pair &pair, double half);
    bool refuse(const char *reason, const Interval &interval, const Pair &pair);

    const Model &model_;
    const std::vector<Eigen::VectorXd> &path_;
    double tolerance_;
    Motion motion_;
    Parts<Dim> parts_;
    std::vector<double> halfLengths_;             ///< per link
    std::vector<std::pair<int, int>> linkPairs_;  ///< that must not touch; the smaller index first
    double rounding_ = 0.0;                       ///< more than any error of a computed distance
    double least_ =
        std::numeric_limits<double>::infinity();  ///< least clearance met anywhere: bounds the path's from above
    double settled_ =
        std::numeric_limits<double>::infinity();  ///< least clearance settled for: bounds it from below, at the end
    std::size_t openPairs_ = 0;                   ///< handed to the next level so far
    Verdict verdict_;
};

extern template class PathProof<PlanarModel>;
extern template class PathProof<SpatialModel>;
}  // namespace narrows::proof
