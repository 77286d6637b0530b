// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/SpatialStateReader.h"

#include <cmath>

#include <fmt/format.h>

namespace narrows
{
namespace
{
constexpr std::size_t mostEntries = 1000;  // as many as a robot may have links

std::optional<double> readSlideValue(const Mapping &entry, const SpatialRobotDraft &robot)
{
    if (!robot.hasSlide)
    {
        if (entry.has("slide"))
            entry.optional("slide").fault("the robot has no sliding base (base: {origin, slide})");
        return 0.0;
    }
    const Field field = entry.required("slide");
    const std::optional<double> value = field.number();
    if (!value || !robot.arm)
        return value;
    const Interval &limits = *robot.arm->joints().front().limits;
    if (!(*value >= limits.lower && *value <= limits.upper))
        field.fault(fmt::format("{} is out of the slide's limits [{}, {}]", *value, limits.lower, limits.upper));
    return value;
}

/// The joint values of one entry: [pitch, yaw] of a universal joint, else one angle. Empty if it is not sound.
std::vector<double> readEntry(const Field &item, bool universal)
{
    std::vector<double> values;
    const std::vector<Field> parts = universal ? item.items(2, 2) : std::vector<Field>{item};
    for (const Field &part : parts)
        if (const std::optional<double> value = part.angle())
            values.push_back(*value);
    return values.size() == parts.size() ? values : std::vector<double>{};
}

/// Nothing is reported for a joint that turns freely.
void checkLimits(const Field &item, int entry, const Eigen::VectorXd &q, const SpatialRobotDraft &robot)
{
    const SpatialArm &arm = *robot.arm;
    if (!*robot.universal)
    {
        const std::optional<Interval> &limit = arm.joints()[static_cast<std::size_t>(entry)].limits;
        if (limit && !(q[entry] >= limit->lower && q[entry] <= limit->upper))
            item.fault(fmt::format("the angle {} of link {} is out of its limits [{}, {}]", q[entry], entry + 1,
                                   limit->lower, limit->upper));
        return;
    }
    if (arm.universalLimits().empty())
        return;
    const UniversalLimit &limit = arm.universalLimits()[static_cast<std::size_t>(entry)];
    const double pitch = q[limit.first];
    const double yaw = q[limit.second];
    // By cosines, so that a state exactly at the limit is not lost in rounding. Beyond a right angle these rise again.
    const bool turnsBack = std::max(std::abs(pitch), std::abs(yaw)) > limit.maxAngle;
    if (turnsBack || std::cos(pitch) * std::cos(yaw) < std::cos(limit.maxAngle))
        item.fault(fmt::format("link {} is bent by more than max_link_angle, {:.6g}", entry + 1, limit.maxAngle));
}

std::optional<Eigen::VectorXd> readJoints(const Field &field, double slide, const SpatialRobotDraft &robot)
{
    if (!robot.universal)
        return std::nullopt;
    const std::vector<Field> items = field.items(1, mostEntries);
    std::vector<double> values;
    if (robot.hasSlide)
        values.push_back(slide);
    bool sound = !items.empty();
    for (const Field &item : items)
    {
        const std::vector<double> entry = readEntry(item, *robot.universal);
        sound = sound && !entry.empty();
        values.insert(values.end(), entry.begin(), entry.end());
    }
    const auto count = static_cast<std::size_t>(robot.entryCount);
    if (count > 0 && !items.empty() && items.size() != count)
    {
        field.fault(fmt::format("must have one entry for each of the {} links, not {}", count, items.size()));
        sound = false;
    }
    if (!sound || !robot.arm)
        return std::nullopt;
    const Eigen::VectorXd q = Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
    for (std::size_t i = 0; i < items.size(); ++i)
        checkLimits(items[i], static_cast<int>(i), q, robot);
    return q;
}
}  // namespace

std::optional<Eigen::VectorXd> readSpatialState(const Mapping &entry, const SpatialRobotDraft &robot)
{
    const std::size_t faultsBefore = entry.field().faults().count();
    const std::optional<double> slide = readSlideValue(entry, robot);
    std::optional<Eigen::VectorXd> state = readJoints(entry.optional("joints"), slide.value_or(0.0), robot);
    return entry.field().faults().count() == faultsBefore ? state : std::nullopt;
}
}  // namespace narrows
