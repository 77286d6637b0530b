// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace narrows
{
/// Where a convex function is least on [0, 1], to 1e-18: where its slope changes sign, found by halving.
template <class Slope>
double convexMinimum(const Slope &slope)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60 && low < high; ++i)
    {
        const double middle = 0.5 * (low + high);
        (slope(middle) < 0.0 ? low : high) = middle;
    }
    return high;
}

}  // namespace narrows
