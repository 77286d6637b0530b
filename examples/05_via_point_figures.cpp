// SPDX-License-Identifier: BSD-3-Clause
// The figures of the IOSTV paper (docs/iostv.md) as samples and certified numbers, beside what else goes through the
// same points: FOLDER/samples.csv, numbers.csv, problems.csv, and rises.csv for analysis/rise_sums.py. With the sums of
// rises that it finds, these too.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "kernel/trajectory/InterpolatingSplines.h"
#include "kernel/trajectory/RiseSum.h"
#include "kernel/trajectory/StopAndGo.h"
#include "kernel/trajectory/TrajectoryPeaks.h"
#include "kernel/trajectory/ViaPointIteration.h"
#include "planners/ViaPointOptimizer.h"

namespace
{
using namespace narrows;

constexpr int samples = 200;
constexpr int riseCount = 12;
constexpr double overshoot = 0.4;  // what searches may leave the range of start, via and goal by, degrees

/// Degrees and seconds. The figures of each problem are different parameters for it.
const std::map<std::string, ViaPointTask> problems{
    {"A", {-12.0, 5.0, 30.0, 1.5, 3.0}}, {"B", {10.0, 25.0, 62.0, 2.6, 3.0}}, {"C", {30.0, 180.0, 120.0, 1.5, 3.0}}};

struct Figure
{
    std::string name, problem;
    PaperParameters parameters;
};

/// Fig. 3 with a = 1.8, which the paper does not print. Fig. 5 has no printed parameters, Fig. 7 is a polynomial.
const std::vector<Figure> figures{
    {"Fig. 2", "A", {2.5, -1.4, 2.0, 0.05}},       {"Fig. 3", "A", {2.5, 1.8, 2.0, 1.2481}},
    {"Fig. 4", "B", {1.8, 1.2, 1.7, 0.05}},        {"Fig. 6", "B", {70.0, 2.2, 125.0, -100.0}},
    {"Fig. 8", "C", {81.7467, 2.4, 1.91, 0.8734}}, {"Fig. 9", "C", {5.0, 1.95, 5.0, 0.5865}}};

template <class Value>
Value known(OrFailure<Value> result)
{
    if (!result)
        throw std::runtime_error(toText(result.failure));
    return std::move(*result.value);
}

class Tables
{
public:
    explicit Tables(const std::string &folder) : samples_(folder + "/samples.csv"), numbers_(folder + "/numbers.csv")
    {
        samples_ << "problem,method,time,position,velocity,acceleration,jerk\n";
        numbers_ << "problem,method,name,value\n";
    }

    void number(const std::string &problem, const std::string &method, const std::string &name, double value)
    {
        numbers_ << fmt::format("{},{},{},{}\n", problem, method, name, value);
    }

    /// Samples, certified extremes, and jumps at knots and ends.
    void motion(const std::string &problem, const std::string &method, const PiecewiseMotion &motion)
    {
        const std::vector<double> knots = motion.knots();
        for (std::size_t piece = 0; piece + 1 < knots.size(); ++piece)
        {
            const double length = knots[piece + 1] - knots[piece];
            const int count = std::max(4, static_cast<int>(samples * length / knots.back()));
            for (int i = 0; i <= count; ++i)
                sample(problem, method, motion, piece,
                       i == count ? knots[piece + 1] : knots[piece] + length * i / count);
        }
        const char *orders[] = {"position", "velocity", "acceleration", "jerk"};
        const MotionPeaks peaks = motionPeaks(motion);
        const Series<3> jumps = largestJumps(motion);
        const std::size_t last = knots.size() - 2;
        for (std::size_t k = 0; k < peaks.size(); ++k)
        {
            number(problem, method, fmt::format("lowest {}", orders[k]), peaks[k].lowest);
            number(problem, method, fmt::format("highest {}", orders[k]), peaks[k].highest);
            number(problem, method, fmt::format("largest {}", orders[k]), peaks[k].magnitude());
            number(problem, method, fmt::format("largest jump of {}", orders[k]), jumps[k]);
            number(problem, method, fmt::format("last {}", orders[k]), motion.over(last, knots.back())[k].lower);
        }
        number(problem, method, "time of highest position", peaks[0].highestAt);
        if (const auto task = problems.find(problem); task != problems.end())
            number(problem, method, "overshoot", ViaPointTrajectory::overshoot(task->second, peaks));
    }

private:
    void sample(const std::string &problem, const std::string &method, const PiecewiseMotion &motion, std::size_t piece,
                double t)
    {
        const Series<4, Enclosure> state = motion.over(piece, t);
        samples_ << fmt::format("{},{},{:.5g},{:.6g},{:.6g},{:.6g},{:.6g}\n", problem, method, t, state[0].lower,
                                state[1].lower, state[2].lower, state[3].lower);
    }

