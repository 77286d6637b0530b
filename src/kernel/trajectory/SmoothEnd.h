// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernel/trajectory/TrajectoryFailure.h"

namespace narrows
{
/// Which n and a make the paper's term end smoothly after T. For (n_v, a_v) and T = t_v the trajectory is then C1 or C2
/// at the via, since the term that stops there is all that jumps; for (n, a) and T = t_s it ends at rest.

/// The slope at the end vanishes iff a = T - ln T / ln n. Pole where that a is inadmissible: T <= 1, or
/// ln n >= ln T / (sqrt T - 1)^2.
/// \param n > 1
/// \param duration T, in the paper's unit of time
OrFailure<double> flatEnd(double n, double duration);

/// What the paper leaves free of a term that ends at its goal.
struct EndParameters
{
    double n;  ///< base of the powers, > 1
    double a;  ///< the paper's a
};

/// Slope and curvature vanish iff, besides, ln n = 2 / (T - 1): unique, free of poles. The third derivative cannot
/// vanish as well: it is ln n (ln n + 1)(ln n + 2) / T^3 in units of the term's own clock, > 0.
/// BadTime where T <= 1, or so near it that n is beyond doubles.
OrFailure<EndParameters> flatEndTwice(double duration);
}  // namespace narrows
