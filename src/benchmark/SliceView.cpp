// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/SliceView.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include <ompl/base/goals/GoalState.h>
#include <nlohmann/json.hpp>

#include "benchmark/Drawing.h"
#include "benchmark/Text.h"
#include "kernel/SliceOracle.h"
#include "planners/HPPM.h"

namespace narrows
{
namespace
{
using Json = nlohmann::json;

constexpr int pictureColumns = 240;  // along lambda
constexpr int pictureRows = 200;     // along s

/// Everything of one view, made for it.
struct Look
{
    Problem problem;
    std::shared_ptr<const RepulsionModel> model;
    std::shared_ptr<HPPM> planner;
};

Look lookAt(const Scenario &scenario, const ProblemOptions &options, const std::map<std::string, std::string> &recipe)
{
    Look look;
    look.problem = makeProblem(scenario, options);
    look.model = look.problem.context.repulsion();
    look.planner = std::dynamic_pointer_cast<HPPM>(makePlanner("hppm", look.problem.context, recipe));
    if (!look.problem.pdef->getGoal()->hasType(ob::GOAL_STATE))
        throw std::invalid_argument("a slice is drawn between two configurations, but the scenario's goal is none");
    return look;
}

SliceHomotopy sliceOf(const Look &look)
{
    const ob::State *goal = look.problem.pdef->getGoal()->as<ob::GoalState>()->getState();
    return look.planner->slice(look.problem.pdef->getStartState(0), goal);
}

/// (lambda, s) of a point of the slice.
Json place(const SliceHomotopy &slice, const Eigen::VectorXd &z)
{
    return {z[1] / slice.lambdaScale(), z[0]};
}

/// What the curve needs, and a margin.
SliceWindow windowOf(const SliceHomotopy &slice, const Trace &trace)
{
    SliceWindow window;
    double deviation = 1.0;
    for (const TraceStep &step : trace.log)
    {
        window.lambdaMin = std::min(window.lambdaMin, step.z[1] / slice.lambdaScale() - 0.1);
        window.lambdaMax = std::max(window.lambdaMax, step.z[1] / slice.lambdaScale() + 0.1);
        deviation = std::max(deviation, std::abs(step.z[0]));
    }
    // A rejected step may lead anywhere.
    window.lambdaMin = std::max(window.lambdaMin, -2.0);
    window.lambdaMax = std::min(window.lambdaMax, 3.0);
    window.deviation = std::min(1.3 * deviation, 12.0);
    return window;
}

/// Where the obstacle's function, at strength 1, is not positive: rows of '#' and '.', from the lowest s up.
Json shadow(const SliceHomotopy &slice, const Repulsion &obstacle, const SliceWindow &window)
{
    Json rows = Json::array();
    Repulsion::Sample sample;
    Eigen::VectorXd q;
    for (int i = 0; i < pictureRows; ++i)
    {
        std::string row;
        const double s = window.deviation * (2.0 * i / (pictureRows - 1) - 1.0);
        for (int j = 0; j < pictureColumns; ++j)
        {
            const double lambda = window.lambdaMin + (window.lambdaMax - window.lambdaMin) * j / (pictureColumns - 1);
            slice.configuration(Eigen::Vector2d(s, lambda * slice.lambdaScale()), q);
            obstacle.evaluate(q, sample);
            const bool meets =
                std::any_of(sample.poles.begin(), sample.poles.end(), [](double c) { return !(c > 0.0); });
            row += meets ? '#' : '.';
        }
        rows.push_back(row);
    }
    return rows;
}

Json shadows(const Look &look, const SliceHomotopy &slice, const SliceWindow &window)
{
    Json all = Json::array();
    const std::vector<std::string> &groups = look.model->groups();
    for (std::size_t i = 0; i < groups.size(); ++i)
    {
        std::vector<double> strengths(groups.size(), 0.0);
        strengths[i] = 1.0;
        all.push_back({{"name", groups[i]}, {"rows", shadow(slice, *look.model->continuous(strengths), window)}});
    }
    return all;
}

/// What the problem's own checker says of configurations in the slice.
class SliceChecks
{
public:
    explicit SliceChecks(const Look &look)
      : space_(*look.problem.space), si_(look.problem.si), from_(look.problem.si), to_(look.problem.si)
    {
    }

    /// -infinity beyond limits.
    double clearance(const Eigen::VectorXd &q)
    {
        space_.fromConfiguration(q, from_.get());
        return si_->satisfiesBounds(from_.get()) ? si_->getStateValidityChecker()->clearance(from_.get())
                                                 : -std::numeric_limits<double>::infinity();
    }

