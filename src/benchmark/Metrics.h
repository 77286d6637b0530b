// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "benchmark/Record.h"

namespace narrows
{
/// What a cell of the database may hold; the first is NULL: not measured.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// One thing known of every run: a column of the table `runs`, after OMPL's three.
struct Metric
{
    std::string name;
    std::string type;     ///< as OMPL's logs say it: REAL, INTEGER, BOOLEAN, ENUM, TEXT
    std::string meaning;  ///< one line, with the unit
    std::function<Cell(const RunSpec &, const Record &)> value;
};

/// In the order of the columns: OMPL's first, under OMPL's names where the meaning is OMPL's.
const std::vector<Metric> &metrics();

/// Is it a time, an amount of memory or a place on the machine, which differ from run to run of one spec? All others
/// are the same for the same seed, for planners without threads.
bool isMeasured(const Metric &metric);
}  // namespace narrows
