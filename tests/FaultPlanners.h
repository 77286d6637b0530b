// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "benchmark/Record.h"

namespace narrows
{
/// A planner that does something no planner should, and how a run of it must end.
struct Fault
{
    std::string planner;
    Outcome outcome;
    std::string reason;  ///< part of the record's reason
};

/// Puts the faulty planners into the factory, once per process, and lists them. Left out are those that a build with
/// AddressSanitizer cannot have: the sanitizer needs the address space that the runner would limit.
const std::vector<Fault> &faultPlanners();

/// If not negative, planners that stay around write a byte here when they begin.
extern int faultSignal;
}  // namespace narrows
