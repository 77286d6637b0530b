// SPDX-License-Identifier: BSD-3-Clause
// How long robots take along the same vertices under the same limits, by the usual methods and by ours: medians over
// random polylines in joint space, as Markdown. Usage: 06_baseline_durations [POLYLINES]
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

#include "kernel/trajectory/InterpolatingSplines.h"
#include "kernel/trajectory/StopAndGo.h"
#include "kernel/trajectory/TrajectoryPeaks.h"
#include "kernel/trajectory/ViaPointSpline.h"
#include "planners/TrajectorySmoother.h"

namespace
{
using namespace narrows;

constexpr MotionLimits limits{1.5, 4.0, 20.0};  // rad and seconds
constexpr double overlap = 0.6;                 // of the splines' windows
constexpr double tube = 0.2;                    // rad: how far overlapped moves may leave the polyline

struct Polyline
{
    Eigen::MatrixXd vertices;
    std::vector<MotionLimits> limits;
    std::vector<double> times;  ///< of the fastest motion with stops
};

template <class Value>
Value known(OrFailure<Value> result)
{
    if (!result)
        throw std::runtime_error(toText(result.failure));
    return std::move(*result.value);
}

struct Timed
{
    double duration;
    bool keepsJerk;
};

/// Stretched as far as the limits ask for that it can keep at all.
Timed scaled(const Polyline &line, const JointTrajectory &motion)
{
    const TimeStretch stretch = stretchFor(trajectoryPeaks(motion, 1e-6), line.limits);
    return {stretch.factor * motion.duration(), stretch.keepsAll};
}

using Method = std::function<Timed(const Polyline &)>;

Method spline(const Rise &rise)
{
    return [rise](const Polyline &line)
    {
        return scaled(line, known(ViaPointSpline::through(line.vertices, line.times, overlap, rise)));
    };
}

double distanceTo(const Eigen::MatrixXd &vertices, const Eigen::VectorXd &point)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 1; k < vertices.cols(); ++k)
    {
        const Eigen::VectorXd way = vertices.col(k) - vertices.col(k - 1), own = point - vertices.col(k - 1);
        const double share = std::clamp(own.dot(way) / way.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (own - share * way).norm());
    }
    return nearest;
}

/// They cut corners, which splines do not: kept near the polyline in place of obstacles.
Timed overlappedMoves(const Polyline &line)
{
    const auto staysNear = [&line](const JointTrajectory &motion)
    {
        constexpr int samples = 400;
        JointTrajectory::States state;
        for (int i = 0; i <= samples; ++i)
        {
            motion.at(motion.duration() * i / samples, state);
            if (distanceTo(line.vertices, state.col(0)) > tube)
                return false;
        }
        return true;
    };
    SmoothingOptions options;
    options.viaNumbers = 0;  // the vertices stay where they are
    return scaled(line, known(smoothTrajectory(line.vertices, line.limits, staysNear, options)).motion);
}

const std::vector<std::pair<std::string, Method>> methods{
    {"stops, seven phases",
     [](const Polyline &p)
     {
         return scaled(p, known(sevenPhaseStops(p.vertices, p.limits)));
     }},
    {"stops, quintic step",
     [](const Polyline &p)
     {
         return scaled(p, known(quinticStops(p.vertices, p.limits)));
     }},
    {"stops, trapezoid",
     [](const Polyline &p)
     {
         return scaled(p, known(trapezoidStops(p.vertices, p.limits)));
     }},
    {"stops, parabolic blends",
     [](const Polyline &p)
     {
         return scaled(p, known(parabolicBlends(p.vertices, p.times)));
     }},
    {"cubic spline",
     [](const Polyline &p)
     {
         return scaled(p, known(cubicSpline(p.vertices, p.times)));
     }},
    {"quintic spline",
     [](const Polyline &p)
     {
         return scaled(p, known(quinticSpline(p.vertices, p.times)));
     }},
    {"via-point spline, the paper's rise at rest", spline(*Rise::resting(0.7))},
    {"via-point spline, symmetric", spline(*Rise::symmetric(0.75))},
    {"via-point spline, quintic step", spline(Rise::quintic())},
    {"overlapped moves, within 0.2 rad of the polyline", overlappedMoves}};

Polyline randomPolyline(std::mt19937 &random, Eigen::Index joints, Eigen::Index vertices)
{
    std::uniform_real_distribution<double> angle(-1.5, 1.5);
    Polyline line;
    line.vertices = Eigen::MatrixXd::NullaryExpr(joints, vertices, [&] { return angle(random); });
    line.limits.assign(static_cast<std::size_t>(joints), limits);
    line.times = known(stopTimes(line.vertices, line.limits));
    return line;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

void printTable(int count)
{
    const std::pair<Eigen::Index, Eigen::Index> sizes[] = {{3, 3}, {7, 4}, {7, 8}};
    std::map<std::string, std::string> rows;
    for (const auto &[joints, vertices] : sizes)
    {
        std::mt19937 random(1);
        std::vector<Polyline> lines;
        for (int i = 0; i < count; ++i)
            lines.push_back(randomPolyline(random, joints, vertices));
        for (const auto &[name, method] : methods)
        {
            std::vector<double> ratios;
            bool keepsJerk = true;
            for (const Polyline &line : lines)
            {
                const Timed timed = method(line);
                ratios.push_back(timed.duration / line.times.back());
                keepsJerk = keepsJerk && timed.keepsJerk;
            }
            rows[name] += fmt::format(" {:.3f}{} |", median(ratios), keepsJerk ? "" : " (∞)");
        }
    }
    std::cout
        << "| method | 3 joints, 3 vertices | 7 joints, 4 vertices | 7 joints, 8 vertices |\n|---|---:|---:|---:|\n";
    for (const auto &[name, method] : methods)
        std::cout << fmt::format("| {} |{}\n", name, rows[name]);
}
}  // namespace

int main(int argc, char **argv)
{
    try
    {
        const int count = argc > 1 ? std::stoi(argv[1]) : 50;
        if (argc > 2 || count < 1)
            throw std::invalid_argument("usage: 06_baseline_durations [POLYLINES]");
        printTable(count);
        return 0;
    }
    catch (const std::exception &error)
    {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
