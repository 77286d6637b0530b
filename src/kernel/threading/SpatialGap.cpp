// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/threading/SpatialGap.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "kernel/threading/FacingPatch.h"
#include "kernel/threading/MeshGaps.h"
#include "kernel/threading/SpatialShape.h"

namespace narrows
{
namespace
{
using Eigen::Vector3d;

constexpr double slender = 2.0;  ///< so many times as long as thick is a slot

struct Finder
{
    double thinnest, widest;
    std::vector<SpatialShape> shapes;
    std::vector<SpatialGap> gaps;

    void look(std::size_t one, std::size_t other);
    /// The parts of a gap that no third shape fills.
    void addFreeParts(const SpatialGap &gap, std::size_t one, std::size_t other);
    void add(SpatialGap gap, double from, double to);
};

bool areFarApart(const SpatialBounds &one, const SpatialBounds &other, double distance)
{
    return (one.lower - other.upper).cwiseMax(other.lower - one.upper).cwiseMax(0.0).norm() >= distance;
}

void Finder::look(std::size_t one, std::size_t other)
{
    constexpr double tilt = 0.1;  // of the distance: faces that are parallel but for this face each other as a whole
    const SpatialShape &first = shapes[one], &second = shapes[other];
    const double tooWide = 2.0 * (widest + thinnest);
    if (areFarApart(first.box(), second.box(), tooWide))
        return;
    const SpatialNearestPoints nearest = nearestPoints(first, second);
    if (!(nearest.distance > 2.0 * thinnest) || nearest.distance >= tooWide)
        return;
    const Vector3d &axis = nearest.direction, middle = 0.5 * (nearest.first + nearest.second);
    const double depth = tilt * nearest.distance;
    const FacingPatch patch = facingPatch(first.facing(axis, depth), second.facing(-axis, depth), axis, middle);
    const double breadth = std::min(first.leastHalfBreadth(), second.leastHalfBreadth());
    const double size = patch.halfBreadth > 1e-3 * breadth ? patch.halfBreadth : breadth;
    addFreeParts({patch.middle + axis.dot(middle - patch.middle) * axis, axis, patch.along, patch.halfLength,
                  0.5 * nearest.distance, size},
                 one, other);
}

/// The part of the line from middle - halfLength along to middle + halfLength along that a shape fills.
std::optional<Interval> filledPart(const SpatialGap &gap, const SpatialShape &shape)
{
    constexpr int halvings = 50;
    const auto at = [&](double place) -> Vector3d
    {
        return gap.middle + place * gap.along;
    };
    const Nearness near = shape.nearest(at(-gap.halfLength), at(gap.halfLength));
    if (near.distance > 0.0)
        return std::nullopt;
    const double inside = (2.0 * near.fraction - 1.0) * gap.halfLength;
    const auto edge = [&](double end)
    {
        if (shape.contains(at(end)))
            return end;
        double in = inside, out = end;
        for (int i = 0; i < halvings; ++i)
            (shape.contains(at(0.5 * (in + out))) ? in : out) = 0.5 * (in + out);
        return in;
    };
    return Interval{edge(-gap.halfLength), edge(gap.halfLength)};
}

void Finder::addFreeParts(const SpatialGap &gap, std::size_t one, std::size_t other)
{
    std::vector<Interval> filled;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        if (i != one && i != other)
            if (const std::optional<Interval> part = filledPart(gap, shapes[i]))
                filled.push_back(*part);
    std::sort(filled.begin(), filled.end(), [](const Interval &a, const Interval &b) { return a.lower < b.lower; });
    double from = -gap.halfLength;
    for (const Interval &part : filled)
    {
        if (part.lower > from)
            add(gap, from, part.lower);
        from = std::max(from, part.upper);
    }
    // A gap that is but a point has one part, unless it is filled.
    if (from < gap.halfLength || filled.empty())
        add(gap, from, gap.halfLength);
}

void Finder::add(SpatialGap gap, double from, double to)
{
    // Narrower than the thinnest link it only lets through what goes across the line anyway.
    if (gap.halfLength > 0.0 && to - from <= 2.0 * thinnest && to - from < 2.0 * gap.halfLength)
        return;
    gap.middle += 0.5 * (from + to) * gap.along;
    gap.halfLength = 0.5 * (to - from);
    if (gap.halfLength <= slender * gap.size)
    {
        gap.along.setZero();
        gap.halfLength = 0.0;
    }
    gaps.push_back(gap);
}
}  // namespace

std::vector<SpatialGap> findGaps(const std::vector<SpatialObstacle> &obstacles, double thinnest, double widest,
                                 double far)
{
    if (!(thinnest >= 0.0) || !(widest > 0.0) || !(far > 0.0))
        throw std::invalid_argument("gaps need a link radius of at least 0, a positive greatest width and reach");
    Finder finder{thinnest, widest, {}, {}};
    std::vector<const Mesh *> meshes;
    for (const SpatialObstacle &obstacle : obstacles)
        std::visit(
            [&](const auto &shape)
            {
                if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Mesh>)
                    meshes.push_back(&shape);
                else
                    finder.shapes.emplace_back(shape, far);
            },
            obstacle.shape);
    for (std::size_t i = 0; i < finder.shapes.size(); ++i)
        for (std::size_t j = i + 1; j < finder.shapes.size(); ++j)
            finder.look(i, j);
    addMeshGaps(meshes, finder.shapes, thinnest, widest, finder.gaps);
    return finder.gaps;
}
}  // namespace narrows
