// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ConfinementReader.h"

#include "scenario/YamlMapping.h"

namespace narrows
{
namespace
{
std::optional<std::array<double, 2>> readAlong(const Field &field)
{
    if (!field.given())
        return std::array<double, 2>{0.0, 0.0};
    const std::vector<Field> ends = field.items(2, 2);
    if (ends.size() != 2)
        return std::nullopt;
    const std::optional<double> lower = ends[0].number(), upper = ends[1].number();
    if (!lower || !upper)
        return std::nullopt;
    return std::array<double, 2>{*lower, *upper};
}
}  // namespace

std::optional<Confinement> readConfinement(const Field &field, const PlanarWorld &world)
{
    if (!field.given())
        return std::nullopt;
    const Mapping mapping(field);
    mapping.allowOnly({"first_joint", "along"});
    const Field first = mapping.required("first_joint");
    const std::optional<Interval> values = world.model->arm.slide() ? first.interval() : first.angleInterval();
    const std::optional<std::array<double, 2>> along = readAlong(mapping.optional("along"));
    if (!values || !along)
        return std::nullopt;
    const Confinement confinement{*values, *along};
    const std::string reason = whyNoProof(confinement, *world.model, world.task);
    if (!reason.empty())
        field.fault("proves nothing: " + reason);
    return reason.empty() ? std::optional<Confinement>(confinement) : std::nullopt;
}
}  // namespace narrows
