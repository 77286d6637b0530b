// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/RobotReader.h"

#include <fmt/format.h>

#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
constexpr std::size_t mostLinks = 1000;
constexpr double shortestAxis = 1e-9;

std::vector<PlanarLink> readLinks(const Field &field)
{
    std::vector<PlanarLink> links;
    for (const Field &item : field.items(1, mostLinks))
    {
        const Mapping link(item);
        link.allowOnly({"length", "parent"});
        const int before = static_cast<int>(links.size());
        const double length = link.required("length").positive().value_or(1.0);
        // Files count links from 1, so that 0 can be the base; the kernel counts from 0 with -1 as the base.
        const int parent = link.optional("parent").integer(0, before).value_or(before);
        links.push_back({length, parent - 1});
    }
    return links;
}

std::optional<Slide> readSlide(const Field &field)
{
    const Mapping slide(field);
    slide.allowOnly({"axis", "limits"});
    const Field axisField = slide.required("axis");
    const std::optional<Eigen::Vector2d> axis = axisField.point();
    const std::optional<Interval> limits = slide.required("limits").interval();
    if (axis && axis->norm() < shortestAxis)
        axisField.fault("must not be a zero vector");
    else if (axis && limits)
        return Slide{axis->normalized(), limits->lower, limits->upper};
    return std::nullopt;
}

struct Base
{
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    std::optional<Slide> slide;
};

Base readBase(const Mapping &robot, bool sliding)
{
    const Field field = sliding ? robot.required("base") : robot.optional("base");
    if (!field.given())
        return {};
    if (!sliding && field.node().IsSequence())
        return {field.point().value_or(Eigen::Vector2d::Zero()), std::nullopt};

    const Mapping base(field);
    base.allowOnly({"origin", "slide"});
    const Eigen::Vector2d origin = base.required("origin").point().value_or(Eigen::Vector2d::Zero());
    if (sliding)
        return {origin, readSlide(base.required("slide"))};
    if (base.has("slide"))
        base.optional("slide").fault("only a robot of kind planar_chain has a sliding base");
    return {origin, std::nullopt};
}

/// One joint's own entry in a list of limits.
std::optional<Interval> readLimit(const Field &field)
{
    return field.isWord("none") ? std::nullopt : field.angleInterval();
}

bool isOneInterval(const Field &field)
{
    const YAML::Node &node = field.node();
    return node.IsSequence() && node.size() > 0 && node[0].IsScalar() && node[0].Scalar() != "none";
}

JointLimits readLimits(const Field &field, AngleConvention convention, std::size_t linkCount)
{
    JointLimits limits{convention, std::vector<std::optional<Interval>>(linkCount)};
    if (!field.given() || field.isWord("none"))
        return limits;
    if (!field.node().IsSequence())
        field.fault(fmt::format("must be none, [lower, upper] or a list of these, not {}", describe(field.node())));
    else if (isOneInterval(field))
        limits.angles.assign(linkCount, field.angleInterval());
    else if (linkCount > 0 && field.node().size() != linkCount)
        field.fault(
            fmt::format("must have one entry for each of the {} links, not {}", linkCount, field.node().size()));
    else
    {
        const std::vector<Field> items = field.items(0, mostLinks);
        for (std::size_t i = 0; i < std::min(linkCount, items.size()); ++i)
            limits.angles[i] = readLimit(items[i]);
    }
    return limits;
}

AngleConvention readConvention(const Field &field)
{
    const std::string word = field.oneOf({"absolute", "relative"}).value_or("absolute");
    return word == "relative" ? AngleConvention::Relative : AngleConvention::Absolute;
}

}  // namespace

double readRadius(const Field &field)
{
    const std::optional<double> radius = field.number();
    if (!radius || *radius >= 0.0)
        return radius.value_or(0.0);
    field.fault(fmt::format("must not be negative, but is {}", *radius));
    return 0.0;
}

RobotDraft readRobot(const Field &field)
{
    RobotDraft draft;
    const std::size_t faultsBefore = field.faults().count();
    const Mapping robot(field);
    draft.hasSlide = robot.required("kind").oneOf({"planar_arm", "planar_chain", "spatial_arm"}) == "planar_chain";
    robot.allowOnly({"kind", "base", "links", "radius", "angles", "limits", "self_collision"});
    const Base base = readBase(robot, draft.hasSlide);
    const std::vector<PlanarLink> links = readLinks(robot.required("links"));
    const double radius = readRadius(robot.optional("radius"));
    draft.linkCount = static_cast<int>(links.size());
    draft.convention = readConvention(robot.optional("angles"));
    draft.limits = readLimits(robot.optional("limits"), draft.convention, links.size());
    draft.selfCollision = robot.optional("self_collision").flag().value_or(false);
    if (field.given() && field.faults().count() == faultsBefore)
        draft.arm.emplace(base.origin, links, radius, base.slide);
    return draft;
}
}  // namespace narrows
