// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kernel/LinkObstacle.h"

namespace narrows
{
/// The obstacle function of a polygon (PlanarRepulsionModel.h).
class PolygonObstacle : public LinkObstacle
{
public:
    /// \param linkRadius half-width of the links; \param reach upper bound of R
    PolygonObstacle(const Polygon &polygon, double linkRadius, double reach);

    LinkTerm pole(const Segment &link) const override;
    LinkTerm clearance(const Segment &link) const override;
    bool isMet(const Segment &link) const override;

private:
    /// The points x with outward . x <= offset.
    struct HalfPlane
    {
        Eigen::Vector2d outward;  ///< of any length
        double offset;
    };
    /// A convex polygon.
    struct Piece
    {
        Bounds box;
        std::vector<Segment> edges;
        std::vector<HalfPlane> inside;
    };
    static std::vector<HalfPlane> insideOf(const std::vector<Segment> &edges);
    static bool enters(const Segment &link, const std::vector<HalfPlane> &inside);
    bool meets(const Segment &link) const;
    LinkTerm distance(const Segment &link) const;
    LinkTerm depth(const Segment &link) const;

    Polygon polygon_;
    Bounds box_;
    std::vector<Segment> edges_;
    std::vector<Piece> pieces_;  ///< that make up the polygon
    double linkRadius_;
    double size_;  ///< 2 (R + link radius)
};
}  // namespace narrows
