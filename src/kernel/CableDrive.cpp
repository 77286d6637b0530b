// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/CableDrive.h"

#include <cmath>
#include <stdexcept>

#include <Eigen/Dense>

#include "kernel/JointCentres.h"

namespace narrows
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;
constexpr int mostSteps = 50;
constexpr int mostHalvings = 30;
constexpr double smallestStep = 1e-14;  // radians: what rounding leaves of a step

void checkPositive(double length, const char *what)
{
    if (!(length > 0.0) || !std::isfinite(length))
        throw std::invalid_argument(std::string(what) + " must be positive and finite");
}

/// Turns about y and z, with their derivatives.
struct Turns
{
    Matrix3d pitch;
    Matrix3d yaw;
    Matrix3d pitchRate;
    Matrix3d yawRate;
};

Turns turnsOf(const UniversalAngles &angles)
{
    const double ct = std::cos(angles.pitch);
    const double st = std::sin(angles.pitch);
    const double ca = std::cos(angles.yaw);
    const double sa = std::sin(angles.yaw);
    Turns turns;
    turns.pitch << ct, 0.0, st, 0.0, 1.0, 0.0, -st, 0.0, ct;
    turns.yaw << ca, -sa, 0.0, sa, ca, 0.0, 0.0, 0.0, 1.0;
    turns.pitchRate << -st, 0.0, ct, 0.0, 0.0, 0.0, -ct, 0.0, -st;
    turns.yawRate << -sa, -ca, 0.0, ca, -sa, 0.0, 0.0, 0.0, 0.0;
    return turns;
}

Matrix3d turnOf(const UniversalAngles &angles, UniversalOrder order)
{
    const Turns turns = turnsOf(angles);
    return order == UniversalOrder::PitchFirst ? turns.pitch * turns.yaw : turns.yaw * turns.pitch;
}

/// From the hole in the face before the joint to the one behind it (Eq. 18).
Vector3d across(const Vector3d &hole, const Matrix3d &turn)
{
    return turn * hole - Vector3d(-hole.x(), hole.y(), hole.z());
}

/// The three cables of a joint, and how far some angles are from yielding their lengths.
class JointFit
{
public:
    JointFit(const Vector3d *holes, UniversalOrder order, const Vector3d &lengths)
      : holes_(holes), order_(order), lengths_(lengths)
    {
    }

    Vector3d missing(const Vector2d &angles) const
    {
        const Matrix3d turn = turnOf({angles[0], angles[1]}, order_);
        Vector3d result;
        for (int k = 0; k < 3; ++k)
            result[k] = lengths_[k] - across(holes_[k], turn).norm();
        return result;
    }

    /// Derivative of the lengths by pitch and yaw.
    Eigen::Matrix<double, 3, 2> rates(const Vector2d &angles) const
    {
        const Turns turns = turnsOf({angles[0], angles[1]});
        const bool pitchFirst = order_ == UniversalOrder::PitchFirst;
        const Matrix3d turn = pitchFirst ? turns.pitch * turns.yaw : turns.yaw * turns.pitch;
        const Matrix3d byPitch = pitchFirst ? turns.pitchRate * turns.yaw : turns.yaw * turns.pitchRate;
        const Matrix3d byYaw = pitchFirst ? turns.pitch * turns.yawRate : turns.yawRate * turns.pitch;
        Eigen::Matrix<double, 3, 2> result;
        for (int k = 0; k < 3; ++k)
        {
            const Vector3d direction = across(holes_[k], turn).normalized();
            result.row(k) << direction.dot(byPitch * holes_[k]), direction.dot(byYaw * holes_[k]);
        }
        return result;
    }

private:
    const Vector3d *holes_;
    UniversalOrder order_;
    Vector3d lengths_;
};

/// Halves the step until it brings the lengths nearer; zero if no part of it does, which is so at the nearest angles.
Vector2d improving(const JointFit &fit, const Vector2d &angles, Vector2d step)
{
    const double now = fit.missing(angles).norm();
    for (int i = 0; i < mostHalvings; ++i, step *= 0.5)
        if (fit.missing(angles + step).norm() < now)
            return step;
    return Vector2d::Zero();
}

Vector2d fullStep(const JointFit &fit, const Vector2d &angles)
{
    return fit.rates(angles).colPivHouseholderQr().solve(fit.missing(angles));
}

/// Angles than which no others near them yield nearer lengths.
struct Nearest
{
    Vector2d angles;
    double residual;
    bool converged;
};

Nearest search(const JointFit &fit, Vector2d angles)
{
    bool converged = false;
    for (int i = 0; i < mostSteps && !converged; ++i)
    {
        Vector2d step = fullStep(fit, angles);
        if (step.norm() > smallestStep)
            step = improving(fit, angles, step);
        angles += step;
        converged = step.norm() <= smallestStep;
    }
    return {angles, fit.missing(angles).norm(), converged};
}
}  // namespace

