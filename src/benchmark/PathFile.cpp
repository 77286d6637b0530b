// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/PathFile.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "scenario/InputText.h"

namespace narrows
{
namespace
{
using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string &file, const std::string &key, const std::string &reason)
{
    throw InputError({{file, 0, key, reason}});
}

Json parseJson(const std::string &text, const std::string &file)
{
    try
    {
        return Json::parse(text);
    }
    catch (const Json::exception &error)
    {
        refuse(file, "", std::string("is not JSON: ") + error.what());
    }
}

/// The array of waypoints, wherever it is.
Json findRows(const std::string &file, const Json &json)
{
    const Json &holder = json.is_object() && json.contains("path") ? json["path"] : json;
    if (holder.is_null())
        refuse(file, "path", "is null: the record holds no path");
    const Json &rows = holder.is_object() && holder.contains("angles") ? holder["angles"] : holder;
    if (!rows.is_array())
        refuse(file, "angles", "there is no array of waypoints");
    return rows;
}

double number(const std::string &file, const std::string &key, const Json &json)
{
    if (json == "nan")  // records write what JSON cannot say as text; the verifier refuses it
        return std::nan("");
    if (json == "inf" || json == "-inf")
        return json == "inf" ? HUGE_VAL : -HUGE_VAL;
    if (!json.is_number())
        refuse(file, key, "is no number");
    return json.get<double>();
}
}  // namespace

std::vector<Eigen::VectorXd> readPathFile(const std::string &file, const Scenario &scenario)
{
    return parsePath(readInputText(file), file, scenario);
}

std::vector<Eigen::VectorXd> parsePath(const std::string &text, const std::string &file, const Scenario &scenario)
{
    const Json rows = findRows(file, parseJson(text, file));
    const auto dimension = static_cast<std::size_t>(dimensionOf(scenario.world));
    std::vector<Eigen::VectorXd> path;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        const std::string key = "angles[" + std::to_string(i) + "]";
        if (!rows[i].is_array() || rows[i].size() != dimension)
            refuse(file, key, "is not an array of " + std::to_string(dimension) + " numbers");
        Eigen::VectorXd row(static_cast<Eigen::Index>(dimension));
        for (std::size_t j = 0; j < dimension; ++j)
            row[static_cast<Eigen::Index>(j)] = number(file, key + "[" + std::to_string(j) + "]", rows[i][j]);
        path.push_back(fromFile(scenario.world, row));
    }
    return path;
}
}  // namespace narrows
