// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <set>

#include "benchmark/Cores.h"
#include "benchmark/Experiment.h"
#include "benchmark/Hypothesis.h"
#include "benchmark/IniFile.h"
#include "benchmark/PlannerSection.h"
#include "benchmark/Setting.h"
#include "benchmark/SweepSection.h"
#include "benchmark/Text.h"
#include "scenario/InputText.h"
#include "scenario/families/Family.h"

namespace narrows
{
namespace
{
constexpr std::int64_t mostChecks = 1'000'000'000'000'000;  // that a double tells from its neighbours

class ExperimentReader
{
public:
    ExperimentReader(std::string text, const std::string &path, int mostScenes) : mostScenes_(mostScenes)
    {
        result_.file = path;
        result_.text = std::move(text);
        checkInputText(result_.text, path);
        result_.output = std::filesystem::path(path).parent_path().string();
        result_.jobs = std::max(1, static_cast<int>(usablePhysicalCores().size()));
    }

    Experiment read()
    {
        const std::vector<IniEntry> entries = parseIni(result_.text, result_.file, faults_);
        std::vector<IniEntry> plannerEntries;
        std::vector<IniEntry> sweepEntries;
        std::vector<IniEntry> hypothesisEntries;
        for (const IniEntry &entry : entries)
            if (entry.section == "planner")
                plannerEntries.push_back(entry);
            else if (entry.section == "sweep")
                sweepEntries.push_back(entry);
            else if (entry.section == "hypothesis")
                hypothesisEntries.push_back(entry);
            else
                readSetting(entry);
        axes_ = readSweepSection(sweepEntries, result_.file, mostScenes_, faults_);
        requireSettings();
        readScenarios();
        result_.output = resolved(output_);
        tryOptions();
        result_.planners = readPlannerSection(plannerEntries, result_.file, space_, result_.scenarios, faults_);
        if (plannerEntries.empty())
            fault(0, "planner", "there is no planner; add a [planner] section with lines like `rrtconnect =`");
        if (faults_.empty())  // what they speak of must be sound first
            result_.hypotheses = readHypothesisSection(hypothesisEntries, result_, faults_);
        if (!faults_.empty())
            throw InputError(sortedFaults());
        return result_;
    }

private:
    void fault(int line, const std::string &key, const std::string &reason)
    {
        faults_.push_back({result_.file, line, key, reason});
    }

    /// By line, then those of the scenarios in the order they were found.
    std::vector<InputFault> sortedFaults() const
    {
        std::vector<InputFault> sorted = faults_;
        const auto place = [this](const InputFault &fault)
        {
            return fault.file == result_.file ? fault.line : std::numeric_limits<int>::max();
        };
        std::stable_sort(sorted.begin(), sorted.end(),
                         [&](const InputFault &a, const InputFault &b) { return place(a) < place(b); });
        return sorted;
    }

    std::map<std::string, Setting> settings()
    {
        return {{"problem.name", word(result_.name)},
                {"problem.scenario", list(scenarioFiles_)},
                {"benchmark.time_limit", number(result_.timeLimit, "0.001")},
                {"benchmark.mem_limit", number(result_.memoryLimit, "1")},
                {"benchmark.grace", number(result_.grace, "0")},
                {"benchmark.state_check_limit", integer(result_.stateCheckLimit, std::int64_t{0}, mostChecks)},
                {"benchmark.evaluation_limit", integer(result_.evaluationLimit, std::int64_t{0}, mostChecks)},
                {"benchmark.run_count", integer(result_.runCount, 1, 1000000)},
                {"benchmark.seed", integer<std::uint32_t>(result_.seed, 0)},
                {"benchmark.output",
                 [this](const std::string &value)
                 {
                     return output_ = value, std::string();
                 }},
                {"benchmark.save_paths", oneOf<SavePaths>(result_.savePaths, {{"none", SavePaths::None},
                                                                              {"shortest", SavePaths::Shortest},
                                                                              {"all", SavePaths::All}})},
                {"benchmark.simplify", oneOf<bool>(result_.simplify, {{"0", false}, {"1", true}})},
                {"benchmark.limits", motionLimits(result_.limits)},
                {"benchmark.checker", list(result_.checkers)},
                {"benchmark.motion", list(result_.motions)},
                {"benchmark.space", word(space_)},
                {"benchmark.warm_up", number(result_.warmUp, "0")},
                {"benchmark.canary", integer(result_.canary, 0, 1000000)},
                {"benchmark.jobs", integer(result_.jobs, 1, 1024)},
                {"benchmark.pin", oneOf<bool>(result_.pin, {{"0", false}, {"1", true}})}};
    }

    void readSetting(const IniEntry &entry)
    {
        const std::string name = entry.section + "." + entry.key;
        const std::map<std::string, Setting> known = settings();
        if (entry.section.empty())
            return fault(entry.line, entry.key, "stands outside of any section");
        if (entry.section != "problem" && entry.section != "benchmark")
            return fault(entry.line, name,
                         "unknown section; there are problem, benchmark, sweep, planner and hypothesis");
        if (known.count(name) == 0)
            return fault(entry.line, name, "unknown key" + knownKeys(known, entry.section));
        if (!lines_.emplace(name, entry.line).second)
            return fault(entry.line, name, "already given in line " + std::to_string(lines_.at(name)));
        const std::string reason = known.at(name)(entry.value);
        if (!reason.empty())
            fault(entry.line, name, reason);
    }

