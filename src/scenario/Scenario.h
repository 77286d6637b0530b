// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/PlanarModel.h"

namespace narrows
{
/// One thing wrong with an input file.
struct InputFault
{
    std::string file;
    int line;            ///< 1-based; 0 if it is about the whole file
    std::string key;     ///< dotted, with indices: robot.links[2].length; empty if it is about the whole file
    std::string reason;  ///< what is wrong and what would be right

    /// "file:line: key: reason"
    std::string text() const;
};

/// Thrown by readers of input files; carries every fault that was found, not just the first.
class InputError : public std::runtime_error
{
public:
    explicit InputError(std::vector<InputFault> faults);
    const std::vector<InputFault> &faults() const { return faults_; }

private:
    std::vector<InputFault> faults_;
};

/// Typed copy of a scenario file (`narrows/scenario/1`, docs/scenarios.md).
struct Scenario
{
    std::string name;    ///< one word
    std::string source;  ///< where the problem comes from; may be empty
    std::string text;    ///< the file as it was read
    std::shared_ptr<const PlanarModel> model;
    PlanarTask task;                                         ///< absolute angles, whatever the file uses
    AngleConvention convention = AngleConvention::Absolute;  ///< how the file writes its angles
    /// methods.<planner>.<parameter> as parameter texts for `makePlanner`: what a paper prescribes for its own method.
    /// For hppm: `repulsion` comma-separated in the order of the obstacles, `rows` with "; " between rows and ", "
    /// within, `direction` comma-separated, everything else as written.
    std::map<std::string, std::map<std::string, std::string>> methods;
};

/// \throws InputError with all faults of the file, including a start or goal in collision or out of limits.
Scenario readScenario(const std::string &path);

/// The same for text that is already in memory; `file` is what error messages call it.
Scenario parseScenario(const std::string &text, const std::string &file);
}  // namespace narrows
