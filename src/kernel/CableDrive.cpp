// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/CableDrive.h"

#include <cmath>
#include <stdexcept>

#include "kernel/JointCentres.h"

namespace narrows
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

void checkPositive(double length, const char *what)
{
    if (!(length > 0.0) || !std::isfinite(length))
        throw std::invalid_argument(std::string(what) + " must be positive and finite");
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
    return 2.0 * M_PI * ((steps + cableCount()) % cableCount()) / cableCount();
}

double CableDrive::largestBend() const
{
    return 2.0 * std::atan2(faceDistance_, holeRadius_);
}

double CableDrive::lengthAtJoint(int cable, const UniversalAngles &angles) const
{
    return cableAcross(holes_[cable], turnOf(angles, order_)).norm();
}

void CableDrive::totalLengths(const Eigen::Ref<const Eigen::VectorXd> &angles, Eigen::VectorXd &lengths) const
{
    lengths.setZero(cableCount());
    for (int joint = 0; joint < linkCount(); ++joint)
    {
        const Matrix3d turn = turnOf({angles[2 * joint], angles[2 * joint + 1]}, order_);
        const double link = linkLengths_[joint] - 2.0 * faceDistance_;
        for (int cable = 3 * joint; cable < cableCount(); ++cable)
            lengths[cable] += cableAcross(holes_[cable], turn).norm() + link;
    }
}

JointSolution CableDrive::anglesAtJoint(int joint, const Vector3d &lengths, double tolerance) const
{
    if (!lengths.allFinite())
        return {CableStatus::NotFinite, {0.0, 0.0}, 0.0};
    const CableFit fit(&holes_[3 * joint], order_, lengths);
    CableFit::Nearest best = fit.nearest(Vector2d::Zero());
    // Far from straight there are nearest angles that yield other lengths; the first step told at least the direction.
    const Vector2d direction = fit.fullStep(Vector2d::Zero()).normalized();
    for (const double share : {0.5, 1.0, 1.5})
        if (best.residual > tolerance)
        {
            const CableFit::Nearest other = fit.nearest(share * largestBend() * direction);
            if (other.residual < best.residual)
                best = other;
        }

    // A long step may have gone round.
    const UniversalAngles angles{std::remainder(best.angles[0], 2.0 * M_PI),
                                 std::remainder(best.angles[1], 2.0 * M_PI)};
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
            left[cable] -= cableAcross(holes_[cable], turn).norm() + link;
    }
    return solution;
}
}  // namespace narrows
