// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/chain/ChainMotion.h"

#include <cmath>

#include <Eigen/Geometry>

namespace narrows
{
namespace
{
using Eigen::Vector3d;
using Eigen::VectorXd;

const double remainderShare = std::sqrt(3.0) / 216.0;

/// The axes of a link, as columns, and its angular velocity with two derivatives by t: where it is, and bounds of those
/// for t from 0 to 1 if that is at 1/2.
struct TurningFrame
{
    Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    Vector3d spin = Vector3d::Zero();
    Vector3d spin1 = Vector3d::Zero();
    Vector3d spin2 = Vector3d::Zero();
    double most = 0.0;
    double most1 = 0.0;
    double most2 = 0.0;
    double most3 = 0.0;  ///< of the third derivative

    /// Turns two of its axes about the third.
    static void turn(Vector3d &first, Vector3d &second, double angle)
    {
        const double c = std::cos(angle), s = std::sin(angle);
        const Vector3d before = first;
        first = c * before + s * second;
        second = c * second - s * before;
    }

    /// One more joint has a rate, about an axis that the frame carries: its derivatives are the axis' own.
    void addRate(const Vector3d &axis, double rate)
    {
        most3 += std::abs(rate) * thirdMost();
        const Vector3d once = spin.cross(axis);
        spin2 += rate * (spin1.cross(axis) + spin.cross(once));
        spin1 += rate * once;
        spin += rate * axis;
        most2 = spin2.norm() + 0.5 * most3;
        most1 = spin1.norm() + 0.5 * most2;
        most = spin.norm() + 0.5 * most1;
    }

    /// The third derivative of x.
    Vector3d third() const
    {
        const Vector3d once = spin.cross(x);
        return spin2.cross(x) + 2.0 * spin1.cross(once) + spin.cross(spin1.cross(x) + spin.cross(once));
    }

    /// Bounds on the third and fourth derivatives of unit vectors that the frame carries.
    double thirdMost() const { return most2 + 3.0 * most1 * most + most * most * most; }
    double fourthMost() const
    {
        const double square = most * most;
        return most3 + 4.0 * most2 * most + 3.0 * most1 * most1 + 6.0 * most1 * square + square * square;
    }
};

void place(const ChainGeometry &chain, const VectorXd &values, std::vector<Vector3d> &centres)
{
    centres.assign(chain.lengths.size() + 1, chain.origin + values[0] * chain.axes.col(0));
    TurningFrame frame;
    for (std::size_t i = 0; i < chain.lengths.size(); ++i)
    {
        const Eigen::Index joint = static_cast<Eigen::Index>(2 * i + 1);
        TurningFrame::turn(frame.z, frame.x, values[joint]);
        TurningFrame::turn(frame.x, frame.y, values[joint + 1]);
        centres[i + 1] = centres[i] + chain.lengths[i] * frame.x;
    }
}
}  // namespace

void chainMotion(const PlanarArm &arm, const VectorXd &from, const VectorXd &to, ChainMotion<2> &motion)
{
    arm.place(from, motion.begin);
    arm.place(0.5 * (from + to), motion.middle);
    arm.place(to, motion.end);
    motion.remainder.assign(motion.begin.size(), 0.0);
    for (std::size_t i = 1; i < motion.begin.size(); ++i)
    {
        const Eigen::Index joint = static_cast<Eigen::Index>(i);
        const double third = arm.links()[i - 1].length * std::pow(std::abs(to[joint] - from[joint]), 3.0);
        motion.remainder[i] = motion.remainder[i - 1] + remainderShare * third;
    }
}

void chainMotion(const ChainGeometry &chain, const VectorXd &from, const VectorXd &to, ChainMotion<3> &motion)
{
    place(chain, from, motion.begin);
    place(chain, to, motion.end);
    const VectorXd half = 0.5 * (from + to), rates = to - from;
    motion.middle.assign(chain.lengths.size() + 1, chain.origin + half[0] * chain.axes.col(0));
    motion.remainder.assign(chain.lengths.size() + 1, 0.0);
    TurningFrame frame;
    Vector3d third = Vector3d::Zero();
    double fourthMost = 0.0;
    for (std::size_t i = 0; i < chain.lengths.size(); ++i)
    {
        const Eigen::Index joint = static_cast<Eigen::Index>(2 * i + 1);
        frame.addRate(frame.y, rates[joint]);
        TurningFrame::turn(frame.z, frame.x, half[joint]);
        frame.addRate(frame.z, rates[joint + 1]);
        TurningFrame::turn(frame.x, frame.y, half[joint + 1]);
        motion.middle[i + 1] = motion.middle[i] + chain.lengths[i] * frame.x;
        third += chain.lengths[i] * frame.third();
        fourthMost += chain.lengths[i] * frame.fourthMost();
        motion.remainder[i + 1] = remainderShare * (third.norm() + 0.5 * fourthMost);
    }
}
}  // namespace narrows
