// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Record.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

namespace narrows
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<Outcome, const char *>, 11> outcomeNames{{
    {Outcome::Solved, "solved"},
    {Outcome::Unverified, "unverified"},
    {Outcome::Approximate, "approximate"},
    {Outcome::NoSolution, "no_solution"},
    {Outcome::Timeout, "timeout"},
    {Outcome::Memory, "memory"},
    {Outcome::Crash, "crash"},
    {Outcome::InvalidStart, "invalid_start"},
    {Outcome::InvalidGoal, "invalid_goal"},
    {Outcome::Unsupported, "unsupported"},
    {Outcome::InternalError, "internal_error"},
}};

/// JSON has no infinity and no NaN: they travel as the texts "inf", "-inf" and "nan", never as null (not measured).
Json encode(double value)
{
    if (std::isfinite(value))
        return value;
    if (std::isnan(value))
        return "nan";
    return value > 0.0 ? "inf" : "-inf";
}

Json encode(bool value)
{
    return value;
}

Json encode(int value)
{
    return value;
}

Json encode(std::int64_t value)
{
    return value;
}

void decode(const Json &json, double &value)
{
    if (json.is_number())
        value = json.get<double>();
    else if (json == "inf")
        value = std::numeric_limits<double>::infinity();
    else if (json == "-inf")
        value = -std::numeric_limits<double>::infinity();
    else if (json == "nan")
        value = std::numeric_limits<double>::quiet_NaN();
    else
        throw std::invalid_argument("not a number: " + json.dump());
}

void decode(const Json &json, bool &value)
{
    value = json.get<bool>();
}

Json encode(const std::string &value)
{
    return value;
}

void decode(const Json &json, std::string &value)
{
    value = json.get<std::string>();
}

template <typename Integer>
void decode(const Json &json, Integer &value)
{
    if (!json.is_number_integer())
        throw std::invalid_argument("not a whole number: " + json.dump());
    value = json.get<Integer>();
}

/// The optional fields and their keys, in the order they are written; one list for both directions.
template <typename AnyRecord, typename Visit>
void visitOptionals(AnyRecord &record, const Visit &visit)
{
    visit("verified", record.verified);
    visit("time_s", record.time);
    visit("cpu_s", record.cpuTime);
    visit("length", record.length);
    visit("clearance", record.clearance);
    visit("smoothness", record.smoothness);
    visit("waypoints", record.waypoints);
    visit("state_checks", record.stateChecks);
    visit("motion_checks", record.motionChecks);
    visit("evaluations", record.evaluations);
    visit("peak_memory_kb", record.peakMemoryKb);
    visit("cpus", record.cpus);
    visit("shares_core", record.sharesCore);
    visit("status", record.status);
    visit("graph_states", record.graphStates);
    visit("graph_motions", record.graphMotions);
    visit("solution_difference", record.solutionDifference);
    visit("max_joint_step", record.maxJointStep);
    visit("largest_bend", record.largestBend);
    visit("moved_joints", record.movedJoints);
    visit("tip_length", record.tipLength);
    visit("tip_deviation", record.tipDeviation);
    visit("closure", record.closure);
    visit("simplification_time_s", record.simplificationTime);
    visit("simplified_length", record.simplifiedLength);
    visit("duration", record.duration);
    visit("stop_duration", record.stopDuration);
    visit("peak_velocity", record.peakVelocity);
    visit("peak_acceleration", record.peakAcceleration);
    visit("peak_jerk", record.peakJerk);
    visit("simplified_verified", record.simplifiedVerified);
}

Json encodePath(const std::vector<Eigen::VectorXd> &path)
{
    if (path.empty())
        return nullptr;
    Json rows = Json::array();
    for (const Eigen::VectorXd &waypoint : path)
    {
        Json row = Json::array();
        for (const double value : waypoint)
            row.push_back(encode(value));
        rows.push_back(std::move(row));
    }
    return Json{{"angles", std::move(rows)}};
}

std::vector<Eigen::VectorXd> decodePath(const Json &json)
{
    std::vector<Eigen::VectorXd> path;
    if (json.is_null())
        return path;
    for (const Json &row : json.at("angles"))
    {
        Eigen::VectorXd waypoint(static_cast<Eigen::Index>(row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)
            decode(row.at(i), waypoint[static_cast<Eigen::Index>(i)]);
        path.push_back(std::move(waypoint));
    }
    return path;
}

Record decodeRecord(const Json &json)
{
    Record record;
    record.outcome = outcomeFromString(json.at("outcome").get<std::string>());
    record.reason = json.at("reason").get<std::string>();
    visitOptionals(record,
                   [&json](const char *key, auto &field)
                   {
                       const Json &value = json.at(key);
                       if (!value.is_null())
                           decode(value, field.emplace());
                   });
    record.prescribed = json.at("prescribed").get<bool>();
    record.usesModel = json.at("uses_model").get<bool>();
    for (const auto &[name, value] : json.at("parameters").items())
        record.parameters[name] = value.template get<std::string>();
    record.recipe = json.at("recipe").get<std::map<std::string, std::string>>();
    for (const auto &[name, value] : json.at("measures").items())
        decode(value, record.measures[name]);
    record.output = json.at("output").get<std::string>();
    record.path = decodePath(json.at("path"));
    record.vias = decodePath(json.at("vias"));
    return record;
}
}  // namespace

std::string toString(Outcome outcome)
{
    for (const auto &[value, name] : outcomeNames)
        if (value == outcome)
            return name;
    throw std::invalid_argument("not an outcome: " + std::to_string(static_cast<int>(outcome)));
}

Outcome outcomeFromString(const std::string &text)
{
    for (const auto &[value, name] : outcomeNames)
        if (text == name)
            return value;
    throw std::invalid_argument("not an outcome: " + text);
}

std::string toJson(const RunSpec &spec, const Record &record)
{
    Json json;
    json["scenario"] = spec.scenario->name;
    json["planner"] = spec.planner;
    json["parameters"] = record.parameters;
    json["seed"] = spec.seed;
    json["outcome"] = toString(record.outcome);
    json["reason"] = record.reason;
    visitOptionals(record,
                   [&json](const char *key, const auto &field) { json[key] = field ? encode(*field) : Json(nullptr); });
    json["instance"] = spec.instance;
    json["label"] = spec.label;
    json["run"] = spec.run;
    json["checker"] = spec.problem.checker;
    json["motion"] = spec.problem.motion;
    json["space"] = spec.problem.space;
    json["prescribed"] = record.prescribed;
    json["uses_model"] = record.usesModel;
    json["recipe"] = record.recipe;
    json["measures"] = Json::object();
    for (const auto &[name, value] : record.measures)
        json["measures"][name] = encode(value);
    json["output"] = record.output;
    json["path"] = encodePath(record.path);
    json["vias"] = encodePath(record.vias);
    // What planners print or throw need not be UTF-8.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Record recordFromJson(const std::string &text)
{
    try
    {
        return decodeRecord(Json::parse(text));
    }
    catch (const Json::exception &error)
    {
        throw std::invalid_argument(error.what());
    }
}
}  // namespace narrows
