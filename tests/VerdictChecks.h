// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "validity/Verifier.h"

namespace narrows
{
using Rows = std::vector<Eigen::VectorXd>;

inline const double pi = std::acos(-1.0);
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A path by its waypoints.
inline Rows rows(const std::vector<std::vector<double>> &values)
{
    Rows path;
    for (const std::vector<double> &row : values)
        path.push_back(Eigen::Map<const Eigen::VectorXd>(row.data(), static_cast<Eigen::Index>(row.size())));
    return path;
}

/// An accepting verdict whose clearance is never overstated and at most `tolerance` too small.
inline void expectClearance(const Verdict &verdict, double exact, double tolerance = 1e-6)
{
    EXPECT_TRUE(verdict.accepted) << verdict.reason << " at " << verdict.segment << "+" << verdict.fraction;
    EXPECT_LE(verdict.clearance, exact);
    EXPECT_GE(verdict.clearance, exact - tolerance - 1e-12);
}

inline void expectRefusal(const Verdict &verdict, const std::string &reason, int segment)
{
    EXPECT_FALSE(verdict.accepted);
    EXPECT_EQ(verdict.reason, reason);
    EXPECT_EQ(verdict.segment, segment);
}
}  // namespace narrows
