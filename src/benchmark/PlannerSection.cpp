// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/PlannerSection.h"

#include <algorithm>
#include <set>

#include "benchmark/Text.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
/// An entry and where in the file it stands.
struct Draft
{
    PlannerChoice choice;
    int line = 0;
    bool known = false;                ///< is there such a planner?
    std::map<std::string, int> lines;  ///< of the sub-keys
};

class PlannerSection
{
public:
    PlannerSection(const std::string &file, const std::string &space,
                   const std::vector<std::shared_ptr<const Scenario>> &scenarios, std::vector<InputFault> &faults)
      : file_(file), space_(space), scenarios_(scenarios), faults_(faults)
    {
    }

    void read(const IniEntry &entry)
    {
        const std::size_t dot = entry.key.find('.');
        if (dot == std::string::npos)
            begin(entry);
        else
            set(entry, entry.key.substr(0, dot), entry.key.substr(dot + 1));
    }

    std::vector<PlannerChoice> finish()
    {
        label();
        std::vector<PlannerChoice> choices;
        for (const Draft &draft : drafts_)
        {
            if (draft.known)
                tryOut(draft);
            choices.push_back(draft.choice);
        }
        return choices;
    }

private:
    void fault(int line, const std::string &key, const std::string &reason)
    {
        faults_.push_back({file_, line, key, reason});
    }

    /// Reports an unknown planner once, not again for each of its parameters.
    bool isKnown(const IniEntry &entry, const std::string &planner)
    {
        try
        {
            findPlanner(planner);
            return true;
        }
        catch (const std::invalid_argument &error)
        {
            if (unknown_.insert(planner).second)
                fault(entry.line, entry.key, error.what());
            return false;
        }
    }

    void begin(const IniEntry &entry)
    {
        Draft draft;
        draft.choice.planner = entry.key;
        draft.choice.space = space_;
        draft.line = entry.line;
        draft.known = isKnown(entry, entry.key);
        if (!entry.value.empty())
            fault(entry.line, entry.key,
                  "takes no value; parameters are written `" + entry.key + ".<parameter> = ...` below it");
        drafts_.push_back(draft);
    }

    void set(const IniEntry &entry, const std::string &planner, const std::string &key)
    {
        const auto draft = std::find_if(drafts_.rbegin(), drafts_.rend(),
                                        [&](const Draft &other) { return other.choice.planner == planner; });
        if (draft == drafts_.rend())
        {
            if (isKnown(entry, planner))
                fault(entry.line, entry.key, "there is no `" + planner + " =` above it");
        }
        else if (!draft->lines.emplace(key, entry.line).second)
            fault(entry.line, entry.key,
                  "already given in line " + std::to_string(draft->lines.at(key)) + "; another `" + planner +
                      " =` begins a second entry");
        else
            assign(draft->choice, entry, key);
    }

    void assign(PlannerChoice &choice, const IniEntry &entry, const std::string &key)
    {
        if (key == "name" && entry.value.empty())
            fault(entry.line, entry.key, "is empty");
        else if (key == "name")
            choice.label = entry.value;
        else if (key == "space")
            choice.space = entry.value;
        else if (key == "recipe" && entry.value != "scenario" && entry.value != "none")
            fault(entry.line, entry.key, "'" + entry.value + "' is neither `scenario` nor `none`");
        else if (key == "recipe")
            choice.recipe = entry.value == "scenario";
        else if (key == "only")
            limit(choice, entry);
        else
            choice.parameters[key] = entry.value;
    }

    void limit(PlannerChoice &choice, const IniEntry &entry)
    {
        const std::vector<std::string> names = split(entry.value, ',');
        if (names.empty())
            fault(entry.line, entry.key, "names no scenario");
        for (const std::string &name : names)
            if (std::any_of(scenarios_.begin(), scenarios_.end(),
                            [&](const auto &scenario) { return scenario->isCalled(name); }))
                choice.only.push_back(name);
            else
                fault(entry.line, entry.key, "no scenario of this experiment is called '" + name + "'");
    }

