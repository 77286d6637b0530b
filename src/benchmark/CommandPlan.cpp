// SPDX-License-Identifier: BSD-3-Clause
// narrows plan: one run.
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmark/Commands.h"
#include "benchmark/Drawing.h"
#include "benchmark/IsolatedRunner.h"
#include "benchmark/PathTiming.h"
#include "benchmark/SliceView.h"
#include "benchmark/Text.h"
#include "benchmark/TrajectoryFile.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
struct PlanOptions
{
    std::string scenario;
    RunSpec spec;
    std::vector<std::string> parameters;  ///< name=value, a later one wins
    bool noRecipe = false;
    std::string json;
    std::string svg;
    std::string slice;       ///< where to draw the slice
    std::string limits;      ///< of the joints; empty: no motion is asked for
    std::string trajectory;  ///< where to write the motion
    double rate = 1000.0;    ///< of its samples
};

RunSpec makeSpec(const PlanOptions &options)
{
    RunSpec spec = options.spec;
    spec.scenario = std::make_shared<const Scenario>(readScenario(options.scenario));
    spec.instance = spec.scenario->name + "_" + spec.problem.checker;
    spec.label = spec.planner;
    spec.recipe = !options.noRecipe;
    if (!options.limits.empty())
        spec.limits = limitsFromText(options.limits);
    else if (!options.trajectory.empty())
        throw std::invalid_argument("--trajectory needs --limits velocity,acceleration,jerk");
    for (const auto &[name, value] : assignments("--param", options.parameters))
        spec.parameters[name] = value;
    // Wrong names and values are the caller's mistakes: found here, before they become the outcome of a run.
    const Problem problem = makeProblem(*spec.scenario, spec.problem);
    if (whyUnsupported(spec.planner, problem.context).empty())
        makePlanner(spec.planner, problem.context, spec.parameters);
    return spec;
}

template <typename Value>
void printLine(const std::string &name, const std::optional<Value> &value, const std::string &unit = "",
               double scale = 1)
{
    if (value)
        std::cout << fmt::format("  {:<16}{:.6g}{}\n", name, static_cast<double>(*value) * scale,
                                 unit.empty() ? "" : " " + unit);
}

void printHuman(const RunSpec &spec, const Record &record)
{
    std::cout << fmt::format("{} on {}: {}{}\n", spec.planner, spec.scenario->name, toString(record.outcome),
                             record.reason.empty() ? "" : " (" + record.reason + ")");
    printLine("CPU time", record.cpuTime, "ms", 1e3);
    printLine("wall time", record.time, "ms", 1e3);
    printLine("length", record.length, "rad");
    printLine("clearance", record.clearance);
    printLine("waypoints", record.waypoints);
    printLine("state checks", record.stateChecks);
    printLine("motion checks", record.motionChecks);
    printLine("evaluations", record.evaluations);
    printLine("largest step", record.maxJointStep, "rad");
    printLine("largest bend", record.largestBend, "rad");
    printLine("moved joints", record.movedJoints);
    printLine("tip's way", record.tipLength);
    printLine("tip deviates", record.tipDeviation);
    printLine("closure", record.closure, "rad");
    printLine("simplified", record.simplifiedLength, "rad");
    printLine("duration", record.duration, "s");
    printLine("with stops", record.stopDuration, "s");
    printLine("peak velocity", record.peakVelocity, "rad/s");
    printLine("acceleration", record.peakAcceleration, "rad/s^2");
    printLine("jerk", record.peakJerk, "rad/s^3");
    for (const auto &[name, value] : record.measures)
        printLine<double>(name, value);
    if (record.prescribed)
        std::cout << "  used the recipe that the scenario prescribes (--no-recipe goes without)\n";
    if (!record.output.empty())
        std::cerr << record.output << (record.output.back() == '\n' ? "" : "\n");
}

/// The slice of the curve that the run followed, drawn.
SliceView showSlice(const PlanOptions &options, const RunSpec &spec, const Record &record)
{
    if (record.recipe.empty())
        throw std::invalid_argument("--slice: no curve was followed" + std::string(record.outcome == Outcome::Solved
                                                                                       ? "; the straight motion is free"
                                                                                       : ""));
    SliceView view = viewSlice(*spec.scenario, spec.problem, record.recipe);
    drawSlice(view, options.slice);
    return view;
}

std::string withSlice(const std::string &json, const SliceView &view)
{
    nlohmann::ordered_json record = nlohmann::ordered_json::parse(json);
    record["slice"] = {
        {"joins", view.joins}, {"bottleneck", view.bottleneck}, {"spacing", view.spacing}, {"failure", nullptr}};
    if (!view.failure().empty())
        record["slice"]["failure"] = view.failure();
    return record.dump();
}

