// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "kernel/PlanarArm.h"

namespace narrows
{
/// A segment in the plane: a link where it stands, or an edge.
struct Segment
{
    Eigen::Vector2d base;   ///< one end: of a link, where it hangs on
    Eigen::Vector2d along;  ///< from the base to the tip
    double inverseSquare;   ///< 1 / |along|^2

    /// The segment from one point to another.
    static Segment between(const Eigen::Vector2d &base, const Eigen::Vector2d &tip)
    {
        return {base, tip - base, 1.0 / (tip - base).squaredNorm()};
    }

    /// The point at that share of the way from the base to the tip.
    Eigen::Vector2d at(double fraction) const { return base + fraction * along; }
    Eigen::Vector2d tip() const { return base + along; }  ///< the other end
    /// Where the line through the segment comes nearest to the point; 0 at the base, 1 at the tip.
    double foot(const Eigen::Vector2d &point) const { return (point - base).dot(along) * inverseSquare; }
    /// Where the segment does.
    double nearest(const Eigen::Vector2d &point) const { return std::min(std::max(foot(point), 0.0), 1.0); }
    /// Unit vector to the left of it.
    Eigen::Vector2d normal() const { return Eigen::Vector2d(-along.y(), along.x()).normalized(); }
};

/// What acts on a link: the derivative of some function of where the link lies, by its base and by its `along`.
struct LinkForce
{
    Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< by the base
    Eigen::Vector2d lever = Eigen::Vector2d::Zero();  ///< by `along`

    /// The derivative of a function that depends on the link's point at `fraction` only.
    static LinkForce at(double fraction, const Eigen::Vector2d &part) { return {part, fraction * part}; }
    /// The derivative of the function times a constant.
    LinkForce times(double factor) const { return {factor * force, factor * lever}; }
    /// Adds what at() gives.
    void push(double fraction, const Eigen::Vector2d &part)
    {
        force += part;
        lever += fraction * part;
    }
    /// Adds the derivative of another function times a constant.
    void add(double factor, const LinkForce &other)
    {
        force += factor * other.force;
        lever += factor * other.lever;
    }
};

/// A function of where a link lies, and its derivative.
struct LinkTerm
{
    double value = 0.0;  ///< of the function
    LinkForce slope;     ///< its derivative
};

/// e (e + size) of a clearance e, continued below 0 as size * e: with e = |p| - r and size = 2 r, |p|^2 - r^2.
inline double poleOf(double clearance, double size)
{
    return clearance * (size + std::max(clearance, 0.0));
}
/// Its derivative by the clearance.
inline double poleSlope(double clearance, double size)
{
    return size + 2.0 * std::max(clearance, 0.0);
}
/// The same of a clearance with its derivatives by a link, and theirs.
inline LinkTerm poleOf(const LinkTerm &clearance, double size)
{
    return {poleOf(clearance.value, size), clearance.slope.times(poleSlope(clearance.value, size))};
}

/// The derivative by the joints of a function whose derivatives by the links are `forces`: a link's angle moves its own
/// points and everything that hangs on its tip, so that forces are passed down the tree.
/// \param points as PlanarArm::place yields them
/// \param carried workspace
void gatherGradient(const PlanarArm &arm, const std::vector<Eigen::Vector2d> &points,
                    const std::vector<LinkForce> &forces, std::vector<Eigen::Vector2d> &carried,
                    Eigen::VectorXd &gradient);
}  // namespace narrows
