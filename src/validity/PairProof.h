// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "validity/ConvexSets.h"
#include "validity/PlanarMotion.h"
#include "validity/SpatialMotion.h"

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

/// Looks at pairs of a link and what it must not touch, around one moment of a path after another, and keeps account of
/// the least clearance.
///
/// A pair is settled for an interval if one line (in space: plane) keeps the two apart during all of it: the one found
/// at the middle, at rest or turning with what it separates.
template <class Model>
class PairProof
{
public:
    using Motion = typename MotionOf<Model>::Type;
    static constexpr int Dim = Motion::Dim;
    static constexpr int none = -1;

    /// A link, and a part of an obstacle or a second link.
    struct Pair
    {
        int link;
        int part;                                   ///< none if there is a second link
        int secondLink;                             ///< none if there is a part, else less than `link`
        Point<Dim> direction = Point<Dim>::Zero();  ///< unit normal, towards the link, of the line or plane that last
                                                    ///< separated them; zero before there is one
    };

    enum class Finding
    {
        Settled,
        Open,
        Overlapping,
        Splitting  ///< not settled, and a box that should give way to what is in it
    };

    /// \param path for which motions will be asked; not empty. \param clearanceTolerance > 0
    PairProof(const Model &model, const std::vector<Eigen::VectorXd> &path, double clearanceTolerance);

    /// Goes to from + t * (to - from).
    void place(const Eigen::VectorXd &from, const Eigen::VectorXd &to, double t) { motion_.place(from, to, t); }

    const Motion &motion() const { return motion_; }
    const Parts<Dim> &parts() const { return parts_; }

    std::vector<Pair> allPairs() const;

    /// While t changes by up to `half`.
    Finding examine(Pair &pair, double half);

    /// What is in a box, the nearer first: to look at that first spares the other most of the work.
    std::array<Pair, 2> split(const Pair &box) const;

    /// How far the two sides of a pair can move against each other at most.
    double travel(const Pair &pair, double half) const;

    /// The least clearance that was settled for: once all is settled, a lower bound of the path's.
    double settled() const { return settled_; }

private:
    struct Ball
    {
        Point<Dim> center;
        double radius;
    };

    Separation<Dim> separation(const Pair &pair, double half) const;
    bool isEnough(double clearance) const;
    bool settles(double clearance);
    double thickness(const Pair &pair) const;
    double bendingWay(const Pair &pair, double half) const;
    Ball ballAround(const Pair &pair) const;
    bool settlesAlong(const Pair &pair, double half);
    bool settlesTurning(const Pair &pair, double half);
    bool settlesBetweenLinks(const Pair &pair, double half);
    bool settlesBesidePart(const Pair &pair, double half);

    double tolerance_;
    Motion motion_;
    Parts<Dim> parts_;
    std::vector<double> halfLengths_;                         ///< per link
    std::vector<std::pair<int, int>> linkPairs_;              ///< that must not touch; the smaller index first
    double rounding_ = 0.0;                                   ///< more than any error of a computed distance
    double least_ = std::numeric_limits<double>::infinity();  ///< met anywhere: bounds the path's clearance from above
    double settled_ = std::numeric_limits<double>::infinity();
};

extern template class PairProof<PlanarModel>;
extern template class PairProof<SpatialModel>;
}  // namespace narrows::proof
