// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/trajectory/OverlappedMoves.h"

#include <array>

#include "kernel/trajectory/StopAndGo.h"

namespace narrows
{
namespace
{
constexpr double shortestPiece = 1e-12;    // of the duration; what is shorter is rounding
constexpr double limitSlack = 1.0 + 1e-9;  // for the rounding of what is evaluated later

/// A move from 0 to 1 at its place in time: where its phases begin and end, and its state there.
struct PlacedMove
{
    static constexpr std::size_t phases = 7;

    PlacedMove(const JerkLimitedMove &move, double slowness, double begin)
    {
        const double rise = slowness * move.jerkTime, steady = slowness * move.steadyTime;
        const double cruise = slowness * move.cruiseTime;
        // From the distance, which is 1: phases add up to it whatever the rounding of their times.
        const double jerk = 1.0 / (rise * (rise + steady) * (2.0 * rise + steady + cruise));
        const double times[] = {rise, steady, rise, cruise, rise, steady, rise};
        const double jerks[] = {jerk, 0.0, -jerk, 0.0, -jerk, 0.0, jerk};
        knots[0] = begin;
        Series<3> state{};
        for (std::size_t i = 0; i < phases; ++i)
        {
            state[3] = jerks[i];
            states[i] = state;
            knots[i + 1] = knots[i] + times[i];
            state = after(state, times[i]);
        }
    }

    static Series<3> after(const Series<3> &state, double time)
    {
        return {state[0] + time * (state[1] + time * (0.5 * state[2] + time * state[3] / 6.0)),
                state[1] + time * (state[2] + 0.5 * time * state[3]), state[2] + time * state[3], state[3]};
    }

    /// Its state at t, in the phase that holds the time `within`.
    Series<3> at(double t, double within) const
    {
        std::size_t phase = 0;
        while (phase + 1 < phases && knots[phase + 1] <= within)
            ++phase;
        return after(states[phase], t - knots[phase]);
    }

    double begin() const { return knots.front(); }
    double end() const { return knots.back(); }

    std::array<double, phases + 1> knots;
    std::array<Series<3>, phases> states;
};

std::vector<PlacedMove> placed(const std::vector<JerkLimitedMove> &moves, const MoveTiming &timing)
{
    std::vector<PlacedMove> result;
    result.reserve(moves.size());
    double begin = 0.0, before = 0.0;
    for (std::size_t k = 0; k < moves.size(); ++k)
    {
        const Eigen::Index index = static_cast<Eigen::Index>(k);
        const double duration = timing.slowness[index] * moves[k].duration();
        if (k > 0)
            begin += before - timing.overlaps[index - 1] * std::min(before, duration);
        result.emplace_back(moves[k], timing.slowness[index], begin);
        before = duration;
    }
    return result;
}

/// Where any phase of any move begins or ends, each once.
std::vector<double> allKnots(const std::vector<PlacedMove> &moves)
{
    std::vector<double> knots;
    for (const PlacedMove &move : moves)
        knots.insert(knots.end(), move.knots.begin(), move.knots.end());
    std::sort(knots.begin(), knots.end());
    const double near = shortestPiece * knots.back();
    knots.erase(std::unique(knots.begin(), knots.end(), [near](double a, double b) { return b - a <= near; }),
                knots.end());
    return knots;
}
}  // namespace

OverlappedMoves::OverlappedMoves(Eigen::MatrixXd vertices, std::vector<MotionLimits> limits)
  : vertices_(std::move(vertices)), limits_(std::move(limits))
{
    for (Eigen::Index k = 0; k < segments(); ++k)
    {
        // The segment's own limits: those of the joint that reaches one first.
        constexpr double infinity = std::numeric_limits<double>::infinity();
        MotionLimits own{infinity, infinity, infinity};
        for (Eigen::Index i = 0; i < vertices_.rows(); ++i)
        {
            const double way = std::abs(vertices_(i, k + 1) - vertices_(i, k));
            const MotionLimits &joint = limits_[static_cast<std::size_t>(i)];
            own.velocity = std::min(own.velocity, joint.velocity / way);
            own.acceleration = std::min(own.acceleration, joint.acceleration / way);
            own.jerk = std::min(own.jerk, joint.jerk / way);
        }
        moves_.push_back(fastestMove(1.0, own));
    }
}

OrFailure<OverlappedMoves> OverlappedMoves::along(const Eigen::MatrixXd &vertices,
                                                  const std::vector<MotionLimits> &limits)
{
    // Refused is what the motion with stops is refused for.
    if (const OrFailure<PolynomialTrajectory> stops = sevenPhaseStops(vertices, limits); !stops)
        return stops.failure;
    return OverlappedMoves(distinctVertices(vertices), limits);
}

MoveTiming OverlappedMoves::stops() const
{
    return {Eigen::VectorXd::Zero(segments() - 1), Eigen::VectorXd::Ones(segments())};
}

PolynomialTrajectory OverlappedMoves::motion(const MoveTiming &timing) const
{
    const std::vector<PlacedMove> moves = placed(moves_, timing);
    const std::vector<double> knots = allKnots(moves);
    std::vector<PolynomialTrajectory::Piece> pieces(knots.size() - 1);
    std::size_t done = 0;  // moves that have ended before the piece
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        const double t = knots[i], middle = 0.5 * (t + knots[i + 1]);
        while (done + 1 < moves.size() && moves[done].end() <= middle)
            ++done;
        Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(vertices_.rows(), 4);
        coefficients.col(0) = vertices_.col(static_cast<Eigen::Index>(done));
        for (std::size_t k = done; k < moves.size() && moves[k].begin() < middle; ++k)
        {
            const Series<3> state = moves[k].at(t, middle);
            const Eigen::RowVector4d terms(state[0], state[1], 0.5 * state[2], state[3] / 6.0);
            const Eigen::Index column = static_cast<Eigen::Index>(k);
            coefficients += (vertices_.col(column + 1) - vertices_.col(column)) * terms;
        }
        pieces[i] = {knots[i + 1] - t, std::move(coefficients)};
    }
    return PolynomialTrajectory(std::move(pieces));
}

double OverlappedMoves::stretchToLimits(const PolynomialTrajectory &motion) const
{
    double speed = 0.0, acceleration = 0.0, jerk = 0.0;  // the largest shares of their limits
    for (const PolynomialTrajectory::Piece &piece : motion.pieces())
        for (Eigen::Index i = 0; i < vertices_.rows(); ++i)
        {
            const MotionLimits &own = limits_[static_cast<std::size_t>(i)];
            const double v = piece.coefficients(i, 1), a = 2.0 * piece.coefficients(i, 2);
            const double j = 6.0 * piece.coefficients(i, 3), last = a + piece.duration * j;
            speed = std::max(speed, std::abs(v + 0.5 * piece.duration * (a + last)) / own.velocity);
            if (a * last < 0.0)  // the speed is extreme where the acceleration vanishes
                speed = std::max(speed, std::abs(v - 0.5 * a * a / j) / own.velocity);
            acceleration = std::max({acceleration, std::abs(a) / own.acceleration, std::abs(last) / own.acceleration});
            jerk = std::max(jerk, std::abs(j) / own.jerk);
        }
    return limitSlack * std::max({speed, std::sqrt(acceleration), std::cbrt(jerk)});
}
}  // namespace narrows
