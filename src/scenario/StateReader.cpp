// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/StateReader.h"

#include <cmath>

#include <fmt/format.h>

namespace narrows
{
namespace
{
/// Largest error of a link's length between given points, relative to the length. Printed coordinates are rounded: the
/// worst one of HPPM-PRA's cases 1 and 2 is off by 0.0019, while the mistakes in print of its case 3 start at 1 %,
/// where the angle of a link would be off by as much as 0.01 rad and should be given instead.
constexpr double lengthTolerance = 0.005;
constexpr std::size_t mostEntries = 1000;  // as many as a robot may have links

/// True iff the list has one entry per link. A list is judged even if the rest of the robot is not sound.
bool fitsLinks(const Field &field, const std::vector<Field> &items, const RobotDraft &robot)
{
    const auto count = static_cast<std::size_t>(robot.linkCount);
    if (count == 0 || items.empty() || items.size() == count)
        return !items.empty();
    field.fault(fmt::format("must have one entry for each of the {} links, not {}", count, items.size()));
    return false;
}

void checkLimit(const Field &at, double angle, std::size_t link, const RobotDraft &robot)
{
    const std::optional<Interval> &limit = robot.limits.angles[link];
    if (limit && !(angle >= limit->lower && angle <= limit->upper))
        at.fault(fmt::format("the angle {} of link {} is out of its limits [{}, {}]", angle, link + 1, limit->lower,
                             limit->upper));
}

std::optional<double> readSlideValue(const Mapping &entry, const RobotDraft &robot)
{
    if (!robot.hasSlide)
    {
        if (entry.has("slide"))
            entry.optional("slide").fault("the robot has no sliding base (kind: planar_chain has one)");
        return 0.0;
    }
    const Field field = entry.required("slide");
    const std::optional<double> value = field.number();
    if (!value || !robot.arm)
        return value;
    const Slide &slide = *robot.arm->slide();
    if (*value < slide.lower || *value > slide.upper)
        field.fault(fmt::format("{} is out of the slide's limits [{}, {}]", *value, slide.lower, slide.upper));
    return value;
}

/// In the file's convention, slide first.
std::optional<Eigen::VectorXd> readAngles(const Field &field, double slide, const RobotDraft &robot)
{
    const std::vector<Field> items = field.items(1, mostEntries);
    std::vector<double> angles;
    for (const Field &item : items)
        if (const std::optional<double> angle = item.angle())
            angles.push_back(*angle);
    if (!fitsLinks(field, items, robot) || angles.size() != items.size() || !robot.arm)
        return std::nullopt;

    Eigen::VectorXd q(robot.arm->dimension());
    if (robot.hasSlide)
        q[0] = slide;
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
        q[robot.arm->firstAngle() + static_cast<int>(i)] = angles[i];
        checkLimit(items[i], angles[i], i, robot);
    }
    return robot.arm->toAbsolute(q, robot.convention);
}

/// atan2 in (-pi, pi].
double directionOf(const Eigen::Vector2d &v)
{
    const double angle = std::atan2(v.y(), v.x());
    return angle <= -M_PI ? M_PI : angle;  // -pi comes from a negative zero
}

/// Points fix a joint's angle up to full turns: the turn that lies within the limits, else in (-pi, pi].
double chooseTurn(double angle, const std::optional<Interval> &limit)
{
    constexpr double turn = 2.0 * M_PI;
    const double wrapped = angle - turn * std::ceil((angle - M_PI) / turn);
    if (!limit)
        return wrapped;
    const double raised = wrapped + turn * std::ceil((limit->lower - wrapped) / turn);
    return wrapped >= limit->lower && wrapped <= limit->upper ? wrapped : (raised <= limit->upper ? raised : wrapped);
}

/// Absolute angles of links with the given tips; reports links that are not as long as they should be.
Eigen::VectorXd anglesOf(const std::vector<Field> &items, const std::vector<Eigen::Vector2d> &tips, double slide,
                         const PlanarArm &arm)
{
    const Eigen::Vector2d base = arm.slide() ? arm.base() + slide * arm.slide()->axis : arm.base();
    Eigen::VectorXd q(arm.dimension());
    if (arm.slide())
        q[0] = slide;
    for (std::size_t i = 0; i < tips.size(); ++i)
    {
        const PlanarLink &link = arm.links()[i];
        const Eigen::Vector2d along = tips[i] - (link.parent < 0 ? base : tips[static_cast<std::size_t>(link.parent)]);
        q[arm.firstAngle() + static_cast<int>(i)] = directionOf(along);
        if (std::abs(along.norm() - link.length) > lengthTolerance * link.length)
            items[i].fault(
                fmt::format("link {} would be {:.6g} long there, but its length is {:.6g} (0.5 % is allowed)", i + 1,
                            along.norm(), link.length));
    }
    return q;
}

std::optional<Eigen::VectorXd> readPoints(const Field &field, double slide, const RobotDraft &robot)
{
    const std::vector<Field> items = field.items(1, mostEntries);
    std::vector<Eigen::Vector2d> tips;
    for (const Field &item : items)
        if (const std::optional<Eigen::Vector2d> tip = item.point())
            tips.push_back(*tip);
    if (!fitsLinks(field, items, robot) || tips.size() != items.size() || !robot.arm)
        return std::nullopt;

    const PlanarArm &arm = *robot.arm;
    Eigen::VectorXd joints = arm.fromAbsolute(anglesOf(items, tips, slide, arm), robot.convention);
    for (std::size_t i = 0; i < tips.size(); ++i)
    {
        double &angle = joints[arm.firstAngle() + static_cast<int>(i)];
        angle = chooseTurn(angle, robot.limits.angles[i]);
        checkLimit(items[i], angle, i, robot);
    }
    return arm.toAbsolute(joints, robot.convention);
}
}  // namespace

std::optional<Eigen::VectorXd> readState(const Mapping &entry, const RobotDraft &robot)
{
    const std::size_t faultsBefore = entry.field().faults().count();
    const std::optional<double> slide = readSlideValue(entry, robot);
    const Field angles = entry.optional("angles");
    const Field points = entry.optional("points");
    if (angles.given() && points.given())
        points.fault("the state is already given by angles");
    std::optional<Eigen::VectorXd> state = angles.given() ? readAngles(angles, slide.value_or(0.0), robot)
                                                          : readPoints(points, slide.value_or(0.0), robot);
    return entry.field().faults().count() == faultsBefore ? state : std::nullopt;
}
}  // namespace narrows
