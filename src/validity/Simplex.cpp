// SPDX-License-Identifier: BSD-3-Clause
#include "validity/Simplex.h"

#include <algorithm>
#include <cmath>

namespace narrows::proof
{
namespace
{
using Eigen::Vector3d;

constexpr double flat = 1e-28;      // a triangle's relative height squared; flatter ones are taken for segments
constexpr double rounding = 1e-15;  // of a point, relative to its distance from the origin

Vector3d withoutComponent(const Vector3d &vector, const Vector3d &unit)
{
    return vector - vector.dot(unit) * unit;
}
}  // namespace

/// Of the normal, the error is that of the points by the simplex's own width; of `nearest`, by its length.
Vector3d Simplex<3>::direction() const
{
    const double distance = nearest_.norm();
    if (count_ == 1)
        return nearest_ / distance;
    const Vector3d along = points_[1] - points_[0];
    if (along.norm() < distance)
        return nearest_ / distance;
    if (count_ == 2)
    {
        // Twice, because the first difference may have cancelled most digits.
        const Vector3d unit = along.normalized();
        const Vector3d across = withoutComponent(nearest_, unit).normalized();
        const Vector3d normal = withoutComponent(across, unit).normalized();
        return normal.squaredNorm() > 0.5 ? normal : unit.unitOrthogonal();
    }
    const Vector3d side = points_[2] - points_[0];
    const Vector3d normal = along.cross(side);
    if (normal.norm() < distance * std::max(along.norm(), side.norm()))
        return nearest_ / distance;
    return normal.dot(points_[0]) >= 0.0 ? normal.normalized() : Vector3d(-normal.normalized());
}

bool Simplex<3>::extend(const Vector3d &added)
{
    if (count_ == 3 && encloseOrigin(added))
        return false;
    const Simplex old = *this;
    *this = Simplex(added);
    for (int i = 0; i < old.count_; ++i)
        offerSegment(old.points_[i], added);
    for (int i = 0; i < old.count_; ++i)
        for (int j = 0; j < i; ++j)
            offerTriangle(old.points_[j], old.points_[i], added);
    return true;
}

/// Whether the origin is on the inner side of all four faces, beyond doubt: on round sets, corners may be so close
/// together that a face's normal is made of rounding errors.
bool Simplex<3>::encloseOrigin(const Vector3d &added) const
{
    const std::array<const Vector3d *, 4> corners{&points_[0], &points_[1], &points_[2], &added};
    double size = 0.0;
    for (const Vector3d *corner : corners)
        size = std::max(size, corner->squaredNorm());
    for (int i = 0; i < 4; ++i)
    {
        const Vector3d &opposite = *corners[i];
        const Vector3d &a = *corners[(i + 1) % 4], &b = *corners[(i + 2) % 4], &c = *corners[(i + 3) % 4];
        const Vector3d ab = b - a, ac = c - a, normal = ab.cross(ac);
        const double doubt = rounding * size * std::sqrt(std::max(ab.squaredNorm(), ac.squaredNorm()));
        const double toOrigin = -normal.dot(a), toOpposite = normal.dot(opposite - a);
        if (!(toOrigin * toOpposite > 0.0) || std::abs(toOrigin) <= doubt || std::abs(toOpposite) <= doubt)
            return false;
    }
    return true;
}

void Simplex<3>::offerSegment(const Vector3d &a, const Vector3d &b)
{
    const Vector3d along = b - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0.0 ? -a.dot(along) / squared : 0.0;
    if (!(t > 0.0 && t < 1.0))
        return;
    const Vector3d nearest = a + t * along;
    if (nearest.squaredNorm() < nearest_.squaredNorm())
    {
        points_ = {a, b};
        count_ = 2;
        nearest_ = nearest;
    }
}

void Simplex<3>::offerTriangle(const Vector3d &a, const Vector3d &b, const Vector3d &c)
{
    const Vector3d ab = b - a, ac = c - a;
    const Vector3d normal = ab.cross(ac);
    const double squared = normal.squaredNorm();
    const double side = std::max(ab.squaredNorm(), ac.squaredNorm());
    if (squared <= flat * side * side)
        return;
    const double toB = a.cross(ac).dot(normal) / -squared;
    const double toC = a.cross(ab).dot(normal) / squared;
    if (!(toB > 0.0 && toC > 0.0 && toB + toC < 1.0))
        return;
    const Vector3d nearest = a + toB * ab + toC * ac;
    if (nearest.squaredNorm() < nearest_.squaredNorm())
    {
        points_ = {a, b, c};
        count_ = 3;
        nearest_ = nearest;
    }
}
}  // namespace narrows::proof
