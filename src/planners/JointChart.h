// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "spaces/ArmStateSpace.h"

namespace narrows
{
/// The coordinates in which Threader measures an arm's joint space. For planar arms whose joints all wrap: absolute
/// angles, whichever way the space counts them, because they make the better metric; for all others: the values of
/// states. They are not brought into any interval: full turns count, until states are made of them.
class JointChart
{
public:
    JointChart() = default;                           ///< of a space without joints
    explicit JointChart(const ArmStateSpace &space);  ///< of all its joints

    Eigen::Index dimension() const { return static_cast<Eigen::Index>(periods_.size()); }  ///< number of joints
    /// Of every coordinate 2 pi where full turns lead to the same posture, else +infinity.
    const Eigen::VectorXd &periods() const { return periods_; }
    ///@{
    /// Where coordinates are sampled: joint limits, else [-pi, pi].
    const Eigen::VectorXd &lower() const { return lower_; }
    const Eigen::VectorXd &upper() const { return upper_; }
    ///@}

    /// The coordinates of a state.
    void read(const ob::State *state, Eigen::VectorXd &x) const;
    /// The values of the state at x.
    void write(const Eigen::VectorXd &x, double *values) const;
    /// Brings coordinates that do not wrap into their bounds.
    void enforceLimits(Eigen::VectorXd &x) const;
    /// The kernel's configuration (planar arms: absolute angles), with the full turns of x.
    void toConfiguration(const Eigen::VectorXd &x, Eigen::VectorXd &q) const;
    /// The coordinates of a configuration, or those of a difference of configurations for a difference: it is linear.
    Eigen::VectorXd fromConfiguration(const Eigen::VectorXd &q) const;

    /// The derivative by the coordinates of a function whose derivative by the configuration is given.
    Eigen::VectorXd gradient(const Eigen::VectorXd &byConfiguration) const;

    /// The way on which every joint turns as far against the one that carries it.
    void wayOfTurns(const Eigen::VectorXd &turns, Eigen::VectorXd &way) const;

    /// to - from, the short way round for every coordinate.
    void shortWay(const Eigen::VectorXd &from, const Eigen::VectorXd &to, Eigen::VectorXd &way) const;
    /// Part of a way, in (0, 1], on which the space goes the same way between its ends: no joint turns by pi.
    double unambiguousPart(const Eigen::VectorXd &way) const;

private:
    double turn(const Eigen::VectorXd &way, Eigen::Index joint) const
    {
        const int parent = parents_[static_cast<std::size_t>(joint)];
        return parent < 0 ? way[joint] : way[joint] - way[parent];
    }

    bool statesAreRelative_ = false;  ///< to the coordinate of parents_: only if coordinates are absolute angles
    bool chartIsRelative_ = false;    ///< and the kernel's configuration is not
    std::vector<int> parents_;        ///< of every coordinate; -1 where values are not counted against another
    std::vector<int> turning_;        ///< of every coordinate that is an absolute angle; -1 for others
    std::vector<int> carriers_;       ///< the same for the kernel's configuration
    std::vector<char> wraps_;         ///< joints of the space
    Eigen::VectorXd periods_, lower_, upper_;
};
}  // namespace narrows
