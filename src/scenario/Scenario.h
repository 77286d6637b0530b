// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scenario/World.h"
#include "validity/Confinement.h"

namespace narrows
{
/// One thing wrong with an input file.
struct InputFault
{
    std::string file;    ///< path as it was given
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
    explicit InputError(std::vector<InputFault> faults);  ///< \param faults not empty; what() lists them, one a line
    /// Everything that is wrong, in the order of the file.
    const std::vector<InputFault> &faults() const { return faults_; }

private:
    std::vector<InputFault> faults_;
};

/// Typed copy of a scenario file (`narrows/scenario/1`, docs/scenarios.md).
struct Scenario
{
    std::string name;    ///< one word
    std::string source;  ///< where the problem comes from; may be empty
    std::string text;    ///< the file as it was read; if it has `generate`, the file that this stands for
    std::string base;    ///< the name its file gives, which all share that a sweep makes of one file
    std::string group;   ///< the name but for the seed of a sweep: what tables put together
    std::string family;  ///< that it was drawn from; empty if the file lists its obstacles
    World world;         ///< robot, obstacles and task, of one of the two kinds
    std::optional<Confinement> infeasible;  ///< the proof, checked, that there is no way, if the file has one
    /// `methods.PLANNER.PARAMETER` as parameter texts for `makePlanner`: what a paper prescribes for its own method.
    /// For hppm: `repulsion` comma-separated in the order of the obstacles, `rows` with "; " between rows and ", "
    /// within, `direction` comma-separated, everything else as written.
    std::map<std::string, std::map<std::string, std::string>> methods;

    /// May it be meant by this word?
    bool isCalled(const std::string &word) const { return word == name || word == group || word == base; }

    /// Does the robot live in the plane?
    bool isPlanar() const { return std::holds_alternative<PlanarWorld>(world); }
    /// \throws std::bad_variant_access if the robot lives in space
    const PlanarWorld &planar() const { return std::get<PlanarWorld>(world); }
    /// \throws std::bad_variant_access if the robot lives in space
    PlanarWorld &planar() { return std::get<PlanarWorld>(world); }
    /// \throws std::bad_variant_access if the robot lives in the plane
    const SpatialWorld &spatial() const { return std::get<SpatialWorld>(world); }
    /// \throws std::bad_variant_access if the robot lives in the plane
    SpatialWorld &spatial() { return std::get<SpatialWorld>(world); }
};

/// Values for the parameters of a family, by name, that replace those of the file's `generate`.
using GenerateSettings = std::vector<std::pair<std::string, std::string>>;

/// \throws InputError with all faults of the file, including a start or goal in collision or out of limits, and
/// settings that the file's family does not take.
Scenario readScenario(const std::string &path, const GenerateSettings &settings = {});

/// The same for text that is already in memory; `file` is what error messages call it.
Scenario parseScenario(const std::string &text, const std::string &file, const GenerateSettings &settings = {});
}  // namespace narrows