std::string toString(CableStatus status)
{
    switch (status)
    {
        case CableStatus::Solved:
            return "solved";
        case CableStatus::NotFinite:
            return "not_finite";
        case CableStatus::Inconsistent:
            return "inconsistent";
        case CableStatus::FacesMeet:
            return "faces_meet";
        case CableStatus::NotConverged:
            return "not_converged";
    }
    throw std::invalid_argument("not a status of cables");
}

CableDrive::CableDrive(std::vector<double> linkLengths, double faceDistance, double holeRadius, UniversalOrder order)
  : linkLengths_(std::move(linkLengths)), faceDistance_(faceDistance), holeRadius_(holeRadius), order_(order)
{
    if (linkLengths_.empty())
        throw std::invalid_argument("cables need at least one link");
    for (const double length : linkLengths_)
        checkPositive(length, "a link's length");
    checkPositive(faceDistance, "the distance of the end faces");
    checkPositive(holeRadius, "the radius of the holes");
    for (int cable = 0; cable < cableCount(); ++cable)
        holes_.emplace_back(faceDistance, holeRadius * std::sin(holeAngle(cable)),
                            holeRadius * std::cos(holeAngle(cable)));
}

double CableDrive::holeAngle(int cable) const
{
    // The paper's hole 15b, of its fifth link of eight, is at 0; cable a is 120 degrees before b, c as many after.
    const int link = cable / 3;
    const int third = cable % 3 - 1;
    const int steps = link - linkCount() / 2 + third * linkCount();
    return 2.0 * pi * ((steps + cableCount()) % cableCount()) / cableCount();
}

double CableDrive::largestBend() const
{
    return 2.0 * std::atan2(faceDistance_, holeRadius_);
}

double CableDrive::lengthAcross(int cable, const Matrix3d &turn) const
{
    return across(holes_[cable], turn).norm();
}

double CableDrive::lengthAtJoint(int cable, const UniversalAngles &angles) const
{
    return lengthAcross(cable, turnOf(angles, order_));
}

void CableDrive::totalLengths(const Eigen::Ref<const Eigen::VectorXd> &angles, Eigen::VectorXd &lengths) const
{
    lengths.setZero(cableCount());
    for (int joint = 0; joint < linkCount(); ++joint)
    {
        const Matrix3d turn = turnOf({angles[2 * joint], angles[2 * joint + 1]}, order_);
        const double link = linkLengths_[joint] - 2.0 * faceDistance_;
        for (int cable = 3 * joint; cable < cableCount(); ++cable)
            lengths[cable] += lengthAcross(cable, turn) + link;
    }
}

JointSolution CableDrive::anglesAtJoint(int joint, const Vector3d &lengths, double tolerance) const
{
    if (!lengths.allFinite())
        return {CableStatus::NotFinite, {0.0, 0.0}, 0.0};
    const JointFit fit(&holes_[3 * joint], order_, lengths);
    Nearest best = search(fit, Vector2d::Zero());
    // Far from straight there are nearest angles that yield other lengths; the first step told at least the direction.
    const Vector2d direction = fullStep(fit, Vector2d::Zero()).normalized();
    for (const double share : {0.5, 1.0, 1.5})
        if (best.residual > tolerance)
        {
            const Nearest other = search(fit, share * largestBend() * direction);
            if (other.residual < best.residual)
                best = other;
        }

    // A long step may have gone round.
    const UniversalAngles angles{std::remainder(best.angles[0], 2.0 * pi), std::remainder(best.angles[1], 2.0 * pi)};
    JointSolution solution{CableStatus::Solved, angles, best.residual};
    if (best.residual > tolerance)
        solution.status = best.converged ? CableStatus::Inconsistent : CableStatus::NotConverged;
    else if (bendAngle(angles.pitch, angles.yaw) >= largestBend())
        solution.status = CableStatus::FacesMeet;
    return solution;
}

DriveSolution CableDrive::anglesFromTotals(const Eigen::Ref<const Eigen::VectorXd> &lengths, double tolerance) const
{
    if (lengths.size() != cableCount())
        throw std::invalid_argument("every cable needs a length");
    DriveSolution solution{CableStatus::Solved, -1, Eigen::VectorXd::Zero(2 * linkCount())};
    Eigen::VectorXd left = lengths;
    for (int joint = 0; joint < linkCount(); ++joint)
    {
        const double link = linkLengths_[joint] - 2.0 * faceDistance_;
        const JointSolution found = anglesAtJoint(joint, left.segment<3>(3 * joint).array() - link, tolerance);
        if (found.status != CableStatus::Solved)
        {
            solution.status = found.status;
            solution.joint = joint;
            return solution;
        }
        solution.angles[2 * joint] = found.angles.pitch;
        solution.angles[2 * joint + 1] = found.angles.yaw;
        const Matrix3d turn = turnOf(found.angles, order_);
        for (int cable = 3 * joint; cable < cableCount(); ++cable)
            left[cable] -= lengthAcross(cable, turn) + link;
    }
    return solution;
}
}  // namespace narrows
