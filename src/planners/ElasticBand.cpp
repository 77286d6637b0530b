// SPDX-License-Identifier: BSD-3-Clause
#include "planners/ElasticBand.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <ompl/base/ScopedState.h>

namespace narrows
{
namespace
{
constexpr int halvings = 4;            ///< of a move that is no good
constexpr double leastGain = 1e-4;     ///< of the whole, per sweep
constexpr double leastMove = 1e-9;     ///< of what two motions count, to be no rounding
constexpr double difference = 1e-5;    ///< radians, for derivatives of the clearance
constexpr double straightness = 1e-3;  ///< of the spacing: how far off the line a state may be that is left out

class Band
{
public:
    Band(const ob::SpaceInformationPtr &si, const JointChart &chart, const og::PathGeometric &path,
         const BandWish &wish)
      : si_(si), chart_(chart), wish_(wish), from_(si), to_(si)
    {
        read(path);
        for (const Eigen::VectorXd &x : band_)
            lack_.push_back(lack(x));
    }

    BandReport tighten(const ob::PlannerTerminationCondition &ptc)
    {
        BandReport report;
        report.before = report.after = total();
        while (report.sweeps < wish_.sweeps && !ptc)
        {
            const int moves = sweep(ptc);
            const double now = total(), gain = report.after - now;
            report.moves += moves;
            report.after = now;
            ++report.sweeps;
            if (!(gain > leastGain * now))
                break;
        }
        return report;
    }

    /// Leaves the ends of the path as they are.
    void write(og::PathGeometric &path)
    {
        dropStraight();
        og::PathGeometric result(si_, path.getState(0));
        for (std::size_t i = 1; i + 1 < band_.size(); ++i)
        {
            write(band_[i], from_.get());
            result.append(from_.get());
        }
        result.append(path.getState(static_cast<unsigned int>(path.getStateCount()) - 1));
        path = result;
    }

private:
    void read(const og::PathGeometric &path)
    {
        Eigen::VectorXd here, next, way;
        chart_.read(path.getState(0), here);
        band_.push_back(here);
        for (unsigned int i = 1; i < path.getStateCount(); ++i)
        {
            chart_.read(path.getState(i), next);
            chart_.shortWay(band_.back(), next, way);
            const int parts = std::max(1, static_cast<int>(std::ceil(way.norm() / wish_.spacing)));
            const Eigen::VectorXd begin = band_.back();
            for (int part = 1; part <= parts; ++part)
                band_.push_back(begin + way * (static_cast<double>(part) / parts));
        }
    }

    void write(const Eigen::VectorXd &x, ob::State *state) const
    {
        chart_.write(x, state->as<ob::RealVectorStateSpace::StateType>()->values);
    }

    double clearance(const Eigen::VectorXd &x)
    {
        write(x, to_.get());
        return si_->getStateValidityChecker()->clearance(to_.get());
    }

    /// Share of the wished clearance that is not there.
    double lack(const Eigen::VectorXd &x)
    {
        return wish_.clearance > 0.0 ? std::clamp(1.0 - clearance(x) / wish_.clearance, 0.0, 1.0) : 0.0;
    }

    double cost(const Eigen::VectorXd &a, double lackA, const Eigen::VectorXd &b, double lackB) const
    {
        return (b - a).norm() * (1.0 + 0.5 * (wish_.aversion - 1.0) * (lackA + lackB));
    }

    double costAround(std::size_t i, const Eigen::VectorXd &x, double lackThere) const
    {
        return cost(band_[i - 1], lack_[i - 1], x, lackThere) + cost(x, lackThere, band_[i + 1], lack_[i + 1]);
    }

    double total() const
    {
        double sum = 0.0;
        for (std::size_t i = 1; i < band_.size(); ++i)
            sum += cost(band_[i - 1], lack_[i - 1], band_[i], lack_[i]);
        return sum;
    }

