// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace narrows
{
/// Directions from..to, radians; `to` may be beyond 2 pi or `from` below 0.
struct LadderArc
{
    double from;  ///< radians
    double to;    ///< radians, >= from

    /// Whether the closed arcs have a direction in common.
    bool meets(const LadderArc &other) const;
    /// Whether a direction is one of them.
    bool contains(double angle) const { return meets({angle, angle}); }
};

/// Which directions a link can have at a joint that lies anywhere in a square.
class LadderArcs
{
public:
    using Distance = std::function<double(const Eigen::Vector2d &)>;  ///< from obstacles, of a point; negative inside

    /// \param square edge of the squares
    LadderArcs(const Distance &distance, double length, double radius, double square, double finestAngle)
      : distance_(distance), length_(length), radius_(radius), away_(square * 0.70710678118654757), finest_(finestAngle)
    {
    }

    /// All directions but those that are blocked for every place in the square around `center`, as disjoint arcs.
    std::vector<LadderArc> around(const Eigen::Vector2d &center);
    long rays() const { return rays_; }  ///< cast so far

private:
    enum class Ray
    {
        Blocked,
        Clear,
        Undecided
    };

    void divide(const Eigen::Vector2d &center, const LadderArc &arc, std::vector<LadderArc> &kept);
    Ray look(const Eigen::Vector2d &center, double angle, double halfWidth);

    const Distance &distance_;
    double length_;
    double radius_;
    double away_;  ///< half the diagonal of a square
    double finest_;
    long rays_ = 0;
};
}  // namespace narrows
