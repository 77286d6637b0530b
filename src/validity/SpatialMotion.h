// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/SpatialModel.h"
#include "validity/TurningPlane.h"

namespace narrows::proof
{
/// The same as PlanarMotion for arms in space, from the definitions of their joints and links alone.
class SpatialMotion
{
public:
    static constexpr int Dim = 3;

    explicit SpatialMotion(const SpatialArm &arm);

    void place(const Eigen::VectorXd &from, const Eigen::VectorXd &to, double t);

    int linkCount() const { return arm_.linkCount(); }
    double radius(int link) const { return arm_.links()[link].radius; }
    const MovingSegment<3> &link(int index) const { return links_[index]; }

    /// In the frame of the last joint that carries both links.
    MovingPair<3> between(int first, int second) const;

    bool areNeighbours(int first, int second) const { return arm_.areNeighbours(first, second); }
    double extent(const std::vector<Eigen::VectorXd> &path) const;
    double rounding(double extent) const;

private:
    /// A joint's moving frame, and how it moves with t.
    struct Frame
    {
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        Eigen::Vector3d origin = Eigen::Vector3d::Zero();
        Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< of the origin
        Eigen::Vector3d spin = Eigen::Vector3d::Zero();      ///< angular velocity

        Eigen::Vector3d velocityAt(const Eigen::Vector3d &point) const { return velocity + spin.cross(point - origin); }
    };

    /// How far a link's points ever are from the axis of a joint that carries it; 1 for a prismatic joint, which moves
    /// them as much as itself.
    struct Lever
    {
        int joint;
        bool turns;
        double arm;
    };

    std::vector<Lever> leversOf(const SpatialLink &link) const;
    MovingSegment<3> linkIn(int carrier, int link) const;
    const Frame &frameOf(int joint) const { return joint < 0 ? world_ : frames_[joint]; }

    const SpatialArm &arm_;
    Frame world_;
    std::vector<Frame> frames_;  ///< per joint
    std::vector<double> rates_;  ///< per joint
    std::vector<MovingSegment<3>> links_;
    std::vector<std::vector<Lever>> levers_;  ///< per link, from the base on
    double flaw_;                             ///< how far the arm's offsets and axes are from exact ones
};
}  // namespace narrows::proof
