// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/SpatialRobotReader.h"

#include <cmath>

#include <fmt/format.h>

#include "scenario/RobotReader.h"
#include "scenario/SpatialFields.h"
#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
constexpr std::size_t mostLinks = 1000;

using AxisAndLimits = std::pair<Eigen::Vector3d, Interval>;

std::optional<AxisAndLimits> readSlide(const Field &field)
{
    const Mapping slide(field);
    slide.allowOnly({"axis", "limits"});
    const std::optional<Eigen::Vector3d> axis = readAxis(slide.required("axis"));
    const std::optional<Interval> limits = slide.required("limits").interval();
    if (!axis || !limits)
        return std::nullopt;
    return AxisAndLimits{*axis, *limits};
}

struct Base
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    bool slides = false;  ///< even if the slide is not sound
    std::optional<AxisAndLimits> slide;
};

/// \param extra what this robot's base may have beside its origin: slide or rotation
Base readBase(const Field &field, const std::string &extra)
{
    Base base;
    if (!field.given())
        return base;
    if (field.node().IsSequence())
    {
        base.pose.translation() = field.spatialPoint().value_or(Eigen::Vector3d::Zero());
        return base;
    }
    const Mapping mapping(field);
    mapping.allowOnly({"origin", extra});
    base.pose.translation() = mapping.required("origin").spatialPoint().value_or(Eigen::Vector3d::Zero());
    base.slides = extra == "slide" && mapping.has("slide");
    if (base.slides)
        base.slide = readSlide(mapping.optional("slide"));
    if (extra == "rotation")
        base.pose.linear() = readRotation(mapping.optional("rotation")).value_or(Eigen::Matrix3d::Identity());
    return base;
}

/// At most just below a right angle, up to which the permitted pairs of pitch and yaw are a convex set.
std::optional<double> readMaxAngle(const Field &field)
{
    constexpr double largest = M_PI_2 - 1e-6;
    const std::optional<double> angle = field.angle();
    if (!angle || (*angle > 0.0 && *angle <= largest))
        return angle;
    field.fault(fmt::format("must be more than 0 and less than a right angle, not {}", describe(field.node())));
    return std::nullopt;
}

/// Builds the arm unless something is wrong with the robot.
template <class Build>
void finish(SpatialRobotDraft &draft, const Field &field, std::size_t faultsBefore, const Build &build)
{
    if (field.faults().count() == faultsBefore)
        draft.arm.emplace(build());
}

void readUniversal(const Mapping &robot, std::size_t faultsBefore, SpatialRobotDraft &draft)
{
    robot.allowOnly({"kind", "joints", "base", "links", "radius", "max_link_angle", "self_collision"});
    const Base base = readBase(robot.optional("base"), "slide");
    draft.hasSlide = base.slides;
    const double radius = readRadius(robot.optional("radius"));
    const std::optional<double> maxAngle = readMaxAngle(robot.optional("max_link_angle"));
    std::vector<double> lengths;
    for (const Field &item : robot.required("links").items(1, mostLinks))
    {
        const Mapping link(item);
        link.allowOnly({"length"});
        lengths.push_back(link.required("length").positive().value_or(1.0));
        draft.tips.push_back(draft.entryCount++);
        draft.numbers.push_back(draft.entryCount);
    }
    finish(draft, robot.field(), faultsBefore,
           [&] { return universalChain(base.pose.translation(), lengths, radius, base.slide, maxAngle); });
}

DenavitHartenberg readRow(const Field &field, double radius)
{
    const Mapping entry(field);
    entry.allowOnly({"theta", "d", "a", "alpha", "limits", "radius"});
    DenavitHartenberg row;
    row.theta = entry.optional("theta").angle().value_or(0.0);
    row.d = entry.optional("d").number().value_or(0.0);
    row.a = entry.optional("a").number().value_or(0.0);
    row.alpha = entry.optional("alpha").angle().value_or(0.0);
    row.radius = entry.has("radius") ? readRadius(entry.optional("radius")) : radius;
    const Field limits = entry.optional("limits");
    if (!limits.isWord("none"))
        row.limits = limits.angleInterval();
    return row;
}

void readDenavitHartenberg(const Mapping &robot, std::size_t faultsBefore, SpatialRobotDraft &draft)
{
    robot.allowOnly({"kind", "joints", "base", "links", "radius", "self_collision"});
    const Base base = readBase(robot.optional("base"), "rotation");
    const double radius = readRadius(robot.optional("radius"));
    const Field links = robot.required("links");
    std::vector<DenavitHartenberg> rows;
    for (const Field &item : links.items(1, mostLinks))
    {
        rows.push_back(readRow(item, radius));
        ++draft.entryCount;
        const std::size_t linksBefore = draft.numbers.size();
        for (const double length : {rows.back().d, rows.back().a})
            if (length != 0.0)
                draft.numbers.push_back(draft.entryCount);
        const bool hasLink = draft.numbers.size() > linksBefore;
        draft.tips.push_back(hasLink ? static_cast<int>(draft.numbers.size()) - 1 : -1);
    }
    if (!rows.empty() && draft.numbers.empty())
        links.fault("no link has a length: give some of them d or a");
    finish(draft, robot.field(), faultsBefore, [&] { return denavitHartenbergArm(base.pose, rows); });
}
}  // namespace

bool isSpatialRobot(const Field &field)
{
    if (!field.given() || !field.node().IsMap())
        return false;
    const YAML::Node kind = field.node()["kind"];
    return kind && kind.IsScalar() && kind.Scalar() == "spatial_arm";
}

SpatialRobotDraft readSpatialRobot(const Field &field)
{
    SpatialRobotDraft draft;
    const std::size_t faultsBefore = field.faults().count();
    const Mapping robot(field);
    const Field joints = robot.optional("joints");
    const std::optional<std::string> word = joints.given() ? joints.oneOf({"universal", "dh"}) : "universal";
    draft.selfCollision = robot.optional("self_collision").flag().value_or(false);
    if (!word)
        return draft;
    draft.universal = word == "universal";
    if (*draft.universal)
        readUniversal(robot, faultsBefore, draft);
    else
        readDenavitHartenberg(robot, faultsBefore, draft);
    return draft;
}
}  // namespace narrows
