// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/JointCentres.h"
#include "kernel/PlanarArm.h"

namespace narrows
{
/// The joint centres O_1 .. O_{n+1} of a chain while its joint values go straight from one configuration to another, as
/// parabolas in t from 0 to 1, and how far from those they may be.
template <int D>
struct ChainMotion
{
    using Point = Eigen::Matrix<double, D, 1>;  ///< a place in the plane or in space

    std::vector<Point> begin;   ///< of each centre: its place at t = 0
    std::vector<Point> middle;  ///< at t = 1/2
    std::vector<Point> end;     ///< at t = 1
    /// Of each centre: the distance, at any t, from the parabola through the three places above, at most. Rises along
    /// the chain.
    std::vector<double> remainder;
};

/// The difference of a curve from the parabola through its places at 0, 1/2 and 1 is at most max |t (t - 1/2) (t - 1)|
/// / 6 = sqrt(3) / 216 times its greatest third derivative. Of a link that turns by w and with an angular acceleration
/// a, direction d, that is |d'''| <= |a'| + 3 |a| |w| + |w|^3. In the plane w is constant. In space w = sum q_j' a_j
/// over the axes a_j before it, each carried by the joints before that; both rates are taken where the chain is in the
/// middle, where what joints undo of each other's turns is known, and bounded from there on.
///
/// \pre the arm is a chain on a slide (absolute angles); from and to are configurations of it
///@{
void chainMotion(const PlanarArm &arm, const Eigen::VectorXd &from, const Eigen::VectorXd &to, ChainMotion<2> &motion);
void chainMotion(const ChainGeometry &chain, const Eigen::VectorXd &from, const Eigen::VectorXd &to,
                 ChainMotion<3> &motion);
///@}
}  // namespace narrows
