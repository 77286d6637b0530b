// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Recheck.h"

#include <cmath>
#include <map>
#include <stdexcept>

#include "validity/PlanarChecker.h"
#include "validity/Verifier.h"

namespace narrows
{
namespace
{
/// Samples motions of one arm; keeps the buffers.
class DenseSampler
{
public:
    explicit DenseSampler(const PlanarModel &model) : arm_(model.arm), checker_(makeAnalyticChecker(model)) {}

    /// Configurations looked at so far.
    std::int64_t states() const { return states_; }

    bool isFree(const std::vector<Eigen::VectorXd> &path, double step)
    {
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
        {
            const Eigen::VectorXd delta = path[i + 1] - path[i];
            const auto count = static_cast<std::int64_t>(std::ceil(longestWay(delta) / step)) + 1;
            for (std::int64_t k = 0; k <= count; ++k)
                if (!isFree(path[i] + static_cast<double>(k) / static_cast<double>(count) * delta))
                    return false;
        }
        return true;
    }

private:
    /// No point of the arm travels further than all joints' ways together.
    double longestWay(const Eigen::VectorXd &delta) const
    {
        double way = arm_.slide() ? std::abs(delta[0]) : 0.0;
        for (int link = 0; link < arm_.linkCount(); ++link)
            way += arm_.links()[static_cast<std::size_t>(link)].length * std::abs(delta[arm_.firstAngle() + link]);
        return way;
    }

    bool isFree(const Eigen::VectorXd &q)
    {
        ++states_;
        arm_.place(q, points_);
        return armClears(*checker_, arm_, points_);
    }

    const PlanarArm &arm_;
    std::unique_ptr<PlanarChecker> checker_;
    std::int64_t states_ = 0;
    std::vector<Eigen::Vector2d> points_;
};

/// What a second look at one path finds wrong with the verdict of the first; empty if nothing.
std::string refute(const PathRow &row, const Scenario &scenario, DenseSampler &sampler, double step)
{
    std::vector<Eigen::VectorXd> path;
    for (const Eigen::VectorXd &waypoint : row.path)
        path.push_back(scenario.model->arm.toAbsolute(waypoint, scenario.convention));
    const Verdict verdict = verify(*scenario.model, scenario.task, path);
    if (verdict.accepted != row.verified)
        return verdict.accepted ? "was refused, is accepted now" : "was accepted, is refused now: " + verdict.reason;
    if (row.verified && !sampler.isFree(path, step))
        return "was accepted, but collides";
    return "";
}
}  // namespace

RecheckResult recheck(const ResultStore &store, double step)
{
    if (!(step > 0.0))
        throw std::invalid_argument("step: must be > 0");
    std::map<std::string, Scenario> scenarios;
    RecheckResult result;
    store.eachPath(
        [&](const PathRow &row)
        {
            auto scenario = scenarios.find(row.instance);
            if (scenario == scenarios.end())
                scenario = scenarios.emplace(row.instance, parseScenario(row.scenarioText, row.scenarioName)).first;
            DenseSampler sampler(*scenario->second.model);
            const std::string refutation = refute(row, scenario->second, sampler, step);
            ++(row.verified ? result.accepted : result.refused);
            result.states += sampler.states();
            if (!refutation.empty())
                result.refutations.push_back(row.instance + ", " + row.label + ", run " + std::to_string(row.run) +
                                             ": " + refutation);
        });
    return result;
}
}  // namespace narrows
