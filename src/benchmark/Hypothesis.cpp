// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Hypothesis.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include <fnmatch.h>
#include <nlohmann/json.hpp>

#include "benchmark/Text.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
const std::vector<std::string> quantities{"success", "time", "evaluations", "memory", "length"};

/// A hypothesis and where its keys stand.
struct Draft
{
    Hypothesis hypothesis;
    std::map<std::string, int> lines;
};

class HypothesisSection
{
public:
    HypothesisSection(const Experiment &experiment, std::vector<InputFault> &faults)
      : experiment_(experiment), faults_(faults)
    {
        for (const RunSpec &spec : expand(experiment))
            present_[spec.group].insert(spec.label);
    }

    void read(const IniEntry &entry)
    {
        const std::size_t dot = entry.key.find('.');
        try
        {
            if (entry.key == "alpha")
                result_.alpha = readAlpha(entry);
            else if (dot == std::string::npos)
                begin(entry);
            else
                set(entry, entry.key.substr(0, dot), entry.key.substr(dot + 1));
        }
        catch (const std::invalid_argument &error)
        {
            fault(entry.line, entry.key, error.what());
        }
    }

    Hypotheses finish()
    {
        for (Draft &draft : drafts_)
        {
            complete(draft);
            result_.all.push_back(draft.hypothesis);
        }
        return result_;
    }

private:
    void fault(int line, const std::string &key, const std::string &reason)
    {
        faults_.push_back({experiment_.file, line, "hypothesis." + key, reason});
    }

    double readAlpha(const IniEntry &entry)
    {
        const std::optional<double> value = toNumber(entry.value);
        if (!value || *value <= 0.0 || *value > 0.5)
            throw std::invalid_argument("'" + entry.value + "' is not a number above 0 and at most 0.5");
        if (!alphaLines_.insert(entry.line).second || alphaLines_.size() > 1)
            throw std::invalid_argument("already given in line " + std::to_string(*alphaLines_.begin()));
        return *value;
    }

    void begin(const IniEntry &entry)
    {
        if (find(entry.key) != nullptr)
            throw std::invalid_argument("there is a hypothesis of this name already");
        Draft draft;
        draft.hypothesis.name = entry.key;
        draft.hypothesis.statement = entry.value;
        draft.lines[""] = entry.line;
        drafts_.push_back(draft);
        if (entry.value.empty())
            throw std::invalid_argument("states nothing");
    }

    Draft *find(const std::string &name)
    {
        const auto draft = std::find_if(drafts_.begin(), drafts_.end(),
                                        [&](const Draft &other) { return other.hypothesis.name == name; });
        return draft == drafts_.end() ? nullptr : &*draft;
    }

    void set(const IniEntry &entry, const std::string &name, const std::string &key)
    {
        Draft *const draft = find(name);
        if (draft == nullptr)
            throw std::invalid_argument("there is no `" + name + " = <statement>` above it");
        if (!draft->lines.emplace(key, entry.line).second)
            throw std::invalid_argument("already given in line " + std::to_string(draft->lines.at(key)));
        Hypothesis &hypothesis = draft->hypothesis;
        if (key == "planner")
            hypothesis.planners = labels(entry.value);
        else if (key == "against")
            hypothesis.against = labels(entry.value);
        else if (key == "scenes")
            patterns_[name] = split(entry.value, ',');
        else if (key == "quantity")
            hypothesis.quantity = choice(entry.value, quantities);
        else if (key == "direction")
            hypothesis.direction = choice(entry.value, {"more", "less"});
        else if (key == "bound")
            hypothesis.bound = toNumber(entry.value);
        else
            throw std::invalid_argument(
                "unknown key; a hypothesis has planner, against, scenes, quantity, direction and bound");
        if (key == "bound" && !hypothesis.bound)
            throw std::invalid_argument("'" + entry.value + "' is not a number");
    }

    static std::string choice(const std::string &value, const std::vector<std::string> &choices)
    {
        if (std::find(choices.begin(), choices.end(), value) == choices.end())
            throw std::invalid_argument("'" + value + "' is none of " + joined(choices, ", "));
        return value;
    }

