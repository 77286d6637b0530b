// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Recheck.h"

#include <cmath>
#include <map>
#include <stdexcept>

namespace narrows
{
namespace
{
/// Samples motions of one robot.
class DenseSampler
{
public:
    explicit DenseSampler(const World &world) : world_(world), checker_(makeArmChecker("analytic", world)) {}

    /// Configurations looked at so far.
    std::int64_t states() const { return states_; }

    bool isFree(const std::vector<Eigen::VectorXd> &path, double step)
    {
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
        {
            const Eigen::VectorXd delta = path[i + 1] - path[i];
            const auto count = static_cast<std::int64_t>(std::ceil(longestWay(world_, delta) / step)) + 1;
            for (std::int64_t k = 0; k <= count; ++k, ++states_)
                if (!checker_->isFree(path[i] + static_cast<double>(k) / static_cast<double>(count) * delta))
                    return false;
        }
        return true;
    }

private:
    const World &world_;
    std::unique_ptr<ArmChecker> checker_;
    std::int64_t states_ = 0;
};

/// What a second look at one path finds wrong with the verdict of the first; empty if nothing.
std::string refute(const PathRow &row, const Scenario &scenario, DenseSampler &sampler, double step)
{
    std::vector<Eigen::VectorXd> path;
    for (const Eigen::VectorXd &waypoint : row.path)
        path.push_back(fromFile(scenario.world, waypoint));
    const Verdict verdict = verify(scenario.world, path);
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
            DenseSampler sampler(scenario->second.world);
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
