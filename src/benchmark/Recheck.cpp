// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Recheck.h"

#include <algorithm>
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
            const auto count = static_cast<Eigen::Index>(std::ceil(longestWay(world_, delta) / step)) + 1;
            for (Eigen::Index first = 0; first <= count; first += batchSize)
                if (!areFree(path[i], delta / static_cast<double>(count), first,
                             std::min(count, first + batchSize - 1)))
                    return false;
        }
        return true;
    }

private:
    static constexpr Eigen::Index batchSize = 256;

    /// start + k step, for k = first ... last.
    bool areFree(const Eigen::VectorXd &start, const Eigen::VectorXd &step, Eigen::Index first, Eigen::Index last)
    {
        const Eigen::Index count = last - first + 1;
        const Eigen::VectorXd steps =
            Eigen::VectorXd::LinSpaced(count, static_cast<double>(first), static_cast<double>(last));
        batch_.noalias() = steps * step.transpose();
        batch_.rowwise() += start.transpose();
        checker_->areFree(batch_, free_);
        const auto touching = std::find(free_.begin(), free_.end(), 0);
        states_ += touching - free_.begin();
        return touching == free_.end();
    }

    const World &world_;
    std::unique_ptr<ArmChecker> checker_;
    std::int64_t states_ = 0;
    Eigen::MatrixXd batch_;
    std::vector<char> free_;
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
