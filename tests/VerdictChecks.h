// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "validity/Verifier.h"

namespace narrows
{
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