    static std::string knownKeys(const std::map<std::string, Setting> &known, const std::string &section)
    {
        std::vector<std::string> names;
        for (const auto &[name, setting] : known)
            if (name.rfind(section + ".", 0) == 0)
                names.push_back(name.substr(section.size() + 1));
        return names.empty() ? "" : "; this section has " + joined(names, ", ");
    }

    void requireSettings()
    {
        for (const char *name : {"problem.name", "problem.scenario"})
            if (lines_.count(name) == 0)
                fault(0, name, "is missing");
    }

    /// Paths in the file are relative to it, so that it works from any folder.
    std::string resolved(const std::string &path) const
    {
        return (std::filesystem::path(result_.file).parent_path() / path).lexically_normal().string();
    }

    void readScenarios()
    {
        for (const std::string &name : scenarioFiles_)
        {
            if (name.empty())
                continue;  // already reported as a bad list
            const std::string path = resolved(name);
            std::error_code error;  // a name may be too long to be asked about
            if (!std::filesystem::is_regular_file(path, error))
                fault(lines_.at("problem.scenario"), "problem.scenario", "there is no file " + path);
            else
                readScenarioFile(path);
        }
        for (const SweepAxis &axis : axes_)
            if (faults_.empty() && swept_.count(axis.scenario) == 0)
                fault(axis.line, keyOf(axis),
                      axis.scenario.empty() ? "no scenario of this experiment has `generate` and no axes of its own"
                                            : "no scenario with `generate` is called '" + axis.scenario + "'");
    }

    /// One scenario; of a file with `generate` one for every combination of the sweep.
    void readScenarioFile(const std::string &path)
    {
        try
        {
            const Scenario scenario = readScenario(path);
            const std::vector<SweepAxis> axes = axesOf(scenario.name, axes_);
            if (axes.empty() || scenario.family.empty())
                addScenario(scenario);
            else if (takesSweep(findFamily(scenario.family), axes))
                for (const GenerateSettings &settings : combinations(axes))
                    addScenario(readScenario(path, settings));
        }
        catch (const InputError &error)
        {
            faults_.insert(faults_.end(), error.faults().begin(), error.faults().end());
        }
    }

    void addScenario(const Scenario &scenario)
    {
        if (!names_.insert(scenario.name).second)
            fault(lines_.at("problem.scenario"), "problem.scenario",
                  "two of the scenarios are called '" + scenario.name + "'");
        result_.scenarios.push_back(std::make_shared<const Scenario>(scenario));
    }

    static std::string keyOf(const SweepAxis &axis)
    {
        return "sweep." + (axis.scenario.empty() ? "" : axis.scenario + ".") + "generate." + axis.parameter;
    }

    bool takesSweep(const Family &family, const std::vector<SweepAxis> &axes)
    {
        const std::size_t before = faults_.size();
        for (const SweepAxis &axis : axes)
            try
            {
                swept_.insert(axis.scenario);
                for (const std::string &value : axis.values)
                    family.parameter(axis.parameter).read(value);
            }
            catch (const std::invalid_argument &error)
            {
                fault(axis.line, keyOf(axis), error.what());
            }
        return faults_.size() == before;
    }

    /// Lets makeProblem() judge the values of the options, one at a time.
    void tryOptions()
    {
        for (const std::string &checker : result_.checkers)
            tryOption("benchmark.checker", [&](ProblemOptions &options) { options.checker = checker; });
        for (const std::string &motion : result_.motions)
            tryOption("benchmark.motion", [&](ProblemOptions &options) { options.motion = motion; });
        if (!tryOption("benchmark.space", [&](ProblemOptions &options) { options.space = space_; }))
            space_ = ProblemOptions().space;  // reported once, not again for every planner
    }

    bool tryOption(const std::string &name, const std::function<void(ProblemOptions &)> &change)
    {
        const auto line = lines_.find(name);
        if (line == lines_.end() || result_.scenarios.empty())
            return true;
        ProblemOptions options;
        change(options);
        try
        {
            makeProblem(*result_.scenarios.front(), options);
            return true;
        }
        catch (const std::invalid_argument &error)
        {
            fault(line->second, name, error.what());
            return false;
        }
    }

    int mostScenes_;
    Experiment result_;
    std::vector<InputFault> faults_;
    std::map<std::string, int> lines_;  ///< of the settings given
    std::vector<std::string> scenarioFiles_;
    std::set<std::string> names_;  ///< of the scenarios
    std::vector<SweepAxis> axes_;
    std::set<std::string> swept_;  ///< scenarios of the axes that have met a file they are for
    std::string space_ = ProblemOptions().space;
    std::string output_;
};
}  // namespace

Experiment readExperiment(const std::string &path)
{
    return parseExperiment(readInputText(path), path);
}

Experiment parseExperiment(const std::string &text, const std::string &path, int mostScenes)
{
    return ExperimentReader(text, path, mostScenes).read();
}
}  // namespace narrows
