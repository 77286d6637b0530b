// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "kernel/EdgedPole.h"
#include "kernel/MeshGeometry.h"

namespace narrows
{
/// An obstacle as a source of poles.
struct SpatialPole
{
    std::variant<Sphere, Capsule, Cylinder, EdgedPole, MeshGeometry> shape;  ///< as the pole sees it
    double size;                                                             ///< 2 R, see SpatialRepulsionModel.h

    /// The clearance that its pole is a function of.
    /// \param guess as for MeshGeometry::nearest
    SpatialTerm smoothClearance(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double linkRadius,
                                int &guess) const;
    /// The exact one, negative where they touch.
    SpatialTerm clearance(const Eigen::Vector3d &a, const Eigen::Vector3d &b, double linkRadius) const;
};

/// One side of a joint's limits: C = sign * (q[joint] - bound).
struct SpatialLimitPole
{
    double sign;   ///< +1 above a lower bound, -1 below an upper one
    int joint;     ///< index in the configuration
    double bound;  ///< radians, or length of a slide
};

/// All that a spatial arm can have poles of, worked out once and shared by every Repulsion of the arm.
class SpatialPoles
{
public:
    /// Refers to nothing: obstacles and arm are copied.
    explicit SpatialPoles(const SpatialModel &model);

    const SpatialArm &arm() const { return arm_; }                            ///< the arm they are of
    const std::vector<SpatialPole> &obstacles() const { return obstacles_; }  ///< in the model's order
    const std::vector<SpatialLimitPole> &limits() const { return limits_; }   ///< sides of joint limits that are finite
    const std::vector<std::pair<int, int>> &pairs() const { return pairs_; }  ///< links that must not touch
    /// The names that RepulsionModel::groups promises.
    const std::vector<std::string> &groups() const { return groups_; }
    int limitGroup() const { return limitGroup_; }  ///< index of "limits"; -1 if there are none
    int selfGroup() const { return selfGroup_; }    ///< index of "self"; -1 if there are no pairs
    double pairSize() const { return pairSize_; }   ///< 2 R between links

private:
    void addLimits();
    void addPairs();

    SpatialArm arm_;
    std::vector<SpatialPole> obstacles_;
    std::vector<SpatialLimitPole> limits_;
    std::vector<std::pair<int, int>> pairs_;
    std::vector<std::string> groups_;
    int limitGroup_ = -1;
    int selfGroup_ = -1;
    double pairSize_;
};

/// A function of where two links lie, and its derivative.
struct SpatialPairTerm
{
    double value;      ///< of the function
    EndForces first;   ///< its derivative by the first link
    EndForces second;  ///< its derivative by the second
};

/// Clearance of two links of a placed arm; minus the sum of their radii where their segments meet.
SpatialPairTerm pairClearance(const SpatialArm &arm, const SpatialArm::Placement &placement, int first, int second);
}  // namespace narrows
