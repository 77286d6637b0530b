// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// A joint with one degree of freedom. Its moving frame is (moving frame of the parent) * offset * motion(value).
struct SpatialJoint
{
    /// What a joint does.
    enum class Kind
    {
        Revolute,
        Prismatic
    };
    Kind kind = Kind::Revolute;  ///< turns about its axis (radians), or slides along it (length)
    int parent = -1;             ///< -1: the world. Always less than its own index
    Eigen::Isometry3d offset = Eigen::Isometry3d::Identity();  ///< this joint's frame in the parent's, at value 0
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();           ///< unit vector in this joint's frame
    std::optional<Interval> limits;                            ///< none: a revolute joint that turns freely
};

/// A link: all points within `radius` of a segment that is fixed in a joint's moving frame.
struct SpatialLink
{
    int joint;             ///< -1: fixed to the world
    Eigen::Vector3d from;  ///< where it begins, in the joint's moving frame
    Eigen::Vector3d to;    ///< where it ends, likewise
    double radius;         ///< >= 0
};

/// Two revolute joints whose axes meet and that together may bend by at most `maxAngle`:
/// acos(cos(first) cos(second)) <= maxAngle < pi / 2 (a convex set of the two angles).
struct UniversalLimit
{
    int first;        ///< a revolute joint
    int second;       ///< another one
    double maxAngle;  ///< radians
};

/// Kinematics of a spatial tree of joints that carry straight links: universal-joint chains, Denavit-Hartenberg arms,
/// gantries. A configuration is one value per joint (radians, or length units for prismatic joints). Immutable and
/// thread-safe.
class SpatialArm
{
public:
    static constexpr int Dim = 3;  ///< coordinates of a point

    /// Where everything is at one configuration.
    struct Placement
    {
        std::vector<Eigen::Isometry3d> frames;  ///< moving frame per joint
        std::vector<Eigen::Vector3d> points;    ///< link i lies between points[2 i] and points[2 i + 1]
    };

    /// \throws std::invalid_argument naming the joint or link if a parent does not precede its child, an axis is not a
    /// unit vector, an offset is not a rigid motion, a limit is missing (prismatic) or out of order, a prismatic joint
    /// has a revolute ancestor, a link is neither extended nor thick, a universal limit does not name two different
    /// revolute joints or an angle below pi / 2, or a number is not finite.
    SpatialArm(std::vector<SpatialJoint> joints, std::vector<SpatialLink> links,
               std::vector<UniversalLimit> universalLimits = {});

    /// How many values a configuration has: one per joint.
    int dimension() const { return static_cast<int>(joints_.size()); }
    /// How many links there are.
    int linkCount() const { return static_cast<int>(links_.size()); }
    /// The joints, parents before their children.
    const std::vector<SpatialJoint> &joints() const { return joints_; }
    /// The links.
    const std::vector<SpatialLink> &links() const { return links_; }
    /// Limits that two joints share.
    const std::vector<UniversalLimit> &universalLimits() const { return universalLimits_; }
    /// Bound on how far any point of the arm can be from where the first joint of its chain is, prismatic ways
    /// included.
    double reach() const { return reach_; }
    /// Whether two links are rigidly connected or meet at a joint, whatever the configuration; only other pairs can
    /// collide with each other.
    bool areNeighbours(int link, int other) const { return neighbours_[link * links_.size() + other]; }

    /// Forward kinematics. \pre q has dimension() values
    void place(const Eigen::Ref<const Eigen::VectorXd> &q, Placement &placement) const;

    /// For the motion q + t * delta, t in [0, 1], and any point of link i's segment: its way is at most lengths[i], its
    /// acceleration at most bends[i]; the link's angular velocity is at most turns[i] and its angular acceleration at
    /// most turns[i]^2 / 2.
    void motionBounds(const Eigen::Ref<const Eigen::VectorXd> &delta, Eigen::VectorXd &lengths, Eigen::VectorXd &bends,
                      Eigen::VectorXd &turns) const;

    /// Velocities of placement.points, and the angular velocity per link, under that motion where it is now.
    void velocities(const Placement &placement, const Eigen::Ref<const Eigen::VectorXd> &delta,
                    std::vector<Eigen::Vector3d> &points, std::vector<Eigen::Vector3d> &spins) const;

private:
    /// Orientation of a joint's moving frame in its parent's: fixed + sin(q) sine + (1 - cos(q)) cosine (Rodrigues).
    struct Rotation
    {
        Eigen::Matrix3d fixed;
        Eigen::Matrix3d sine;
        Eigen::Matrix3d cosine;
    };

    /// A vector fixed in a joint's moving frame: its length, and its distance from that joint's axis.
    struct Lever
    {
        double length;
        double perpendicular;
    };

    Lever lever(int joint, const Eigen::Vector3d &vector) const;
    void prepareJoint(int joint);
    void prepareLink(int link);
    void measureReach();

    std::vector<SpatialJoint> joints_;
    std::vector<SpatialLink> links_;
    std::vector<UniversalLimit> universalLimits_;
    std::vector<Rotation> rotations_;          ///< per joint
    std::vector<Eigen::Vector3d> directions_;  ///< per joint: a prismatic joint's axis in the world
    std::vector<Lever> hops_;                  ///< per joint: from its parent's frame to its own
    std::vector<Lever> extents_;               ///< per link: its farther end in its joint's frame
    std::vector<bool> neighbours_;             ///< linkCount() x linkCount()
    double reach_ = 0.0;
};

/// A snake: n links of universal joints, each turning about its own y axis (pitch) and then z axis (yaw), stretched
/// along x at zero; joint values are [slide,] pitch 1, yaw 1, pitch 2, yaw 2, ... (VDSM; tight maneuvering). \param
/// slide limits and direction (unit) of a base that moves along a line, if there is one \param maxAngle largest bend of
/// every universal joint; none: no limit
SpatialArm universalChain(const Eigen::Vector3d &base, const std::vector<double> &lengths, double radius,
                          const std::optional<std::pair<Eigen::Vector3d, Interval>> &slide = std::nullopt,
                          std::optional<double> maxAngle = std::nullopt);

/// One row of a Denavit-Hartenberg table in the standard (distal) convention: Rz(q + theta) Tz(d) Tx(a) Rx(alpha).
struct DenavitHartenberg
{
    double theta = 0.0;              ///< radians, about z, added to the joint's value
    double d = 0.0;                  ///< length along z
    double a = 0.0;                  ///< length along the turned x
    double alpha = 0.0;              ///< radians, about that x
    std::optional<Interval> limits;  ///< of the joint's value, radians; none: it turns freely
    double radius = 0.0;             ///< of the links along d and a
};

/// An arm of revolute joints; each row yields up to two links, along d and along a, where these are not 0.
SpatialArm denavitHartenbergArm(const Eigen::Isometry3d &base, const std::vector<DenavitHartenberg> &rows);
}  // namespace narrows
