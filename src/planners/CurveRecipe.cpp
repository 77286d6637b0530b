// SPDX-License-Identifier: BSD-3-Clause
#include "planners/CurveRecipe.h"

#include "planners/NumberList.h"

namespace narrows
{
namespace
{
std::string number(double value)
{
    return toText(Eigen::MatrixXd::Constant(1, 1, value));
}

std::string list(const std::vector<int> &values)
{
    Eigen::RowVectorXd row(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        row[static_cast<Eigen::Index>(i)] = values[i];
    return toText(row);
}
}  // namespace

std::map<std::string, std::string> CurveRecipe::parameters() const
{
    std::map<std::string, std::string> result{{"search", "paper"},
                                              {"form", "plane"},
                                              {"poles", continuous ? "continuous" : "points"},
                                              {"repulsion", toText(strengths)},
                                              {"direction", toText(directions.transpose())},
                                              {"strength", toText(couplings.transpose())},
                                              {"traced_from", fromGoal ? "goal" : "start"},
                                              {"orientation", window.decreasing ? "decreasing" : "increasing"},
                                              {"lambda_min", number(window.lambdaMin)},
                                              {"lambda_max", number(window.lambdaMax)},
                                              {"max_deviation", number(window.maxDeviation)}};
    if (!continuous)
        result["points_per_link"] = std::to_string(pointsPerLink);
    if (turns.size() > 0)
        result["turns"] = toText(turns.transpose().cast<double>());
    if (!schedule.empty())
    {
        result["held"] = list(schedule.held);
        result["held_share"] = number(schedule.share);
    }
    return result;
}
}  // namespace narrows
