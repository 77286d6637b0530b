// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// A read-only view of one configuration: [slide,] one angle per link. Accepts maps without copying.
using ConfigurationRef = const Eigen::Ref<const Eigen::VectorXd> &;

/// How joint angles are counted: against the x axis, or against the parent link.
enum class AngleConvention
{
    Absolute,
    Relative
};

/// A rigid link with one revolute joint at its base.
struct PlanarLink
{
    double length;  ///< > 0, in the scenario's unit
    int parent;     ///< link whose tip carries this link's base; -1 is the arm's base. Always less than its own index
};

/// A prismatic joint that carries the arm's base: base + value * axis.
struct Slide
{
    Eigen::Vector2d axis;  ///< unit vector
    double lower;          ///< in length units
    double upper;          ///< >= lower
};

/// Kinematics of a planar tree of links: chains, branching grippers, with or without a sliding base.
///
/// A configuration is a vector of `dimension()` values: the slide first (if there is one), then one angle per link.
/// Inside the library angles are ABSOLUTE unless a name says otherwise (HPPM-PRA, Eq. 18). Immutable and thread-safe.
class PlanarArm
{
public:
    static constexpr int Dim = 2;  ///< coordinates of a point

    /// \throws std::invalid_argument if a length is not positive and finite, a parent does not precede its child,
    /// the radius is negative, or the slide's axis is not a unit vector.
    PlanarArm(const Eigen::Vector2d &base, std::vector<PlanarLink> links, double radius = 0.0,
              std::optional<Slide> slide = std::nullopt);

    /// How many links there are.
    int linkCount() const { return static_cast<int>(links_.size()); }
    /// How many values a configuration has.
    int dimension() const { return linkCount() + firstAngle(); }
    /// Index of link 0's angle in a configuration: 1 with a slide, else 0.
    int firstAngle() const { return slide_ ? 1 : 0; }
    /// The links, parents before their children.
    const std::vector<PlanarLink> &links() const { return links_; }
    /// What the base moves along, if it does.
    const std::optional<Slide> &slide() const { return slide_; }
    /// Where the links that no link carries begin, at slide 0.
    const Eigen::Vector2d &base() const { return base_; }
    /// Half-width of every link; 0 for line segments.
    double radius() const { return radius_; }
    /// Whether two links meet at a joint, whatever the configuration; only other pairs can collide with each other.
    bool areNeighbours(int link, int other) const
    {
        return links_[link].parent == links_[other].parent || links_[link].parent == other ||
               links_[other].parent == link;
    }
    /// Length of the longest chain of links from the base to a tip.
    double reach() const;

    /// Forward kinematics. `points` becomes [base, tip of link 0, tip of link 1, ...]; link i is the segment from
    /// points[links()[i].parent + 1] to points[i + 1].
    void place(ConfigurationRef q, std::vector<Eigen::Vector2d> &points) const;

    /// For the motion q + t * delta, t in [0, 1], and any point of link i: its way is at most lengths[i] = |slide| +
    /// sum of L_j |delta_j| over the chain from the base to link i, its acceleration at most bends[i] = sum of L_j
    /// delta_j^2.
    void motionBounds(ConfigurationRef delta, Eigen::VectorXd &lengths, Eigen::VectorXd &bends) const;

    /// Velocities of the points of `place` under that motion, where they are at the moment.
    void velocities(const std::vector<Eigen::Vector2d> &points, ConfigurationRef delta,
                    std::vector<Eigen::Vector2d> &velocities) const;

    /// The configuration that values of another convention stand for; both have dimension() values, the slide first.
    Eigen::VectorXd toAbsolute(ConfigurationRef q, AngleConvention from) const;
    Eigen::VectorXd fromAbsolute(ConfigurationRef q, AngleConvention to) const;  ///< The inverse of toAbsolute().

private:
    Eigen::Vector2d base_;
    std::vector<PlanarLink> links_;
    double radius_;
    std::optional<Slide> slide_;
};
}  // namespace narrows
