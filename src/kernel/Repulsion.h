// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// A scalar function W over joint space that is infinite wherever the robot touches an obstacle, and regular where it
/// is free: what bends a homotopy's curve around obstacles (HPPM-PRA, Eq. 23). Immutable; threads may share one.
class Repulsion
{
public:
    /// W and all that the trackers ask about it at one configuration.
    struct Sample
    {
        double value = 0.0;         ///< W
        Eigen::VectorXd gradient;   ///< dW/dq, one entry per joint
        std::vector<double> poles;  ///< the obstacle functions behind W, always as many in the same order: positive
                                    ///< where free, 0 on the boundary. A step over which one of them changes sign has
                                    ///< jumped over a pole
    };

    virtual ~Repulsion() = default;

    virtual int dimension() const = 0;  ///< Joints of a configuration q.
    /// Sets all of `sample`, whose memory is used again. \pre q has dimension() values
    virtual void evaluate(const Eigen::Ref<const Eigen::VectorXd> &q, Sample &sample) const = 0;
    /// W alone.
    virtual double value(const Eigen::Ref<const Eigen::VectorXd> &q) const = 0;
};

/// \throws std::invalid_argument unless there are `count` strengths, all finite; `what` has one each.
void requireStrengths(const std::vector<double> &strengths, std::size_t count, const std::string &what);

/// How one configuration lies among the poles: what a search for good homotopies starts from.
struct Surroundings
{
    double clearance = 0.0;       ///< least distance to anything but joint limits; +infinity if there is nothing
    std::vector<double> weights;  ///< per group: its part of W at strength 1, with continuous poles
    std::vector<int> sides;   ///< per group: +1 or -1, on which side of its nearest link it lies; 0 where links have
                              ///< no sides
    std::vector<int> pinned;  ///< joints that cannot turn either way, because a link is in a throat, and all that
                              ///< hangs on them
};

/// What the homotopy planners need to know of a robot among its obstacles. One implementation per kind of robot;
/// whoever brings a robot of his own implements this.
///
/// Poles come in groups that share a strength P (of either sign): one group per obstacle, in the order of the model,
/// then, where they exist, one for all joint limits ("limits") and one for self-collision ("self").
class RepulsionModel
{
public:
    virtual ~RepulsionModel() = default;

    virtual int dimension() const = 0;  ///< Joints of a configuration q.
    /// Names of the groups; obstacles first.
    virtual const std::vector<std::string> &groups() const = 0;
    virtual std::size_t obstacleCount() const = 0;  ///< How many of the groups are obstacles.
    /// Coordinates of a point where the obstacles are: in 2 a curve passes them on one of two sides.
    virtual int workspace() const = 0;

    /// The strength with which a pole of the group bends a curve by about a radian at a distance that is ordinary for
    /// the robot: what strengths are measured by.
    virtual double naturalStrength(std::size_t /*group*/) const { return 1.0; }

    /// One pole per link and obstacle, at their exact distance: sum of P / (d^2 - r^2), or the like where a shape has
    /// no radius (see the implementation). A strength of 0 leaves the group out. \param strengths one per group
    virtual std::shared_ptr<const Repulsion> continuous(const std::vector<double> &strengths) const = 0;

    /// Whether the paper has a function for every obstacle, so that there are points().
    virtual bool supportsPoints() const = 0;

    /// The paper's singular points, n per link (HPPM-PRA, Eq. 20-23).
    /// \throws std::invalid_argument if the paper has no function for some obstacle or this kind of robot.
    virtual std::shared_ptr<const Repulsion> points(const std::vector<double> &strengths, int pointsPerLink) const = 0;

    /// Unless overridden, sides are 0 and nothing is pinned.
    /// \param q a configuration
    /// \param throat a link with obstacles within this distance on both sides is in a throat; > 0
    virtual Surroundings surroundings(const Eigen::Ref<const Eigen::VectorXd> &q, double throat) const;

    /// Least distance of any link to anything that has a pole (limits, which are no distances, left out), negative or
    /// zero iff something touches, and its gradient where it has one.
    virtual double clearance(const Eigen::Ref<const Eigen::VectorXd> &q, Eigen::VectorXd &gradient) const = 0;
};
}  // namespace narrows
