// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace narrows
{
/// Which of its two angles a universal joint turns by first.
enum class UniversalOrder
{
    PitchFirst,  ///< Rot(y, pitch) Rot(z, yaw): universalChain()
    YawFirst     ///< Rot(z, alpha) Rot(y, theta): Eq. 1 of VDSM, alpha its yaw, theta its pitch
};

/// Angles of a universal joint, radians.
struct UniversalAngles
{
    double pitch;  ///< about y
    double yaw;    ///< about z
};

/// How the link behind a universal joint is turned against the one before it.
Eigen::Matrix3d turnOf(const UniversalAngles &angles, UniversalOrder order);

/// A cable between the faces of a joint, as a vector seen from the link before it (Eq. 16-18).
/// \param hole in the face behind the joint, seen from the link behind it
inline Eigen::Vector3d cableAcross(const Eigen::Vector3d &hole, const Eigen::Matrix3d &turn)
{
    return turn * hole - Eigen::Vector3d(-hole.x(), hole.y(), hole.z());
}

/// Three cables of a joint that shall have given lengths.
class CableFit
{
public:
    /// Angles than which no others near them yield nearer lengths.
    struct Nearest
    {
        Eigen::Vector2d angles;  ///< pitch, yaw
        double residual;         ///< root of the sum of squared differences of the lengths
        bool converged;          ///< whether the search has settled
    };

    /// \param holes three, which must outlive this
    CableFit(const Eigen::Vector3d *holes, UniversalOrder order, const Eigen::Vector3d &lengths)
      : holes_(holes), order_(order), lengths_(lengths)
    {
    }

    /// Gauss-Newton; steps are halved until they bring the lengths nearer.
    Nearest nearest(const Eigen::Vector2d &start) const;
    /// The first step from there, not halved.
    Eigen::Vector2d fullStep(const Eigen::Vector2d &angles) const;

private:
    /// What the lengths lack at some angles.
    Eigen::Vector3d missing(const Eigen::Vector2d &angles) const;
    /// Zero if no part of the step brings the lengths nearer.
    Eigen::Vector2d improving(const Eigen::Vector2d &angles, Eigen::Vector2d step) const;

    const Eigen::Vector3d *holes_;
    UniversalOrder order_;
    Eigen::Vector3d lengths_;
};
}  // namespace narrows