void printSlice(const SliceView &view)
{
    if (view.joins)
        std::cout << fmt::format("  {:<16}joins start and goal, bottleneck {:.6g}\n", "slice", view.bottleneck);
    else
        std::cout << fmt::format("  {:<16}no way from start to goal through gaps wider than {:.2g} rad\n", "slice",
                                 view.spacing);
    if (!view.failure().empty())
        std::cout << fmt::format("  {:<16}the {}'s\n", "failure", view.failure());
}

/// The motion along the path that was found. False if there is none to write: no file then.
bool saveTrajectory(const PlanOptions &options, const RunSpec &spec, const Record &record)
{
    const OrFailure<PathTiming> timing =
        record.outcome == Outcome::Solved ? timePath(spec, record, *spec.limits) : TrajectoryFailure::NoMotion;
    if (!timing)
    {
        std::cerr << fmt::format("{} was not written: {}\n", options.trajectory,
                                 record.outcome == Outcome::Solved ? toText(timing.failure) : "there is no path");
        return false;
    }
    writeTrajectory(*timing->motion, options.rate, options.trajectory);
    std::cerr << fmt::format("{}: {} over {:.6g} s\n", options.trajectory, timing->method, timing->motion->duration());
    return true;
}

int plan(const PlanOptions &options)
{
    const RunSpec spec = makeSpec(options);
    Record record;
    runAll({spec}, 1, [&](std::size_t, const Record &result) { record = result; });
    std::optional<SliceView> slice;
    std::exception_ptr noSlice;  // rethrown when all that was computed has been written
    try
    {
        if (!options.slice.empty())
            slice = showSlice(options, spec, record);
    }
    catch (...)
    {
        noSlice = std::current_exception();
    }
    const std::string json = slice ? withSlice(toJson(spec, record), *slice) : toJson(spec, record);
    if (options.json == "-")
        std::cout << json << std::endl;
    else
    {
        printHuman(spec, record);
        if (slice)
            printSlice(*slice);
    }
    if (!options.json.empty() && options.json != "-")
        writeFile(options.json, json + "\n");
    if (!options.svg.empty())
        drawRecord(*spec.scenario, options.scenario, json, options.svg);
    const bool saved = options.trajectory.empty() || saveTrajectory(options, spec, record);
    if (noSlice)
        std::rethrow_exception(noSlice);
    return saved && record.outcome == Outcome::Solved ? ExitDone : ExitNot;
}

void addProblemOptions(CLI::App &command, PlanOptions &options)
{
    RunSpec &spec = options.spec;
    command.add_option("--checker", spec.problem.checker, "who says a state is free: analytic or fcl")
        ->capture_default_str();
    command.add_option("--motion", spec.problem.motion, "how motions are checked: continuous, or a resolution")
        ->capture_default_str();
    command.add_option("--space", spec.problem.space, "scenario, absolute, relative, absolute_line or relative_line")
        ->capture_default_str();
    command.add_flag("--no-recipe", options.noRecipe, "do not use what the scenario prescribes for the planner");
}

void addRunOptions(CLI::App &command, PlanOptions &options)
{
    RunSpec &spec = options.spec;
    command.add_option("--seed", spec.seed, "of the random numbers")
        ->check(CLI::Range(1U, std::numeric_limits<std::uint32_t>::max()))
        ->capture_default_str();
    command.add_option("--time", spec.timeLimit, "limit for solve(), seconds")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command.add_option("--param", options.parameters, "name=value, may be repeated; see `narrows show planner`")
        ->allow_extra_args(false);
    command.add_flag("--simplify", spec.simplify, "also time OMPL's path simplification");
}
}  // namespace

void addPlanCommand(CLI::App &program, int &exitCode)
{
    const auto options = std::make_shared<PlanOptions>();
    options->spec.warmUp = 0.02;  // as in experiments, so that times can be compared
    CLI::App *command = program.add_subcommand("plan", "Let one planner solve a scenario once");
    command->add_option("scenario", options->scenario, "scenario file")->required();
    command->add_option("--planner", options->spec.planner, "see `narrows list planners`")->required();
    addRunOptions(*command, *options);
    addProblemOptions(*command, *options);
    command->add_option("--json", options->json, "write the record as JSON; - is stdout, and nothing else goes there");
    command->add_option("--svg", options->svg, "draw the motion");
    command->add_option("--slice", options->slice,
                        "draw the slice of joint space that hppm followed its last curve in, or write it as .json");
    command->add_option("--limits", options->limits,
                        "velocity,acceleration,jerk of every joint (rad, s): say how fast the path can be followed");
    command->add_option("--trajectory", options->trajectory,
                        "write that motion as CSV: time, then each joint's "
                        "position, velocity, acceleration and jerk");
    command->add_option("--rate", options->rate, "samples per second of --trajectory")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->callback([options, &exitCode] { exitCode = plan(*options); });
}
}  // namespace narrows
