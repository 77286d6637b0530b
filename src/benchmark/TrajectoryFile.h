// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kernel/trajectory/JointTrajectory.h"

namespace narrows
{
/// Writes samples as CSV: time, then position, velocity, acceleration and jerk of joint 1, of joint 2, ... Samples are
/// 1/rate apart, from 0; the last one is the end. Numbers read back exactly.
/// \param rate per second, > 0
/// \throws std::invalid_argument if the file cannot be written, or the rate is not positive and finite or asks for more
/// than 10^8 samples
void writeTrajectory(const JointTrajectory &trajectory, double rate, const std::string &file);
}  // namespace narrows