    /// Names the entries that were given none, and refuses two of one name for one scenario.
    void label()
    {
        std::map<std::string, int> count;
        for (const Draft &draft : drafts_)
            ++count[draft.choice.planner];
        for (Draft &draft : drafts_)
            if (draft.choice.label.empty())
                draft.choice.label = count[draft.choice.planner] > 1 ? describe(draft) : draft.choice.planner;
        for (std::size_t i = 0; i < drafts_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                refuseTwins(drafts_[j], drafts_[i]);
    }

    static std::string describe(const Draft &draft)
    {
        std::string text = draft.choice.planner;
        for (const auto &[name, value] : draft.choice.parameters)
            text += " " + name + "=" + value;
        if (draft.lines.count("space") != 0)
            text += " " + draft.choice.space;
        if (!draft.choice.recipe)
            text += " without recipe";
        return text;
    }

    void refuseTwins(const Draft &first, const Draft &second)
    {
        if (first.choice.label != second.choice.label)
            return;
        for (const auto &scenario : scenarios_)
            if (first.choice.isFor(*scenario) && second.choice.isFor(*scenario))
                return fault(second.line, second.choice.planner,
                             "is called '" + second.choice.label + "' like the entry in line " +
                                 std::to_string(first.line) + "; tell them apart by `" + second.choice.planner +
                                 ".name = ...`");
    }

    void tryOut(const Draft &draft)
    {
        // What fits one scenario of a group fits all; and what does not fit one, the next would only repeat.
        std::set<std::string> groups;
        for (const auto &scenario : scenarios_)
            if (draft.choice.isFor(*scenario) && groups.insert(scenario->group).second && !fits(draft, *scenario))
                return;
    }

    bool fits(const Draft &draft, const Scenario &scenario)
    {
        const bool own = draft.lines.count("space") != 0;
        std::string reason;
        if (const auto problem = tryProblem(scenario, draft.choice.space, reason))
            return acceptsParameters(draft, problem->context);
        fault(own ? draft.lines.at("space") : draft.line, draft.choice.planner + (own ? ".space" : ""), reason);
        // The parameters can be judged all the same: the scenario's own space always fits.
        if (const auto problem = tryProblem(scenario, ProblemOptions().space, reason))
            acceptsParameters(draft, problem->context);
        return false;
    }

    static std::optional<Problem> tryProblem(const Scenario &scenario, const std::string &space, std::string &reason)
    {
        ProblemOptions options;
        options.space = space;
        try
        {
            return makeProblem(scenario, options);
        }
        catch (const std::invalid_argument &error)
        {
            reason = error.what();
            return std::nullopt;
        }
    }

    /// One parameter at a time, so that each fault finds its line, then all together. A planner that cannot do the
    /// scenario is not asked: its runs will say so.
    bool acceptsParameters(const Draft &draft, const PlannerContext &context)
    {
        if (!whyUnsupported(draft.choice.planner, context).empty())
            return true;
        const std::size_t before = faults_.size();
        const std::string &planner = draft.choice.planner;
        for (const auto &[name, value] : draft.choice.parameters)
            tryParameters(draft.lines.at(name), planner + "." + name, planner, context, {{name, value}});
        if (faults_.size() == before)
            tryParameters(draft.line, planner, planner, context, draft.choice.parameters);
        return faults_.size() == before;
    }

    void tryParameters(int line, const std::string &key, const std::string &planner, const PlannerContext &context,
                       const std::map<std::string, std::string> &parameters)
    {
        try
        {
            makePlanner(planner, context, parameters);
        }
        catch (const ParameterError &error)
        {
            fault(line, key, error.what());
        }
    }

    const std::string &file_;
    const std::string &space_;
    const std::vector<std::shared_ptr<const Scenario>> &scenarios_;
    std::vector<InputFault> &faults_;
    std::vector<Draft> drafts_;
    std::set<std::string> unknown_;
};
}  // namespace

std::vector<PlannerChoice> readPlannerSection(const std::vector<IniEntry> &entries, const std::string &file,
                                              const std::string &space,
                                              const std::vector<std::shared_ptr<const Scenario>> &scenarios,
                                              std::vector<InputFault> &faults)
{
    PlannerSection section(file, space, scenarios, faults);
    for (const IniEntry &entry : entries)
        section.read(entry);
    return section.finish();
}
}  // namespace narrows
