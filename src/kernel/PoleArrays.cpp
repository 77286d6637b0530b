// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PoleArrays.h"

#include <cmath>

// Two versions of each loop, one of them chosen when the program starts. Neither fuses multiplication and addition, so
// that both give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define NARROWS_MULTIVERSIONED __attribute__((target_clones("avx2", "default")))
#else
#define NARROWS_MULTIVERSIONED
#endif

namespace narrows
{
// Parameters, not members of a struct: only there does "restrict" convince the compiler that the arrays do not overlap.
NARROWS_MULTIVERSIONED
static void addCircle(std::size_t count, const double *__restrict x, const double *__restrict y,
                      double *__restrict value, double *__restrict forceX, double *__restrict forceY,
                      double *__restrict c, double centerX, double centerY, double squaredRadius, double strength)
{
    for (std::size_t i = 0; i < count; ++i)
    {
        const double dx = x[i] - centerX;
        const double dy = y[i] - centerY;
        const double pole = dx * dx + dy * dy - squaredRadius;
        const double inverse = 1.0 / pole;
        const double term = strength * inverse;
        const double slope = -2.0 * term * inverse;
        c[i] = pole;
        value[i] += term;
        forceX[i] += slope * dx;
        forceY[i] += slope * dy;
    }
}

NARROWS_MULTIVERSIONED
static void addQuartic(std::size_t count, const double *__restrict x, const double *__restrict y,
                       double *__restrict value, double *__restrict forceX, double *__restrict forceY,
                       double *__restrict c, double centerX, double centerY, double inverseX, double inverseY,
                       double strength)
{
    for (std::size_t i = 0; i < count; ++i)
    {
        const double u = (x[i] - centerX) * inverseX;
        const double v = (y[i] - centerY) * inverseY;
        const double uCubed = u * u * u;
        const double vCubed = v * v * v;
        const double pole = uCubed * u + vCubed * v - 1.0;
        const double inverse = 1.0 / pole;
        const double term = strength * inverse;
        const double slope = -4.0 * term * inverse;
        c[i] = pole;
        value[i] += term;
        forceX[i] += slope * uCubed * inverseX;
        forceY[i] += slope * vCubed * inverseY;
    }
}

void addCirclePole(const PoleArrays &points, double centerX, double centerY, double squaredRadius, double strength,
                   double *c)
{
    addCircle(points.count, points.x, points.y, points.value, points.forceX, points.forceY, c, centerX, centerY,
              squaredRadius, strength);
}

void addQuarticPole(const PoleArrays &points, double centerX, double centerY, double inverseX, double inverseY,
                    double strength, double *c)
{
    addQuartic(points.count, points.x, points.y, points.value, points.forceX, points.forceY, c, centerX, centerY,
               inverseX, inverseY, strength);
}

void addPowerPole(const PoleArrays &points, double centerX, double centerY, double inverseX, double inverseY,
                  double exponent, double strength, double *c)
{
    for (std::size_t i = 0; i < points.count; ++i)
    {
        const double u = (points.x[i] - centerX) * inverseX;
        const double v = (points.y[i] - centerY) * inverseY;
        const double uPower = std::pow(std::abs(u), exponent - 1.0);
        const double vPower = std::pow(std::abs(v), exponent - 1.0);
        const double pole = uPower * std::abs(u) + vPower * std::abs(v) - 1.0;
        const double term = strength / pole;
        const double slope = -exponent * term / pole;
        c[i] = pole;
        points.value[i] += term;
        points.forceX[i] += slope * std::copysign(uPower, u) * inverseX;
        points.forceY[i] += slope * std::copysign(vPower, v) * inverseY;
    }
}
}  // namespace narrows
