// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scenario/Scenario.h"

namespace narrows
{
/// The faults of one input file, gathered until all of it has been read.
class FaultList
{
public:
    explicit FaultList(std::string file) : file_(std::move(file)) {}

    /// \param line 1-based; 0 if the fault is about the whole file
    void add(int line, const std::string &key, const std::string &reason);
    std::size_t count() const { return faults_.size(); }

    /// \throws InputError with the faults in the order of their lines, if there are any.
    void throwIfAny() const;

private:
    std::string file_;
    std::vector<InputFault> faults_;
};

/// The known word nearest to `word` as "; did you mean 'x'?", or nothing if none is within two edits.
std::string suggestion(const std::string &word, const std::vector<std::string> &known);
}  // namespace narrows
