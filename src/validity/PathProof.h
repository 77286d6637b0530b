// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "validity/PairProof.h"
#include "validity/Verifier.h"

namespace narrows::proof
{
/// Proves that a piecewise straight path is free of collisions, and bounds its clearance from below, by branch and
/// bound.
///
/// Pairs that are not settled for an interval are passed on to the two halves, level by level, so that coarse views of
/// the whole path come before fine ones of any part. A box around parts gives way to these once it is larger than what
/// the link moves. For one path; used once.
template <class Model>
class PathProof
{
public:
    /// \param path finite rows of the arm's dimension, at least one. \param clearanceTolerance > 0
    PathProof(const Model &model, const std::vector<Eigen::VectorXd> &path, double clearanceTolerance);

    /// Accepted with the clearance, or `collision`, `self_collision` or `not_certified` with the place.
    Verdict run();

private:
    using Pair = typename PairProof<Model>::Pair;
    using Finding = typename PairProof<Model>::Finding;

    struct Interval
    {
        int segment;
        double center;  ///< in [0, 1] of the segment
        double half;    ///< half its width
        std::vector<Pair> open;
    };

    void place(const Interval &interval);
    bool checkEnclosure();
    bool visitWaypoints();
    bool visitSegments();
    bool visit(Interval &interval, std::vector<Interval> &halves);
    bool visit(const Interval &interval, Pair &pair, std::vector<Pair> &open);
    bool refuse(const char *reason, const Interval &interval, const Pair &pair);

    const Model &model_;
    const std::vector<Eigen::VectorXd> &path_;
    PairProof<Model> pairs_;
    std::size_t openPairs_ = 0;  ///< handed to the next level so far
    Verdict verdict_;
};

extern template class PathProof<PlanarModel>;
extern template class PathProof<SpatialModel>;
}  // namespace narrows::proof