    std::ofstream samples_, numbers_;
};

void writeFigure(const Figure &figure, Tables &tables)
{
    const ViaPointTask &task = problems.at(figure.problem);
    const ViaPointTrajectory motion = known(ViaPointTrajectory::paper(task, figure.parameters));
    const auto number = [&](const std::string &name, double value)
    {
        tables.number(figure.problem, figure.name, name, value);
    };
    const PaperLogs logs = paperLogs(task, figure.parameters, motion.feedback());
    number("S_v", motion.feedback());
    number("zeta_v", logs.viaLog);
    number("zeta", logs.goalLog);
    number("K", motion.viaShare());
    for (const auto &[from, first] : {std::pair{"q_0", task.start}, {"theta_v", task.via}, {"S_f", task.goal}})
        number(fmt::format("iterations from {}", from), iterateFeedback(task, figure.parameters, first, 100000).steps);
    const Series<3> jump = motion.viaJump();
    number("velocity's jump at the via", jump[1]);
    number("acceleration's jump at the via", jump[2]);
    number("jerk's jump at the via", jump[3]);
    tables.motion(figure.problem, figure.name, motion);
}

/// What the paper compares itself with, and what this project offers instead.
void writeOthers(const std::string &problem, const ViaPointTask &task, Tables &tables)
{
    const Eigen::MatrixXd points = Eigen::RowVector3d(task.start, task.via, task.goal);
    const std::vector<double> times{0.0, task.viaTime, task.duration};
    const std::pair<const char *, PolynomialTrajectory> polynomials[] = {
        {"sixth order", known(sixthOrder(points, times))},
        {"cubic spline", known(cubicSpline(points, times))},
        {"quintic spline", known(quinticSpline(points, times))},
        {"LSPB with a stop", known(parabolicBlends(points, times))}};
    for (const auto &[name, polynomial] : polynomials)
        tables.motion(problem, name, *polynomial.joint(0));
    TrajectoryWish wish;
    wish.maxOvershoot = overshoot;
    const OptimizedTrajectory best = known(optimizeViaPoint(task, wish));
    tables.number(problem, "full", "shape of the via's term", best.viaShape);
    tables.number(problem, "full", "shape of the goal's term", best.goalShape);
    tables.motion(problem, "full", best.motion);
}

void writeProblems(const std::string &file)
{
    std::ofstream out(file);
    out << "problem,start,via,goal,via_time,duration\n";
    for (const auto &[name, task] : problems)
        out << fmt::format("{},{},{},{},{},{}\n", name, task.start, task.via, task.goal, task.viaTime, task.duration);
}

/// For the linear program: what each rise contributes to position and jerk, in unit time.
void writeRises(const std::string &file)
{
    std::ofstream out(file);
    out << "x,rise,value,slope,curvature,third\n";
    const std::vector<Rise> rises = restingRises(riseCount);
    for (int i = 0; i <= 600; ++i)
        for (std::size_t k = 0; k < rises.size(); ++k)
        {
            const Series<3> g = rises[k].at<3>(i / 600.0);
            out << fmt::format("{},{},{},{},{},{}\n", i / 600.0, k, g[0], g[1], g[2], g[3]);
        }
}

/// Lines "A,c_1,...,c_12".
void writeSums(const std::string &file, Tables &tables)
{
    std::ifstream in(file);
    if (!in)
        throw std::runtime_error("cannot read " + file);
    for (std::string line; std::getline(in, line);)
    {
        std::istringstream cells(line);
        std::string problem, cell;
        std::getline(cells, problem, ',');
        std::vector<double> parts;
        while (std::getline(cells, cell, ','))
            parts.push_back(std::stod(cell));
        const ViaPointTask &task = problems.at(problem);
        const RiseSum sum(task.start, task.duration, restingRises(riseCount), parts);
        tables.motion(problem, "sum of rises", sum);
        tables.number(problem, "sum of rises", "misses the via by", sum.over(0, task.viaTime)[0].lower - task.via);
    }
}

void write(const std::string &folder, const std::string &sums)
{
    std::filesystem::create_directories(folder);
    Tables tables(folder);
    const RiseSum first(0.0, 3.0, {known(Rise::paper(2.0, 0.0, 3.0))}, {4.0});
    tables.motion("1", "Fig. 1", first);
    tables.number("1", "Fig. 1", "position after 1 s", first.over(0, 1.0)[0].lower);
    for (const Figure &figure : figures)
        writeFigure(figure, tables);
    for (const auto &[problem, task] : problems)
        writeOthers(problem, task, tables);
    Eigen::MatrixXd printed(1, 7);
    printed << 30.0, 0.0, 0.0, 282.22, -265.56, 85.19, -9.22;
    tables.motion("C", "Eq. 27 as printed", *PolynomialTrajectory({{3.0, printed}}).joint(0));
    writeProblems(folder + "/problems.csv");
    writeRises(folder + "/rises.csv");
    if (!sums.empty())
        writeSums(sums, tables);
}
}  // namespace

int main(int argc, char **argv)
{
    if (argc != 2 && argc != 3)
    {
        std::cerr << "usage: 05_via_point_figures FOLDER [SUMS.csv]\n";
        return 2;
    }
    try
    {
        write(argv[1], argc == 3 ? argv[2] : "");
        return 0;
    }
    catch (const std::exception &error)
    {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
