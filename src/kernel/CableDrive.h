// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/CableJoint.h"

namespace narrows
{
/// How the search for the angles that belong to cable lengths ended.
enum class CableStatus
{
    Solved,
    NotFinite,     ///< a length is not a finite number
    Inconsistent,  ///< no angles were found that yield these lengths; those that are given come nearest
    FacesMeet,     ///< the angles that yield them bend a joint so far that its end faces would meet
    NotConverged
};

/// "solved", "not_finite", ...
std::string toString(CableStatus status);

/// A joint's answer to the lengths of its cables.
struct JointSolution
{
    CableStatus status;      ///< whether the angles follow from the lengths
    UniversalAngles angles;  ///< the nearest ones found
    double residual;         ///< root of the sum of squared differences of the three lengths
};

/// The whole drive's answer to the lengths of its cables.
struct DriveSolution
{
    CableStatus status;      ///< of the first joint that is not solved
    int joint;               ///< which one that is; -1 if all are solved
    Eigen::VectorXd angles;  ///< pitch 1, yaw 1, pitch 2, ...; zero from the first joint that is not solved
};

/// The cables of a chain of universal joints (VDSM, Machines 10 (2022) 1030, Section 5.2, Eq. 16-21): three per link,
/// which end at the link that they drive and run through holes in all links before it. The holes of cables a, b, c of
/// one link are 120 degrees apart, the links' holes share out these 120 degrees: 24 holes at 15 degrees for the paper's
/// eight links.
///
/// Links, joints and cables are counted from 0; joint i carries link i; cable 3 j + k drives link j (k = 0, 1, 2: a, b,
/// c) and passes joints 0 .. j. The angle of a hole is counted from z towards y. Immutable and thread-safe.
class CableDrive
{
public:
    /// \param linkLengths not empty, all > 0
    /// \param faceDistance d: from a joint's centre to the end faces of the links on both sides; the paper prints no
    /// value
    /// \param holeRadius r: from a link's axis to the holes; neither
    /// \throws std::invalid_argument if a length is not positive or not finite
    explicit CableDrive(std::vector<double> linkLengths, double faceDistance = 30.0, double holeRadius = 55.0,
                        UniversalOrder order = UniversalOrder::PitchFirst);

    int linkCount() const { return static_cast<int>(linkLengths_.size()); }  ///< how many links, and joints
    int cableCount() const { return 3 * linkCount(); }                       ///< three a link
    /// 27 - 3 i for the paper's eight links and its joint i, which is this one's i - 1.
    int cablesThrough(int joint) const { return 3 * (linkCount() - joint); }
    /// phi, in [0, 2 pi).
    double holeAngle(int cable) const;
    /// The bend at which the faces of a joint would meet where the holes are: 2 atan(d / r). Lengths stand for angles
    /// uniquely only below it.
    double largestBend() const;

    /// The part of a cable between the end faces of one joint (Eq. 16-20).
    double lengthAtJoint(int cable, const UniversalAngles &angles) const;

    /// Lengths of all cables from the first joint's centre on, as the paper counts them: at every joint that the cable
    /// passes, the part between its faces and L_i - 2 d for the link that it carries (Eq. 21).
    /// \param angles pitch 1, yaw 1, pitch 2, ...
    void totalLengths(const Eigen::Ref<const Eigen::VectorXd> &angles, Eigen::VectorXd &lengths) const;

    /// The angles of joint j from the parts at it of the three cables that end at link j, by Gauss-Newton from the
    /// straight joint and, if that does not find them, from bent ones.
    /// \param tolerance largest residual that is still called consistent, a length
    JointSolution anglesAtJoint(int joint, const Eigen::Vector3d &lengths, double tolerance = 1e-9) const;

    /// All angles from all total lengths, joint by joint from the base.
    /// \throws std::invalid_argument if there are not as many lengths as cables
    DriveSolution anglesFromTotals(const Eigen::Ref<const Eigen::VectorXd> &lengths, double tolerance = 1e-9) const;

private:
    std::vector<double> linkLengths_;
    double faceDistance_;
    double holeRadius_;
    UniversalOrder order_;
    std::vector<Eigen::Vector3d> holes_;  ///< per cable, in the face behind a joint, seen from that link (Eq. 17)
};
}  // namespace narrows
