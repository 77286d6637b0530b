// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <set>
#include <thread>

#include "benchmark/Experiment.h"
#include "benchmark/IniFile.h"
#include "benchmark/PathTiming.h"
#include "benchmark/PlannerSection.h"
#include "benchmark/SweepSection.h"
#include "benchmark/Text.h"
#include "scenario/InputText.h"
#include "scenario/families/Family.h"

namespace narrows
{
namespace
{
/// Takes a value; what is wrong with it, or nothing.
using Setting = std::function<std::string(const std::string &)>;

bool isWord(const std::string &text)
{
    const auto fits = [](char c)
    {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.';
    };
    return !text.empty() && std::all_of(text.begin(), text.end(), fits);
}

Setting word(std::string &target)
{
    return [&target](const std::string &value)
    {
        target = value;
        return isWord(value) ? "" : "'" + value + "' is not one word of letters, digits, _, - and .";
    };
}

Setting number(double &target, const std::string &least)
{
    return [&target, least](const std::string &value) -> std::string
    {
        const std::optional<double> result = toNumber(value);
        if (!result || *result < *toNumber(least))
            return "'" + value + "' is not a number >= " + least;
        target = *result;
        return "";
    };
}

template <typename Integer>
Setting integer(Integer &target, Integer least, Integer most = std::numeric_limits<Integer>::max())
{
    return [&target, least, most](const std::string &value) -> std::string
    {
        const std::optional<double> result = toNumber(value);
        if (!result || *result < static_cast<double>(least) || *result > static_cast<double>(most) ||
            *result != static_cast<double>(static_cast<Integer>(*result)))
            return "'" + value + "' is not a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most);
        target = static_cast<Integer>(*result);
        return "";
    };
}

template <typename Value>
Setting oneOf(Value &target, const std::vector<std::pair<std::string, Value>> &choices)
{
    return [&target, choices](const std::string &value) -> std::string
    {
        std::vector<std::string> names;
        for (const auto &[name, meaning] : choices)
        {
            if (name == value)
            {
                target = meaning;
                return "";
            }
            names.push_back(name);
        }
        return "'" + value + "' is none of " + joined(names, ", ");
    };
}

Setting list(std::vector<std::string> &target)
{
    return [&target](const std::string &value) -> std::string
    {
        target = split(value, ',');
        std::vector<std::string> sorted = target;
        std::sort(sorted.begin(), sorted.end());
        if (sorted.empty() || sorted.front().empty())
            return "expected a list separated by commas";
        const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
        return twin == sorted.end() ? "" : "names '" + *twin + "' twice";
    };
}

Setting motionLimits(std::optional<MotionLimits> &target)
{
    return [&target](const std::string &value) -> std::string
    {
        try
        {
            target = limitsFromText(value);
            return "";
        }
        catch (const std::invalid_argument &error)
        {
            return error.what();
        }
    };
}

class ExperimentReader
{
public:
    explicit ExperimentReader(const std::string &path)
    {
        result_.file = path;
        result_.text = readInputText(path);
        checkInputText(result_.text, path);
        result_.output = std::filesystem::path(path).parent_path().string();
        result_.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    }

    Experiment read()
    {
        const std::vector<IniEntry> entries = parseIni(result_.text, result_.file, faults_);
        std::vector<IniEntry> plannerEntries;
        std::vector<IniEntry> sweepEntries;
        for (const IniEntry &entry : entries)
            if (entry.section == "planner")
                plannerEntries.push_back(entry);
            else if (entry.section == "sweep")
                sweepEntries.push_back(entry);
            else
                readSetting(entry);
        axes_ = readSweepSection(sweepEntries, result_.file, faults_);
        requireSettings();
        readScenarios();
        result_.output = resolved(output_);
        tryOptions();
        result_.planners = readPlannerSection(plannerEntries, result_.file, space_, result_.scenarios, faults_);
        if (plannerEntries.empty())
            fault(0, "planner", "there is no planner; add a [planner] section with lines like `rrtconnect =`");
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
                {"benchmark.jobs", integer(result_.jobs, 1, 1024)}};
    }

    void readSetting(const IniEntry &entry)
    {
        const std::string name = entry.section + "." + entry.key;
        const std::map<std::string, Setting> known = settings();
        if (entry.section.empty())
            return fault(entry.line, entry.key, "stands outside of any section");
        if (entry.section != "problem" && entry.section != "benchmark")
            return fault(entry.line, name, "unknown section; there are problem, benchmark, sweep and planner");
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
            if (!std::filesystem::is_regular_file(path))
                fault(lines_.at("problem.scenario"), "problem.scenario", "there is no file " + path);
            else
                readScenarioFile(path);
        }
        if (!axes_.empty() && !swept_ && faults_.empty())
            fault(axes_.front().line, "sweep.generate." + axes_.front().parameter,
                  "no scenario of this experiment has `generate`");
    }

    /// One scenario; of a file with `generate` one for every combination of the sweep.
    void readScenarioFile(const std::string &path)
    {
        try
        {
            const Scenario scenario = readScenario(path);
            if (axes_.empty() || scenario.family.empty())
                addScenario(scenario);
            else if (takesSweep(findFamily(scenario.family)))
                for (const GenerateSettings &settings : combinations(axes_))
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

    bool takesSweep(const Family &family)
    {
        swept_ = true;
        const std::size_t before = faults_.size();
        for (const SweepAxis &axis : axes_)
            try
            {
                for (const std::string &value : axis.values)
                    family.parameter(axis.parameter).read(value);
            }
            catch (const std::invalid_argument &error)
            {
                fault(axis.line, "sweep.generate." + axis.parameter, error.what());
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

    Experiment result_;
    std::vector<InputFault> faults_;
    std::map<std::string, int> lines_;  ///< of the settings given
    std::vector<std::string> scenarioFiles_;
    std::set<std::string> names_;  ///< of the scenarios
    std::vector<SweepAxis> axes_;
    bool swept_ = false;  ///< has the sweep met a scenario that it is for?
    std::string space_ = ProblemOptions().space;
    std::string output_;
};
}  // namespace

Experiment readExperiment(const std::string &path)
{
    return ExperimentReader(path).read();
}
}  // namespace narrows
