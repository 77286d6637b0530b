// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/YamlMapping.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace narrows
{
Mapping::Mapping(const Field &field) : field_(field)
{
    if (!field.given())
        return;
    if (!field.node().IsMap())
    {
        field.fault(fmt::format("must be a mapping (key: value), not {}", describe(field.node())));
        return;
    }
    valid_ = true;
    for (const auto &pair : field.node())
    {
        const int line = lineOf(pair.first);
        if (!pair.first.IsScalar())
        {
            field.faults().add(line, field.key(), fmt::format("a key must be a word, not {}", describe(pair.first)));
            continue;
        }
        const std::string name = pair.first.Scalar();
        const std::string key = (field.key().empty() ? "" : field.key() + ".") + printable(name);
        const auto [place, isNew] = index_.try_emplace(name, entries_.size());
        if (isNew)
            entries_.push_back({name, Field(field.faults(), pair.second, key, line)});
        else
            field.faults().add(line, key, fmt::format("given twice; first in line {}", optional(name).line()));
    }
}

Field Mapping::optional(const std::string &name) const
{
    const auto found = index_.find(name);
    if (found != index_.end())
        return entries_[found->second].value;
    return {field_.faults(), field_.key().empty() ? name : field_.key() + "." + name, field_.line()};
}

Field Mapping::required(const std::string &name) const
{
    Field found = optional(name);
    if (valid_ && !found.given())
        found.fault("is missing");
    return found;
}

void Mapping::allowOnly(const std::vector<std::string> &names) const
{
    for (const Entry &entry : entries_)
    {
        if (std::find(names.begin(), names.end(), entry.name) != names.end())
            continue;
        std::string hint = suggestion(entry.name, names);
        if (hint.empty())
            hint = fmt::format("; possible here: {}", fmt::join(names, ", "));
        entry.value.fault("unknown key" + hint);
    }
}
}  // namespace narrows