    bool isFree(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
    {
        space_.fromConfiguration(a, from_.get());
        space_.fromConfiguration(b, to_.get());
        return si_->checkMotion(from_.get(), to_.get());
    }

private:
    const ArmStateSpace &space_;
    ob::SpaceInformationPtr si_;
    ob::ScopedState<> from_, to_;
};

/// A curve that got through is a way, however narrow: grids overlook what is narrower than their spacing.
void count(const Trace &trace, SliceChecks &checks, SliceAnswer &answer)
{
    if (answer.joins || trace.status != TraceStatus::ReachedGoal)
        return;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < trace.configurations.size(); ++i)
    {
        if (i > 0 && !checks.isFree(trace.configurations[i - 1], trace.configurations[i]))
            return;
        least = std::min(least, checks.clearance(trace.configurations[i]));
    }
    answer.joins = true;
    answer.bottleneck = least;
}

Json rowOf(const World &world, const Eigen::VectorXd &q)
{
    const Eigen::VectorXd row = toFile(world, q);
    return std::vector<double>(row.begin(), row.end());
}

/// What turns a point (lambda, s) of the picture into a configuration, as the scenario's file counts joints: the
/// configurations at s = 0, evenly spread over the window's lambda, and what one radian of s adds to each joint.
/// (Every configuration of the slice is their sum: SliceHomotopy::configuration is linear in s.)
Json configurations(const World &world, const SliceHomotopy &slice, const SliceWindow &window)
{
    Json middle = Json::array();
    Eigen::VectorXd q, aside;
    for (int j = 0; j < pictureColumns; ++j)
    {
        const double lambda = window.lambdaMin + (window.lambdaMax - window.lambdaMin) * j / (pictureColumns - 1);
        slice.configuration(Eigen::Vector2d(0.0, lambda * slice.lambdaScale()), q);
        middle.push_back(rowOf(world, q));
    }
    slice.configuration(Eigen::Vector2d(0.0, 0.0), q);
    slice.configuration(Eigen::Vector2d(1.0, 0.0), aside);
    const Eigen::VectorXd direction = toFile(world, aside) - toFile(world, q);
    return {{"middle", middle}, {"direction", std::vector<double>(direction.begin(), direction.end())}};
}

SliceAnswer explore(const Look &look, const SliceHomotopy &slice, const SliceWindow &window, const Trace &trace)
{
    SliceChecks checks(look);
    SliceAnswer answer = exploreSlice(
        slice, [&](const Eigen::VectorXd &q) { return checks.clearance(q); },
        [&](const Eigen::VectorXd &a, const Eigen::VectorXd &b) { return checks.isFree(a, b); }, window);
    count(trace, checks, answer);
    return answer;
}
}  // namespace

SliceView viewSlice(const Scenario &scenario, const ProblemOptions &options,
                    const std::map<std::string, std::string> &recipe)
{
    const Look look = lookAt(scenario, options, recipe);
    const SliceHomotopy slice = sliceOf(look);
    TrackerOptions tracking = look.planner->trackerOptions();
    tracking.log = true;
    const Trace trace = track(slice, tracking);
    const SliceWindow window = windowOf(slice, trace);
    const SliceAnswer answer = explore(look, slice, window, trace);

    SliceView view;
    view.joins = answer.joins;
    view.bottleneck = answer.bottleneck;
    view.spacing = answer.spacing;
    view.status = toString(trace.status);
    Json json{{"scenario", scenario.name},
              {"status", view.status},
              {"joins", view.joins},
              {"bottleneck", view.bottleneck},
              {"failure", view.failure()},
              {"spacing", view.spacing},
              {"lambda", {window.lambdaMin, window.lambdaMax}},
              {"deviation", window.deviation},
              {"traced_from", look.planner->getTracedFrom()}};
    json["obstacles"] = shadows(look, slice, window);
    json.update(configurations(scenario.world, slice, window));
    json["curve"] = Json::array({place(slice, slice.startPoint())});
    json["rejected"] = Json::array();
    for (const TraceStep &step : trace.log)
        json[step.accepted ? "curve" : "rejected"].push_back(place(slice, step.z));
    json["path"] = Json::array();
    for (const Eigen::VectorXd &z : answer.path)
        json["path"].push_back(place(slice, z));
    view.json = json.dump();
    return view;
}

void drawSlice(const SliceView &view, const std::string &outputFile)
{
    if (std::filesystem::path(outputFile).extension() == ".json")
        writeFile(outputFile, view.json + "\n");
    else
        drawData("draw_slice.py", view.json, outputFile);
}
}  // namespace narrows
