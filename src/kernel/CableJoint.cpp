// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/CableJoint.h"

#include <cmath>

#include <Eigen/QR>

namespace narrows
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int mostSteps = 50;
constexpr int mostHalvings = 30;
constexpr double smallestStep = 1e-14;  // radians: what rounding leaves of a step

/// Turns about y and z, with their derivatives.
struct Turns
{
    explicit Turns(const UniversalAngles &angles)
    {
        const double ct = std::cos(angles.pitch);
        const double st = std::sin(angles.pitch);
        const double ca = std::cos(angles.yaw);
        const double sa = std::sin(angles.yaw);
        pitch << ct, 0.0, st, 0.0, 1.0, 0.0, -st, 0.0, ct;
        yaw << ca, -sa, 0.0, sa, ca, 0.0, 0.0, 0.0, 1.0;
        pitchRate << -st, 0.0, ct, 0.0, 0.0, 0.0, -ct, 0.0, -st;
        yawRate << -sa, -ca, 0.0, ca, -sa, 0.0, 0.0, 0.0, 0.0;
    }

    Matrix3d pitch;
    Matrix3d yaw;
    Matrix3d pitchRate;
    Matrix3d yawRate;
};

Matrix3d product(const Matrix3d &pitch, const Matrix3d &yaw, UniversalOrder order)
{
    return order == UniversalOrder::PitchFirst ? pitch * yaw : yaw * pitch;
}
}  // namespace

Matrix3d turnOf(const UniversalAngles &angles, UniversalOrder order)
{
    const Turns turns(angles);
    return product(turns.pitch, turns.yaw, order);
}

Vector3d CableFit::missing(const Vector2d &angles) const
{
    const Matrix3d turn = turnOf({angles[0], angles[1]}, order_);
    Vector3d result;
    for (int k = 0; k < 3; ++k)
        result[k] = lengths_[k] - cableAcross(holes_[k], turn).norm();
    return result;
}

Vector2d CableFit::fullStep(const Vector2d &angles) const
{
    const Turns turns({angles[0], angles[1]});
    const Matrix3d turn = product(turns.pitch, turns.yaw, order_);
    const Matrix3d byPitch = product(turns.pitchRate, turns.yaw, order_);
    const Matrix3d byYaw = product(turns.pitch, turns.yawRate, order_);
    Eigen::Matrix<double, 3, 2> rates;
    Vector3d missing;
    for (int k = 0; k < 3; ++k)
    {
        const Vector3d &hole = holes_[k];
        const Vector3d cable = cableAcross(hole, turn);
        const Vector3d direction = cable.normalized();
        rates.row(k) << direction.dot(byPitch * hole), direction.dot(byYaw * hole);
        missing[k] = lengths_[k] - cable.norm();
    }
    return rates.colPivHouseholderQr().solve(missing);
}

Vector2d CableFit::improving(const Vector2d &angles, Vector2d step) const
{
    const double now = missing(angles).norm();
    for (int i = 0; i < mostHalvings; ++i, step *= 0.5)
        if (missing(angles + step).norm() < now)
            return step;
    return Vector2d::Zero();
}

CableFit::Nearest CableFit::nearest(const Vector2d &start) const
{
    Vector2d angles = start;
    bool converged = false;
    for (int i = 0; i < mostSteps && !converged; ++i)
    {
        Vector2d step = fullStep(angles);
        if (step.norm() > smallestStep)
            step = improving(angles, step);
        angles += step;
        converged = step.norm() <= smallestStep;
    }
    return {angles, missing(angles).norm(), converged};
}
}  // namespace narrows
