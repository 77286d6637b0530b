// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// A taut string in the plane between a fixed anchor and a moving tip, around convex polygons.
///
/// It keeps its homotopy class: while the tip moves, the last segment turns about the last contact, wraps the first
/// corner that it sweeps and lets go of a contact whose turn vanishes. The string is the shortest one of its class.
class TautString
{
public:
    /// A corner that the string bends around.
    struct Contact
    {
        Eigen::Vector2d point;  ///< the corner
        std::size_t polygon;    ///< index of the polygon that it is of
        int side;               ///< 1: the string turns to the left there, -1: to the right
    };

    /// The tip begins at the anchor.
    /// \param polygons convex, counter-clockwise; they may overlap
    /// \pre the anchor is inside none of them
    TautString(std::vector<std::vector<Eigen::Vector2d>> polygons, const Eigen::Vector2d &anchor);

    /// Moves the tip along a straight line.
    /// \pre that line enters no polygon; else the string may pass through polygons afterwards
    void moveTip(const Eigen::Vector2d &to);

    const Eigen::Vector2d &anchor() const { return anchor_; }  ///< where the string is held
    const Eigen::Vector2d &tip() const { return tip_; }        ///< its other end
    /// From the anchor to the tip.
    const std::vector<Contact> &contacts() const { return contacts_; }
    double length() const;  ///< of the string

    /// The points at these fractions of the length of the string and a straight way on from its tip to `end`.
    /// \param fractions ascending, in [0, 1]
    /// \param points resized to fit
    void pointsAt(const std::vector<double> &fractions, const Eigen::Vector2d &end,
                  std::vector<Eigen::Vector2d> &points) const;

private:
    struct Sweep;
    /// A polygon with a circle around it.
    struct Shape
    {
        std::vector<Eigen::Vector2d> corners;
        Eigen::Vector2d center;
        double bound;
    };

    const Eigen::Vector2d &holder() const { return contacts_.empty() ? anchor_ : contacts_.back().point; }
    const Eigen::Vector2d &node(std::size_t index) const;
    bool release(const Eigen::Vector2d &from, Eigen::Vector2d &to) const;
    bool wrap(Eigen::Vector2d &from, const Eigen::Vector2d &to);

    std::vector<Shape> shapes_;
    Eigen::Vector2d anchor_, tip_;
    std::vector<Contact> contacts_;
};
}  // namespace narrows
