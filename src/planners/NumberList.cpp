// SPDX-License-Identifier: BSD-3-Clause
#include "planners/NumberList.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <boost/algorithm/string.hpp>

namespace narrows
{
namespace
{
double parseNumber(const std::string &text)
{
    const std::string trimmed = boost::algorithm::trim_copy(text);
    const char *begin = trimmed.c_str();
    const char *end = begin + trimmed.size();
    double value = 0.0;
    const auto result = std::from_chars(begin + (trimmed.rfind('+', 0) == 0 ? 1 : 0), end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
        throw std::invalid_argument("\"" + trimmed + "\" is not a finite number");
    return value;
}

std::vector<std::string> split(const std::string &text, const char *separator)
{
    std::vector<std::string> parts;
    boost::algorithm::split(parts, text, boost::is_any_of(separator));
    return parts;
}
}  // namespace

Eigen::VectorXd parseVector(const std::string &text)
{
    if (boost::algorithm::trim_copy(text).empty())
        return {};
    const std::vector<std::string> parts = split(text, ",");
    Eigen::VectorXd values(static_cast<Eigen::Index>(parts.size()));
    for (std::size_t i = 0; i < parts.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = parseNumber(parts[i]);
    return values;
}

Eigen::MatrixXd parseMatrix(const std::string &text)
{
    if (boost::algorithm::trim_copy(text).empty())
        return {};
    const std::vector<std::string> lines = split(text, ";");
    Eigen::MatrixXd matrix;
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        const Eigen::VectorXd row = parseVector(lines[i]);
        if (i == 0)
            matrix.resize(static_cast<Eigen::Index>(lines.size()), row.size());
        if (row.size() != matrix.cols() || row.size() == 0)
            throw std::invalid_argument(
                fmt::format("row {} has {} numbers, the first has {}", i + 1, row.size(), matrix.cols()));
        matrix.row(static_cast<Eigen::Index>(i)) = row.transpose();
    }
    return matrix;
}

std::string toText(const Eigen::MatrixXd &matrix)
{
    std::string text;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        for (Eigen::Index j = 0; j < matrix.cols(); ++j)
            text += fmt::format("{}{}", j > 0 ? ", " : i > 0 ? "; " : "", matrix(i, j));
    return text;
}
}  // namespace narrows
