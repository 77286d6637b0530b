// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/TrajectoryFile.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

namespace narrows
{
namespace
{
constexpr double mostSamples = 1e8;

std::string header(Eigen::Index joints)
{
    std::string text = "time";
    for (Eigen::Index i = 1; i <= joints; ++i)
        text += fmt::format(",position_{0},velocity_{0},acceleration_{0},jerk_{0}", i);
    return text + "\n";
}
}  // namespace

void writeTrajectory(const JointTrajectory &trajectory, double rate, const std::string &file)
{
    if (!(rate > 0.0) || !(trajectory.duration() * rate <= mostSamples))
        throw std::invalid_argument(fmt::format("{} samples per second is no rate, or too high a one", rate));
    std::ofstream out(file);
    out << header(trajectory.joints());
    JointTrajectory::States state;
    const double count = std::ceil(trajectory.duration() * rate);
    for (double i = 0.0; out && i <= count; ++i)
    {
        const double t = i < count ? i / rate : trajectory.duration();
        trajectory.at(t, state);
        std::string row = fmt::format("{}", t);
        for (Eigen::Index joint = 0; joint < state.rows(); ++joint)
            for (Eigen::Index order = 0; order < 4; ++order)
                row += fmt::format(",{}", state(joint, order));
        out << row << "\n";
    }
    if (!out.flush())
        throw std::invalid_argument("cannot write " + file);
}
}  // namespace narrows
