// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "kernel/BoxArrays.h"
#include "kernel/LinkObstacle.h"
#include "kernel/LinkTerm.h"
#include "kernel/PlanarModel.h"
#include "kernel/threading/Overlap.h"

namespace narrows
{
/// Overlap of a planar arm by the obstacle functions of PlanarRepulsionModel.h. Knows nothing of the arm's collisions
/// with itself. Keeps its memory from one call to the next.
class DeepestOverlap : public Overlap
{
public:
    /// Refers to nothing: obstacles and arm are copied.
    explicit DeepestOverlap(const PlanarModel &model);

    /// Of all links and obstacles; as far as obstacle functions tell depth.
    double deepest(ConfigurationRef q, Eigen::VectorXd &gradient) override;
    /// Without an obstacle function: polygons clip links.
    bool isMet(ConfigurationRef q) override { return firstMet(q, 0) >= 0; }
    int firstMet(ConfigurationRef q, int joint) override;  ///< See Overlap; links hang on the joints before them.
    /// \throws std::invalid_argument for other numbers of parts
    bool isMetBetween(ConfigurationRef q, ConfigurationRef delta, int parts) override;

private:
    static constexpr int mostParts = 8;
    using Directions = std::vector<Eigen::Vector2d>;  ///< unit vectors along the links

    void direct(ConfigurationRef q, Directions &directions) const;
    /// Directions half way between two others of the motion q + t delta, from t - half to t + half.
    void halve(const Directions &from, const Directions &to, ConfigurationRef q, ConfigurationRef delta, double t,
               double half, Directions &result) const;
    void placeBase(double slide);
    /// \pre the base and the links before it have been placed
    void place(std::size_t link, const Directions &directions);
    /// Places up to four links from `link` on and finds the obstacles near them. \return how many links
    int placeSome(std::size_t link, const Directions &directions);
    /// Calls visit(obstacle) for each that is near the link, the i-th of those that placeSome() has placed, until that
    /// returns false. \return whether none did
    template <class Visit>
    bool visitNear(std::size_t link, int i, const Visit &visit);
    /// The first link that overlaps an obstacle, from `link` on; -1 if none does.
    int firstOverlap(const Directions &directions, double slide, std::size_t link);
    /// Made when a link comes near it for the first time: in the open, most never are.
    const LinkObstacle &obstacle(std::size_t i);

    PlanarArm arm_;
    double longestLink_ = 0.0;
    std::vector<PlanarObstacle> shapes_;
    std::vector<std::unique_ptr<const LinkObstacle>> obstacles_;
    std::vector<Bounds> boxes_;   ///< of obstacles, for links that are lines
    BoxArrays<2> obstacleBoxes_;  ///< the same
    BoxArrays<2> linkBoxes_;
    std::vector<ObstacleBits> near_;  ///< per box of a link
    std::array<Directions, mostParts + 1> directions_;
    std::vector<Eigen::Vector2d> points_, carried_;
    std::vector<Segment> links_;
    std::vector<LinkForce> forces_;
};
}  // namespace narrows
