// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace narrows
{
/// Points in the plane and what poles do to them, as plain arrays of equal length, so that compilers vectorise the
/// loops.
struct PoleArrays
{
    std::size_t count;  ///< of the points
    const double *x;    ///< of every point
    const double *y;    ///< of every point
    double *value;      ///< sum of P / C so far, per point
    double *forceX;     ///< its derivative by x so far
    double *forceY;     ///< its derivative by y so far
};

/// C = |p - center|^2 - squaredRadius: adds P / C and its gradient to every point and writes C.
void addCirclePole(const PoleArrays &points, double centerX, double centerY, double squaredRadius, double strength,
                   double *c);

/// C = ((x - centerX) inverseX)^4 + ((y - centerY) inverseY)^4 - 1, likewise.
void addQuarticPole(const PoleArrays &points, double centerX, double centerY, double inverseX, double inverseY,
                    double strength, double *c);

/// The same with any exponent.
void addPowerPole(const PoleArrays &points, double centerX, double centerY, double inverseX, double inverseY,
                  double exponent, double strength, double *c);
}  // namespace narrows