    /// Labels of planner entries; `sampling` stands for all whose planner does not see the model.
    std::vector<std::string> labels(const std::string &text) const
    {
        std::set<std::string> known, sampling;
        for (const PlannerChoice &planner : experiment_.planners)
        {
            known.insert(planner.label);
            if (!findPlanner(planner.planner).usesModel)
                sampling.insert(planner.label);
        }
        std::set<std::string> found;
        for (const std::string &word : split(text, ','))
            if (word == "sampling")
                found.insert(sampling.begin(), sampling.end());
            else if (known.count(word) != 0)
                found.insert(word);
            else
                throw std::invalid_argument("no planner entry is called '" + word + "'");
        if (found.empty())
            throw std::invalid_argument("names no planner entry");
        return {found.begin(), found.end()};
    }

    void complete(Draft &draft)
    {
        Hypothesis &hypothesis = draft.hypothesis;
        const int line = draft.lines.at("");
        for (const char *key : {"planner", "quantity", "direction"})
            if (draft.lines.count(key) == 0)
                fault(line, hypothesis.name + "." + key, "is missing");
        if (draft.lines.count("against") + draft.lines.count("bound") != 1)
            fault(line, hypothesis.name, "takes either `against` or `bound`: what its planner is compared with");
        for (const std::string &label : hypothesis.planners)
            if (std::count(hypothesis.against.begin(), hypothesis.against.end(), label) != 0)
                fault(draft.lines.at("against"), hypothesis.name + ".against", "compares '" + label + "' with itself");
        hypothesis.groups = groups(draft);
    }

    /// Those whose names fit a pattern and where all planners of the hypothesis run.
    std::vector<std::string> groups(const Draft &draft)
    {
        const Hypothesis &hypothesis = draft.hypothesis;
        const bool given = patterns_.count(hypothesis.name) != 0;
        std::set<std::string> found;
        for (const std::string &pattern : given ? patterns_.at(hypothesis.name) : std::vector<std::string>{"*"})
        {
            const std::size_t before = found.size();
            for (const auto &[group, labels] : present_)
                if (fnmatch(pattern.c_str(), group.c_str(), 0) == 0 && hasAll(labels, hypothesis))
                    found.insert(group);
            if (found.size() == before)
                fault(draft.lines.at(given ? "scenes" : ""), hypothesis.name + ".scenes",
                      "no (further) group that all its planners run on fits '" + pattern + "'");
        }
        return {found.begin(), found.end()};
    }

    static bool hasAll(const std::set<std::string> &labels, const Hypothesis &hypothesis)
    {
        const auto runs = [&](const std::string &label)
        {
            return labels.count(label) != 0;
        };
        return std::all_of(hypothesis.planners.begin(), hypothesis.planners.end(), runs) &&
               std::all_of(hypothesis.against.begin(), hypothesis.against.end(), runs);
    }

    const Experiment &experiment_;
    std::vector<InputFault> &faults_;
    std::map<std::string, std::set<std::string>> present_;  ///< labels that run, by group
    std::map<std::string, std::vector<std::string>> patterns_;
    std::vector<Draft> drafts_;
    std::set<int> alphaLines_;
    Hypotheses result_;
};
}  // namespace

Hypotheses readHypothesisSection(const std::vector<IniEntry> &entries, const Experiment &experiment,
                                 std::vector<InputFault> &faults)
{
    if (entries.empty())
        return {};
    HypothesisSection section(experiment, faults);
    for (const IniEntry &entry : entries)
        section.read(entry);
    return section.finish();
}

std::string toJson(const Hypothesis &hypothesis, double alpha)
{
    nlohmann::json json{{"name", hypothesis.name},           {"statement", hypothesis.statement},
                        {"planners", hypothesis.planners},   {"against", hypothesis.against},
                        {"groups", hypothesis.groups},       {"quantity", hypothesis.quantity},
                        {"direction", hypothesis.direction}, {"alpha", alpha}};
    if (hypothesis.bound)
        json["bound"] = *hypothesis.bound;
    return json.dump();
}
}  // namespace narrows