    bool isFree(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
    {
        write(a, from_.get());
        write(b, to_.get());
        return si_->checkMotion(from_.get(), to_.get());
    }

    int sweep(const ob::PlannerTerminationCondition &ptc)
    {
        int moves = 0;
        for (std::size_t i = 1; i + 1 < band_.size() && !ptc; ++i)
        {
            const bool straightened = move(i, tension(i));
            const bool pushed = lack_[i] > 0.0 && move(i, push(i));
            moves += straightened || pushed ? 1 : 0;
        }
        return moves;
    }

    /// To the line between the neighbours, as far along it as now.
    Eigen::VectorXd tension(std::size_t i) const
    {
        const double before = (band_[i] - band_[i - 1]).norm(), behind = (band_[i + 1] - band_[i]).norm();
        if (!(before + behind > 0.0))
            return Eigen::VectorXd::Zero(band_[i].size());
        return band_[i - 1] + before / (before + behind) * (band_[i + 1] - band_[i - 1]) - band_[i];
    }

    /// Newton's step to the wished clearance along its gradient, no longer than the spacing.
    Eigen::VectorXd push(std::size_t i)
    {
        Eigen::VectorXd x = band_[i], gradient(x.size());
        const double here = clearance(x);
        for (Eigen::Index joint = 0; joint < x.size(); ++joint)
        {
            const double value = std::exchange(x[joint], x[joint] + difference);
            gradient[joint] = (clearance(x) - here) / difference;
            x[joint] = value;
        }
        const double square = gradient.squaredNorm();
        if (!(square > 0.0))
            return Eigen::VectorXd::Zero(x.size());
        const Eigen::VectorXd step = (wish_.clearance - here) / square * gradient;
        return step * std::min(1.0, wish_.spacing / step.norm());
    }

    bool move(std::size_t i, Eigen::VectorXd step)
    {
        const double now = costAround(i, band_[i], lack_[i]);
        for (int halved = 0; halved <= halvings; ++halved, step *= 0.5)
        {
            const Eigen::VectorXd x = band_[i] + step;
            const double lackThere = lack(x);
            if (costAround(i, x, lackThere) < now * (1.0 - leastMove) && isFree(band_[i - 1], x) &&
                isFree(x, band_[i + 1]))
            {
                band_[i] = x;
                lack_[i] = lackThere;
                return true;
            }
        }
        return false;
    }

    /// Leaves out states that are on the line between what is kept before and the next one.
    void dropStraight()
    {
        std::vector<Eigen::VectorXd> kept{band_.front()};
        for (std::size_t i = 1; i + 1 < band_.size(); ++i)
        {
            const Eigen::VectorXd line = band_[i + 1] - kept.back(), here = band_[i] - kept.back();
            const double square = line.squaredNorm();
            const double along = square > 0.0 ? std::clamp(here.dot(line) / square, 0.0, 1.0) : 0.0;
            const bool isStraight =
                (here - along * line).norm() <= straightness * wish_.spacing && chart_.unambiguousPart(line) >= 1.0;
            if (!isStraight || !isFree(kept.back(), band_[i + 1]))
                kept.push_back(band_[i]);
        }
        kept.push_back(band_.back());
        band_ = std::move(kept);
    }

    const ob::SpaceInformationPtr &si_;
    const JointChart &chart_;
    const BandWish wish_;
    ob::ScopedState<> from_, to_;
    std::vector<Eigen::VectorXd> band_;  ///< in the chart, unwrapped
    std::vector<double> lack_;           ///< of each
};
}  // namespace

BandReport tightenBand(const ob::SpaceInformationPtr &si, const JointChart &chart, og::PathGeometric &path,
                       const BandWish &wish, const ob::PlannerTerminationCondition &ptc)
{
    if (path.getStateCount() < 2)
        return {};
    Band band(si, chart, path, wish);
    const BandReport report = band.tighten(ptc);
    band.write(path);
    return report;
}
}  // namespace narrows
