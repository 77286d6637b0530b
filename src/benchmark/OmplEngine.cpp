// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/OmplEngine.h"

#include <exception>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>
#include <ompl/config.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include "benchmark/Judging.h"
#include "benchmark/MeasuredPlanner.h"
#include "benchmark/PathTiming.h"
#include "benchmark/PreparedRun.h"
#include "benchmark/QuietOmpl.h"
#include "planners/PlannerFactory.h"

namespace narrows
{
namespace
{
using OnRecord = std::function<void(std::size_t, const Record &)>;
using Properties = ompl::tools::Benchmark::RunProperties;

/// The runs of one planner entry, as indices of specs.
using Entry = std::vector<std::size_t>;

/// The entries that one benchmark can do together.
using Group = std::vector<Entry>;

auto groupKey(const RunSpec &spec, std::size_t runs)
{
    return std::make_tuple(spec.instance, spec.problem.checker, spec.problem.motion, spec.problem.space, spec.timeLimit,
                           spec.memoryLimit, spec.simplify, runs);
}

auto entryKey(const RunSpec &spec)
{
    return std::make_tuple(spec.planner, spec.label, spec.parameters, spec.recipe, groupKey(spec, 0));
}

std::vector<Group> grouped(const std::vector<RunSpec> &specs)
{
    std::map<decltype(entryKey(specs.front())), Entry> entries;
    for (std::size_t i = 0; i < specs.size(); ++i)
        entries[entryKey(specs[i])].push_back(i);
    std::map<decltype(groupKey(specs.front(), 0)), Group> groups;
    for (const auto &[key, entry] : entries)
        groups[groupKey(specs[entry.front()], entry.size())].push_back(entry);
    std::vector<Group> result;
    for (auto &[key, group] : groups)
        result.push_back(std::move(group));
    return result;
}

double numberIn(const Properties &run, const std::string &key)
{
    return std::stod(run.at(key));
}

/// One of OMPL's benchmarks over the entries of a group.
class GroupBenchmark
{
public:
    GroupBenchmark(const std::vector<RunSpec> &specs, const Group &group, const OnRecord &onRecord)
      : specs_(specs), first_(specs[group.front().front()]), onRecord_(onRecord), seed_(first_.seed)
    {
        seedOmpl(seed_);
        problem_ = makeProblem(*first_.scenario, first_.problem);
        for (const Entry &entry : group)
            add(entry);
    }

    /// OMPL's log; empty if no planner of the group can do the problem.
    std::string run()
    {
        if (planners_.empty())
            return {};
        og::SimpleSetup setup(problem_.si);
        setup.addStartState(ob::ScopedState<>(problem_.space, problem_.pdef->getStartState(0)));
        setup.setGoal(problem_.pdef->getGoal());
        setup.setOptimizationObjective(firstSolution(problem_.si));
        problem_.pdef = setup.getProblemDefinition();

        ompl::tools::Benchmark benchmark(setup, first_.instance);
        benchmark.addExperimentParameter("checker", "TEXT", first_.problem.checker);
        benchmark.addExperimentParameter("motion", "TEXT", first_.problem.motion);
        benchmark.addExperimentParameter("space", "TEXT", first_.problem.space);
        for (const std::shared_ptr<MeasuredPlanner> &planner : planners_)
            benchmark.addPlanner(planner);
        benchmark.setPlannerSwitchEvent(
            [this](const ob::PlannerPtr &)
            {
                begun_ = 0;
                ++planner_;
            });
        benchmark.setPreRunEvent([this](const ob::PlannerPtr &) { ++begun_; });
        benchmark.setPostRunEvent([this](const ob::PlannerPtr &, Properties &run) { tryToFinish(run); });

        ompl::tools::Benchmark::Request request;
        request.maxTime = first_.timeLimit;
        request.maxMem = first_.memoryLimit;
        request.runCount = static_cast<unsigned int>(entries_.front().size());
        request.displayProgress = false;
        request.saveConsoleOutput = false;
        request.simplify = first_.simplify;
        benchmark.benchmark(request);
        if (failure_)
            std::rethrow_exception(failure_);
        reportDropped();
        std::ostringstream log;
        benchmark.saveResultsToStream(log);
        return log.str();
    }

private:
    void add(const Entry &entry)
    {
        const RunSpec &spec = specs_[entry.front()];
        const std::string unsupported = whyUnsupported(spec.planner, problem_.context);
        if (unsupported.empty())
        {
            planners_.push_back(std::make_shared<MeasuredPlanner>(
                makePlanner(spec.planner, problem_.context, givenParameters(spec)), problem_.counts));
            if (spec.label != spec.planner)
                planners_.back()->setName(spec.label);
            entries_.push_back(entry);
            return;
        }
        Record record = announce(spec);
        record.outcome = Outcome::Unsupported;
        record.reason = unsupported;
        for (const std::size_t index : entry)
            onRecord_(index, record);
    }

