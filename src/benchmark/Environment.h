// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace narrows
{
/// What a measurement depends on besides the program's input: names and values, in a fixed order.
struct Environment
{
    std::string hostname;
    std::string cpu;                                         ///< model name and number of cores
    std::vector<std::pair<std::string, std::string>> facts;  ///< commit, compiler, kernel, library versions, load, ...
};

/// Looks at the machine as it is now.
/// \param jobs runs that will be done at a time
Environment captureEnvironment(int jobs);

/// "OMPL 1.5.2", from the version's numbers: the text of Debian's headers is empty.
std::string omplVersion();
}  // namespace narrows
