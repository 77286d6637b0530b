// SPDX-License-Identifier: BSD-3-Clause
#include "validity/TrajectoryVerdict.h"

#include <stdexcept>

#include "spaces/JointCoordinates.h"
#include "validity/ArmTravel.h"
#include "validity/JointRules.h"
#include "validity/TrajectorySpans.h"

namespace narrows
{
namespace
{
constexpr double positionTolerance = 1e-11;
constexpr double finestSagitta = 1e-7;  // of the reach: chords that still collide are refused

struct Chord
{
    std::size_t piece;
    double from, to;
    double sagitta;  ///< how far any point of the arm is from where the straight motion would have it
};

class ChordSampling
{
public:
    ChordSampling(const JointTrajectory &trajectory, const ArmStateSpace &space, bool selfCollision)
      : trajectory_(trajectory), spans_(trajectory), coordinates_(space), travel_(space, selfCollision)
    {
        if (trajectory.joints() != coordinates_.joints())
            throw std::invalid_argument("the trajectory has another number of joints than the space");
        for (std::size_t piece = 0; piece < spans_.pieces(); ++piece)
            add(piece, spans_.knots()[piece], spans_.knots()[piece + 1], chords_);
    }

    /// Halves all chords that stray by more. False if there are none.
    bool refine(double sagitta)
    {
        std::vector<Chord> finer;
        for (const Chord &chord : chords_)
        {
            if (chord.sagitta <= sagitta)
            {
                finer.push_back(chord);
                continue;
            }
            const double middle = 0.5 * (chord.from + chord.to);
            add(chord.piece, chord.from, middle, finer);
            add(chord.piece, middle, chord.to, finer);
        }
        const bool refined = finer.size() > chords_.size();
        chords_ = std::move(finer);
        return refined;
    }

    double largestSagitta() const
    {
        double largest = 0.0;
        for (const Chord &chord : chords_)
            largest = std::max(largest, chord.sagitta);
        return largest;
    }

    std::vector<Eigen::VectorXd> path() const
    {
        std::vector<Eigen::VectorXd> rows;
        JointTrajectory::States state;
        for (std::size_t i = 0; i <= chords_.size(); ++i)
        {
            trajectory_.at(i < chords_.size() ? chords_[i].from : chords_.back().to, state);
            rows.emplace_back(coordinates_.toConfiguration() * state.col(0));
        }
        return rows;
    }

    double reach() const { return travel_.reach(); }

private:
    void add(std::size_t piece, double from, double to, std::vector<Chord> &chords) const
    {
        Eigen::VectorXd speeds, accelerations;
        spans_.bounds(piece, {from, to}, speeds, accelerations);
        const double time = to - from;
        chords.push_back({piece, from, to,
                          travel_(0.125 * time * time * coordinates_.toConfiguration().cwiseAbs() * accelerations)});
    }

    const JointTrajectory &trajectory_;
    TrajectorySpans spans_;
    JointCoordinates coordinates_;
    ArmTravel travel_;
    std::vector<Chord> chords_;
};

bool withinLimits(const JointTrajectory &trajectory, const ArmStateSpace &space)
{
    for (std::size_t i = 0; i < space.joints().size(); ++i)
        if (const std::optional<Interval> &limits = space.joints()[i].limits)
        {
            const MotionPeaks peaks = motionPeaks(*trajectory.joint(static_cast<Eigen::Index>(i)), positionTolerance);
            if (peaks[0].lowest < limits->lower - proof::limitTolerance ||
                peaks[0].highest > limits->upper + proof::limitTolerance)
                return false;
        }
    return true;
}

bool isAboutContact(const Verdict &verdict)
{
    return verdict.reason == "collision" || verdict.reason == "self_collision" || verdict.reason == "not_certified";
}

bool isAtSample(const Verdict &verdict)
{
    return verdict.fraction == 0.0 || verdict.fraction == 1.0;
}

template <class Model, class Task>
TrajectoryVerdict judge(const Model &model, const Task &task, const ArmStateSpace &space,
                        const JointTrajectory &trajectory, std::size_t maxSamples)
{
    ChordSampling sampling(trajectory, space, model.selfCollision);
    TrajectoryVerdict result;
    sampling.refine(0.01 * sampling.reach());
    while (true)
    {
        const std::vector<Eigen::VectorXd> path = sampling.path();
        result.samples = path.size();
        result.chords = verify(model, task, path);
        const double sagitta = sampling.largestSagitta();
        result.clearance = result.chords.clearance - sagitta;
        if (result.chords.accepted && result.clearance > 0.0)
        {
            result.accepted = withinLimits(trajectory, space);
            if (!result.accepted)
                result.chords.reason = "limits";
            return result;
        }
        // Chords may touch what the motion itself keeps clear of; samples lie on it.
        const bool onChord = result.chords.accepted || (isAboutContact(result.chords) && !isAtSample(result.chords) &&
                                                        sagitta > finestSagitta * sampling.reach());
        if (!onChord || !sampling.refine(std::max(0.5 * result.chords.clearance, 0.25 * sagitta)))
            return result;
        if (result.samples > maxSamples)
        {
            result.chords.reason = "not_certified";
            return result;
        }
    }
}
}  // namespace

TrajectoryVerdict verifyTrajectory(const PlanarModel &model, const PlanarTask &task, const ArmStateSpace &space,
                                   const JointTrajectory &trajectory, std::size_t maxSamples)
{
    return judge(model, task, space, trajectory, maxSamples);
}

TrajectoryVerdict verifyTrajectory(const SpatialModel &model, const SpatialTask &task, const ArmStateSpace &space,
                                   const JointTrajectory &trajectory, std::size_t maxSamples)
{
    return judge(model, task, space, trajectory, maxSamples);
}
}  // namespace narrows