    /// OMPL's benchmark would swallow some exceptions and end with others: they have to wait until it is over.
    void tryToFinish(Properties &run)
    {
        try
        {
            if (!failure_)
                finish(run);
        }
        catch (...)
        {
            failure_ = std::current_exception();
        }
    }

    /// OMPL drops a run whose path it cannot measure.
    void reportDropped()
    {
        for (const Entry &entry : entries_)
            for (const std::size_t index : entry)
                if (finished_.count(index) == 0)
                {
                    Record record = announce(specs_[index]);
                    record.outcome = Outcome::InternalError;
                    record.reason = "dropped by OMPL's benchmark";
                    onRecord_(index, record);
                }
    }

    /// After a run: our verdict into OMPL's properties, and OMPL's figures into our record.
    void finish(Properties &run)
    {
        const MeasuredPlanner &planner = *planners_[planner_ - 1];
        const std::size_t index = entries_[planner_ - 1][begun_ - 1];
        const RunSpec &spec = specs_[index];
        finished_.insert(index);
        Record record = announce(spec);
        record.parameters.clear();
        planner.planner().params().getParams(record.parameters);
        recordCosts(planner.measurement(), record);
        record.time = numberIn(run, "time REAL");
        judge(spec, problem_, planner.planner(), planner.measurement(), planner.path(), record);
        recordPlannerData(spec, problem_, planner.planner(), record);
        recordTiming(spec, record);
        record.measures["process_seed"] = seed_;
        if (record.outcome == Outcome::Solved && run.count("simplification time REAL") > 0)
        {
            record.simplificationTime = numberIn(run, "simplification time REAL");
            judgeSimplified(spec, problem_, *copySolution(*problem_.pdef), record);
        }
        addProperties(record, run);
        onRecord_(index, record);
    }

    static void addProperties(const Record &record, Properties &run)
    {
        run["verified BOOLEAN"] = record.outcome == Outcome::Solved ? "1" : "0";
        run["cpu time REAL"] = fmt::format("{}", *record.cpuTime);
        run["state checks INTEGER"] = std::to_string(*record.stateChecks);
        run["motion checks INTEGER"] = std::to_string(*record.motionChecks);
        run["evaluations INTEGER"] = std::to_string(*record.evaluations);
        if (record.clearance)
            run["verified clearance REAL"] = fmt::format("{}", *record.clearance);
    }

    const std::vector<RunSpec> &specs_;
    const RunSpec &first_;
    const OnRecord &onRecord_;
    std::uint32_t seed_;
    Problem problem_;
    std::vector<std::shared_ptr<MeasuredPlanner>> planners_;
    std::vector<Entry> entries_;  ///< of the same index as their planner
    std::size_t planner_ = 0;     ///< 1 for the first planner
    std::size_t begun_ = 0;       ///< runs of this planner
    std::set<std::size_t> finished_;
    std::exception_ptr failure_;
};

/// Debian's OMPL has an empty version text, which tools that read the log take amiss.
std::string withVersion(const std::string &log)
{
    const std::size_t end = log.find('\n');
    if (log.substr(0, end).find_first_of("0123456789") != std::string::npos)
        return log;
    return fmt::format("OMPL version {}.{}.{}", OMPL_MAJOR_VERSION, OMPL_MINOR_VERSION, OMPL_PATCH_VERSION) +
           log.substr(end);
}

void write(const std::string &path, const std::string &text)
{
    std::ofstream file(path);
    file << text;
    file.close();
    if (!file)
        throw std::runtime_error(path + ": cannot be written");
}
}  // namespace

std::vector<std::string> runOmplBenchmark(const std::vector<RunSpec> &specs, const std::string &logPathPrefix,
                                          const OnRecord &onRecord)
{
    const QuietOmpl quiet;
    std::vector<std::string> paths;
    std::map<std::string, int> logsOfInstance;
    for (const Group &group : grouped(specs))
    {
        const std::string &instance = specs[group.front().front()].instance;
        const std::string log = GroupBenchmark(specs, group, onRecord).run();
        if (log.empty())
            continue;
        const int number = logsOfInstance[instance]++;
        const std::string suffix = number == 0 ? "" : fmt::format("-{}", number + 1);
        paths.push_back(fmt::format("{}{}{}.log", logPathPrefix, instance, suffix));
        write(paths.back(), withVersion(log));
    }
    return paths;
}
}  // namespace narrows
