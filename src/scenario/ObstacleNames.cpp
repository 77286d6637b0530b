// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ObstacleNames.h"

#include <fmt/format.h>

namespace narrows
{
namespace
{
std::string readName(const Mapping &entry, std::size_t number)
{
    const Field field = entry.optional("name");
    const std::string byPlace = fmt::format("obstacle {}", number);
    const std::string name = field.given() ? field.text().value_or(byPlace) : byPlace;
    if (printable(name) == name)
        return name;
    field.fault("must be at most 60 characters without control characters");
    return byPlace;
}
}  // namespace

std::string ObstacleNames::read(const Mapping &entry)
{
    std::string name = readName(entry, names_.size() + 1);
    const auto [first, isNew] = firstLine_.try_emplace(name, entry.field().line());
    if (!isNew)
        (entry.has("name") ? entry.optional("name") : entry.field())
            .fault(fmt::format("the name '{}' is already that of the obstacle in line {}", name, first->second));
    names_.push_back(name);
    return name;
}
}  // namespace narrows
