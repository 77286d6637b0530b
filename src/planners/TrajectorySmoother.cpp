// SPDX-License-Identifier: BSD-3-Clause
#include "planners/TrajectorySmoother.h"

#include <limits>
#include <optional>

#include <nlopt.h>

namespace narrows
{
namespace
{
using Eigen::Index;
using Eigen::VectorXd;

constexpr int bisections = 6;            // of each corner's overlap
constexpr double slowest = 1.5;          // logarithm of how much slower than the fastest a move may become
constexpr double fastest = -0.5;         // ... and faster; the whole is stretched to the limits afterwards
constexpr double viaReach = 0.5;         // of the shorter neighbouring segment: how far a vertex may move
constexpr double firstSearchStep = 0.1;  // of the search: overlaps and logarithms; vertices in shares of viaReach
constexpr double searchTolerance = 1e-4;
constexpr double refused = 1.0;  // added to the logarithm of the duration

/// The numbers that NLopt searches: overlaps, logarithms of slowness, then ways of the inner vertices, if they move.
class SmoothingSearch
{
public:
    SmoothingSearch(const OverlappedMoves &moves, const TrajectoryProof &proof, const SmoothingOptions &options)
      : moves_(moves), proof_(proof), options_(options), corners_(moves.segments() - 1), timing_(moves.stops())
    {
        const PolynomialTrajectory stops = moves.motion(timing_);
        const double factor = moves.stretchToLimits(stops);
        best_ = stops.stretched(factor);
        stopDuration_ = best_->duration();
        const Index coordinates = corners_ * moves.vertices().rows();
        movable_ = coordinates <= options.viaNumbers ? coordinates : 0;
    }

    /// Corner by corner, the overlap that is best.
    void bisect()
    {
        for (int round = 0; round < 2; ++round)
            for (Index corner = 0; corner < corners_; ++corner)
            {
                double step = 0.5, kept = timing_.overlaps[corner];
                for (int i = 0; i < bisections && !stopped(); ++i, step *= 0.5)
                    for (const double overlap : {kept + step, kept - step})
                    {
                        if (overlap < 0.0 || overlap > 1.0)
                            continue;
                        timing_.overlaps[corner] = overlap;
                        const double before = best_->duration();
                        judge(moves_, timing_);
                        if (best_->duration() < before)
                        {
                            kept = overlap;
                            break;
                        }
                    }
                timing_.overlaps[corner] = kept;
            }
    }

    void optimize()
    {
        if (options_.evaluations < 1)
            return;
        const Index size = 2 * corners_ + 1 + movable_;
        VectorXd lower = VectorXd::Constant(size, -1.0), upper = VectorXd::Constant(size, 1.0);
        lower.head(corners_).setZero();
        lower.segment(corners_, corners_ + 1).setConstant(fastest);
        upper.segment(corners_, corners_ + 1).setConstant(slowest);
        VectorXd x = VectorXd::Zero(size);
        x.head(corners_) = timing_.overlaps;
        optimizer_ = nlopt_create(NLOPT_LN_SBPLX, static_cast<unsigned>(size));
        nlopt_set_min_objective(optimizer_, value, this);
        nlopt_set_lower_bounds(optimizer_, lower.data());
        nlopt_set_upper_bounds(optimizer_, upper.data());
        nlopt_set_initial_step1(optimizer_, firstSearchStep);
        nlopt_set_maxeval(optimizer_, options_.evaluations);
        nlopt_set_xtol_abs1(optimizer_, searchTolerance);
        double least = 0.0;
        nlopt_optimize(optimizer_, x.data(), &least);
        nlopt_destroy(optimizer_);
    }

    SmoothedTrajectory result() const { return {*best_, stopDuration_, blended_, evaluations_, proofs_}; }

private:
    static double value(unsigned size, const double *x, double *, void *search)
    {
        SmoothingSearch &self = *static_cast<SmoothingSearch *>(search);
        if (self.stopped())
        {
            nlopt_force_stop(self.optimizer_);
            return std::log(self.best_->duration()) + refused;
        }
        const Eigen::Map<const VectorXd> numbers(x, size);
        const MoveTiming timing{numbers.head(self.corners_),
                                numbers.segment(self.corners_, self.corners_ + 1).array().exp()};
        if (self.movable_ == 0)
            return self.judge(self.moves_, timing);
        return self.judge(self.moves_.along(self.movedVertices(numbers.tail(self.movable_))), timing);
    }

    Eigen::MatrixXd movedVertices(const VectorXd &ways) const
    {
        Eigen::MatrixXd vertices = moves_.vertices();
        const Index joints = vertices.rows();
        for (Index corner = 0; corner < corners_; ++corner)
        {
            const Eigen::MatrixXd &from = moves_.vertices();
            const double reach = viaReach * std::min((from.col(corner + 1) - from.col(corner)).norm(),
                                                     (from.col(corner + 2) - from.col(corner + 1)).norm());
            vertices.col(corner + 1) +=
                reach / std::sqrt(static_cast<double>(joints)) * ways.segment(corner * joints, joints);
        }
        return vertices;
    }

    /// The logarithm of the duration, more if the proof fails. Only what is shorter than the best needs a proof: it
    /// takes longest.
    double judge(const OverlappedMoves &moves, const MoveTiming &timing)
    {
        ++evaluations_;
        const PolynomialTrajectory motion = moves.motion(timing);
        const double factor = moves.stretchToLimits(motion);
        const double duration = factor * motion.duration();
        if (duration >= best_->duration())
            return std::log(duration);
        ++proofs_;
        if (!proof_(motion))
            return std::log(best_->duration()) + refused;
        best_ = motion.stretched(factor);
        blended_ = true;
        return std::log(duration);
    }

    bool stopped() const { return options_.interrupted && options_.interrupted(); }

    const OverlappedMoves &moves_;
    const TrajectoryProof &proof_;
    const SmoothingOptions &options_;
    Index corners_;
    Index movable_ = 0;  ///< coordinates of vertices
    MoveTiming timing_;  ///< best overlaps of the bisection
    nlopt_opt optimizer_ = nullptr;
    std::optional<PolynomialTrajectory> best_;
    double stopDuration_ = 0.0;
    bool blended_ = false;
    int evaluations_ = 0, proofs_ = 0;
};
}  // namespace

OrFailure<SmoothedTrajectory> smoothTrajectory(const Eigen::MatrixXd &vertices, const std::vector<MotionLimits> &limits,
                                               const TrajectoryProof &proof, const SmoothingOptions &options)
{
    if (options.evaluations < 0 || options.viaNumbers < 0)
        return TrajectoryFailure::BadCount;
    const OrFailure<OverlappedMoves> moves = OverlappedMoves::along(vertices, limits);
    if (!moves)
        return moves.failure;
    SmoothingSearch search(*moves, proof, options);
    if (moves->segments() > 1)
    {
        search.bisect();
        search.optimize();
    }
    return search.result();
}
}  // namespace narrows
