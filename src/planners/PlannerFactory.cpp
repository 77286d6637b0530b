// SPDX-License-Identifier: BSD-3-Clause
#include "planners/PlannerFactory.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <stdexcept>

#include "planners/HPPM.h"
#include "planners/IkPlanners.h"
#include "planners/LegByLeg.h"
#include "planners/NearNames.h"
#include "planners/OmplPlanners.h"
#include "planners/Threader.h"
#include "planners/TightManeuvering.h"
#include "planners/VDSM.h"
#include "planners/ViaPointHomotopy.h"

namespace narrows
{
namespace
{
std::string join(const std::vector<std::string> &words)
{
    std::string text;
    for (const std::string &word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

bool byName(const PlannerEntry &a, const PlannerEntry &b)
{
    return a.name < b.name;
}

PlannerEntry hppm()
{
    PlannerEntry result;
    result.name = "hppm";
    result.summary = "follows curves of homotopies whose poles are the obstacles (HPPM-PRA)";
    result.usesModel = true;
    result.make = [](const PlannerContext &context)
    {
        return std::make_shared<HPPM>(context.si, context.repulsion());
    };
    return result;
}

PlannerEntry threader()
{
    PlannerEntry result;
    result.name = "threader";
    result.summary = "trees that thread gaps along their middle, in slices and in all of joint space (ours)";
    result.usesModel = true;
    result.make = [](const PlannerContext &context)
    {
        return std::make_shared<Threader>(context.si, context.planar, context.spatial, context.repulsion);
    };
    return result;
}

PlannerEntry vdsm()
{
    PlannerEntry result;
    result.name = "vdsm";
    result.summary = "scales the tip's way to those of the joints, round obstacles along the slide (VDSM)";
    result.usesModel = true;
    result.followsTipPath = true;
    result.unsupported = [](const PlannerContext &context)
    {
        return VDSM::whyUnsupported(context.spatial.get());
    };
    result.make = [](const PlannerContext &context)
    {
        return std::make_shared<VDSM>(context.si, context.spatial);
    };
    return result;
}

PlannerEntry viaPoint()
{
    PlannerEntry result;
    result.name = "viapoint";
    result.summary = "joins start and goal by via points, then by a smooth motion in time that is certified free";
    result.usesModel = true;
    result.make = [](const PlannerContext &context)
    {
        const bool selfCollision =
            context.planar ? context.planar->selfCollision : !context.spatial || context.spatial->selfCollision;
        return std::make_shared<ViaPointHomotopy>(context.si, selfCollision);
    };
    return result;
}

PlannerEntry tight()
{
    PlannerEntry result;
    result.name = "tight";
    result.summary =
        "feeds a chain along one path for all its joints, bent until every link is free (tight maneuvering)";
    result.usesModel = true;
    result.unsupported = [](const PlannerContext &context)
    {
        return TightManeuvering::whyUnsupported(context.planar.get(), context.spatial.get());
    };
    result.make = [](const PlannerContext &context)
    {
        return std::make_shared<TightManeuvering>(context.si, context.planar, context.spatial);
    };
    return result;
}

std::vector<PlannerEntry> initialTable()
{
    std::vector<PlannerEntry> all = omplPlanners();
    all.push_back(hppm());
    all.push_back(tight());
    all.push_back(threader());
    all.push_back(vdsm());
    all.push_back(viaPoint());
    for (PlannerEntry &entry : ikPlanners())
        all.push_back(std::move(entry));
    std::sort(all.begin(), all.end(), byName);
    return all;
}

std::vector<PlannerEntry> &table()
{
    static std::vector<PlannerEntry> entries = initialTable();
    return entries;
}

const PlannerEntry *find(const std::string &name)
{
    const auto found =
        std::find_if(table().begin(), table().end(), [&](const PlannerEntry &e) { return e.name == name; });
    return found == table().end() ? nullptr : &*found;
}

template <typename T>
bool isA(const ob::GenericParam &parameter)
{
    return dynamic_cast<const ob::SpecificParam<T> *>(&parameter) != nullptr;
}

template <typename T>
bool reads(const std::string &text)
{
    T value{};
    const char *end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end;
}

bool readsFinite(const std::string &text)
{
    double value = 0.0;
    const char *end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end && std::isfinite(value);
}

bool readsBool(const std::string &text)
{
    const auto words = {"0", "1", "false", "true"};
    return std::find(words.begin(), words.end(), text) != words.end();
}

/// What a parameter wants, if the text is not of that kind. OMPL itself reads "no" as true, "3x" as 3 and -1 as
/// 4294967295.
std::string kindMissed(const ob::GenericParam &parameter, const std::string &text)
{
    if (isA<bool>(parameter))
        return readsBool(text) ? "" : "true or false";
    if (isA<float>(parameter) || isA<double>(parameter) || isA<long double>(parameter))
        return readsFinite(text) ? "" : "a number";
    if (isA<unsigned int>(parameter))
        return reads<unsigned int>(text) ? "" : "a whole number, not negative";
    if (isA<unsigned long>(parameter) || isA<unsigned long long>(parameter))
        return reads<unsigned long long>(text) ? "" : "a whole number, not negative";
    if (isA<int>(parameter))
        return reads<int>(text) ? "" : "a whole number";
    if (isA<long>(parameter) || isA<long long>(parameter))
        return reads<long long>(text) ? "" : "a whole number";
    return "";
}

/// Sets a parameter; returns why that failed, or nothing.
std::string setParameter(ob::ParamSet &parameters, const std::string &name, const std::string &text)
{
    const std::string wanted = kindMissed(*parameters.getParam(name), text);
    if (!wanted.empty())
        return "it takes " + wanted;
    try
    {
        return parameters.setParam(name, text) ? "" : "the planner refuses it";
    }
    catch (const std::exception &error)
    {
        return error.what();
    }
}

void setParameters(ob::Planner &planner, const std::string &name, const std::map<std::string, std::string> &values)
{
    for (const auto &[key, text] : values)
    {
        if (!planner.params().hasParam(key))
        {
            std::vector<std::string> known;
            planner.params().getParamNames(known);
            throw ParameterError(name + " has no parameter \"" + key + "\"; it has " +
                                 (known.empty() ? "none" : join(known)));
        }
        const std::string reason = setParameter(planner.params(), key, text);
        if (reason.empty())
            continue;
        const std::string &range = planner.params().getParam(key)->getRangeSuggestion();
        throw ParameterError(name + "." + key + " cannot be \"" + text + "\": " + reason +
                             (range.empty() ? "" : " (range " + range + ")"));
    }
}

/// The same context, whose poles are made when they are first asked for and then kept.
PlannerContext keepingPoles(PlannerContext context)
{
    if (context.repulsion)
        context.repulsion = [make = context.repulsion, model = std::shared_ptr<const RepulsionModel>()]() mutable
        {
            if (!model)
                model = make();
            return model;
        };
    return context;
}
}  // namespace

const std::vector<PlannerEntry> &planners()
{
    return table();
}

void registerPlanner(PlannerEntry entry)
{
    if (find(entry.name) != nullptr)
        throw std::invalid_argument("there is a planner " + entry.name + " already");
    table().insert(std::upper_bound(table().begin(), table().end(), entry, byName), std::move(entry));
}

const PlannerEntry &findPlanner(const std::string &name)
{
    if (const PlannerEntry *entry = find(name))
        return *entry;
    std::vector<std::string> names;
    for (const PlannerEntry &entry : table())
        names.push_back(entry.name);
    const std::vector<std::string> near = nearNames(name, names);
    throw std::invalid_argument("there is no planner \"" + name + "\"; " +
                                (near.empty() ? "there are " + join(names) : "did you mean " + join(near) + "?"));
}

std::string whyUnsupported(const std::string &name, const PlannerContext &context)
{
    const PlannerEntry &entry = findPlanner(name);
    return entry.unsupported ? entry.unsupported(context) : std::string();
}

ob::PlannerPtr makePlanner(const std::string &name, const PlannerContext &context,
                           const std::map<std::string, std::string> &parameters)
{
    const PlannerEntry &entry = findPlanner(name);
    if (context.si == nullptr)
        throw std::invalid_argument("a planner needs a space");
    if (entry.usesModel && !context.repulsion)
        throw std::invalid_argument(name + " needs to know the robot and the obstacles");
    if (const std::string why = whyUnsupported(name, context); !why.empty())
        throw std::invalid_argument(name + " is not for this problem: " + why);
    const auto make = [make = entry.make, context = keepingPoles(context), name, parameters]
    {
        ob::PlannerPtr planner = make(context);
        setParameters(*planner, name, parameters);
        return planner;
    };
    if (context.tipPath && !entry.followsTipPath)
        return std::make_shared<LegByLeg>(context.si, make);
    return make();
}
}  // namespace narrows
