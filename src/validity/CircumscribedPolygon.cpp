// SPDX-License-Identifier: BSD-3-Clause
#include "validity/CircumscribedPolygon.h"

#include <cmath>

#include <boost/math/constants/constants.hpp>

namespace narrows
{
namespace
{
using Eigen::Vector2d;

using boost::math::double_constants::pi;
constexpr double leastTurn = 1e-6;  // radians between neighbouring tangents; keeps intersections well conditioned

/// Tangent of |x|^p + |y|^p = 1.
struct Tangent
{
    double angle;  ///< of the normal
    Vector2d normal;
    double offset;  ///< normal . x on the line
    Vector2d contact;
};

/// Works in the frame in which both half extents are 1; the map back is affine and keeps tangents.
class TangentPolygon
{
public:
    TangentPolygon(const Superellipse &shape, double tolerance) : shape_(shape), tolerance_(tolerance)
    {
        constexpr int firstTangents = 8;
        for (int i = 0; i < firstTangents; ++i)
            addBetween(tangent(2 * pi * i / firstTangents), tangent(2 * pi * (i + 1) / firstTangents));
    }

    Polygon polygon;

private:
    /// The support function of the p-norm ball is the q-norm, 1/p + 1/q = 1; its gradient is the point of contact.
    Tangent tangent(double angle) const
    {
        const Vector2d normal(std::cos(angle), std::sin(angle));
        const double q = shape_.exponent / (shape_.exponent - 1.0);
        const Vector2d size = normal.cwiseAbs();
        const double offset = std::pow(std::pow(size.x(), q) + std::pow(size.y(), q), 1.0 / q);
        const Vector2d contact(std::copysign(std::pow(size.x() / offset, q - 1.0), normal.x()),
                               std::copysign(std::pow(size.y() / offset, q - 1.0), normal.y()));
        return {angle, normal, offset, contact};
    }

    void addBetween(const Tangent &from, const Tangent &to)
    {
        const double sine = from.normal.x() * to.normal.y() - from.normal.y() * to.normal.x();
        const Vector2d vertex(from.offset * to.normal.y() - to.offset * from.normal.y(),
                              to.offset * from.normal.x() - from.offset * to.normal.x());
        if (to.angle - from.angle < leastTurn || closeEnough(vertex / sine, from.contact, to.contact))
        {
            polygon.vertices.push_back(shape_.center + shape_.halfExtents.cwiseProduct(vertex / sine));
            return;
        }
        const Tangent middle = tangent(0.5 * (from.angle + to.angle));
        addBetween(from, middle);
        addBetween(middle, to);
    }

    /// The chord between the contacts lies in the superellipse, so no vertex is further from it than from its chord.
    bool closeEnough(const Vector2d &vertex, const Vector2d &from, const Vector2d &to) const
    {
        const Vector2d chord = shape_.halfExtents.cwiseProduct(to - from);
        const Vector2d arm = shape_.halfExtents.cwiseProduct(vertex - from);
        const double area = std::abs(chord.x() * arm.y() - chord.y() * arm.x());
        return area <= tolerance_ * shape_.halfExtents.minCoeff() * chord.norm();
    }

    const Superellipse &shape_;
    double tolerance_;
};
}  // namespace

Polygon circumscribedPolygon(const Superellipse &shape, double tolerance)
{
    return TangentPolygon(shape, tolerance).polygon;
}
}  // namespace narrows
