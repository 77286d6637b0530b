// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "scenario/YamlField.h"

namespace narrows
{
/// The entries of a YAML mapping. Duplicate keys are reported when it is made.
class Mapping
{
public:
    explicit Mapping(const Field &field);

    const Field &field() const { return field_; }
    /// False if the place is not a mapping; a lack of entries is then no further fault.
    bool valid() const { return valid_; }
    /// A missing entry is reported.
    Field required(const std::string &name) const;
    Field optional(const std::string &name) const;
    bool has(const std::string &name) const { return index_.count(name) > 0; }
    /// Reports every other entry, with the known name it may have been meant to be.
    void allowOnly(const std::vector<std::string> &names) const;

    struct Entry
    {
        std::string name;
        Field value;
    };
    const std::vector<Entry> &entries() const { return entries_; }

private:
    Field field_;
    std::vector<Entry> entries_;
    std::unordered_map<std::string, std::size_t> index_;  ///< into entries_
    bool valid_ = false;
};
}  // namespace narrows
