// SPDX-License-Identifier: BSD-3-Clause
// How much memory one trace takes, counted at the allocator.
#include <iostream>

#include <gtest/gtest.h>

#include "AllocationCount.h"
#include "PaperCases.h"
#include "kernel/CurveTracker.h"
#include "kernel/SphereTracker.h"

namespace narrows
{
namespace
{
struct Memory
{
    double peak;   ///< KB that lived at once, the trace among them
    double trace;  ///< KB that are left: the trace
    double total;  ///< KB of all blocks
    std::size_t calls;
};

/// Of one trace, after one that has filled whatever is filled once.
template <typename Follow>
Memory memoryOf(const std::string &name, const Follow &follow)
{
    EXPECT_EQ(follow().status, TraceStatus::ReachedGoal);
    Memory memory{};
    {
        const AllocationCount count;
        const Trace trace = follow();
        memory = {static_cast<double>(count.peak()) / 1e3, static_cast<double>(count.live()) / 1e3,
                  static_cast<double>(count.total()) / 1e3, count.calls()};
    }
    std::cout << name << ": at most " << memory.peak << " KB at once, " << memory.trace << " KB of them the trace; "
              << memory.total << " KB in " << memory.calls << " blocks in all\n";
    return memory;
}

Memory memoryOfPlane(int number)
{
    const PaperRecipe recipe = paperRecipe(number);
    TrackerOptions options;
    options.window = recipe.window;
    return memoryOf("case " + std::to_string(number) + ", plane", [&] { return track(recipe.slice, options); });
}

Memory memoryOfSpheres(int number)
{
    const PaperRecipe recipe = paperRecipe(number);
    SphereOptions options;
    options.window = recipe.window;
    return memoryOf("case " + std::to_string(number) + ", full", [&] { return traceSpheres(recipe.full, options); });
}

TEST(AllocationCount, SeesEigenAndTheStandardLibrary)
{
    const AllocationCount count;
    {
        const Eigen::VectorXd numbers = Eigen::VectorXd::Ones(1000);
        const std::vector<double> more(numbers.data(), numbers.data() + 500);
        EXPECT_GE(count.live(), 12000);
        EXPECT_LE(count.live(), 12200);
        EXPECT_EQ(count.calls(), 2u);
    }
    EXPECT_EQ(count.live(), 0);
    EXPECT_GE(count.peak(), 12000);
}

TEST(TraceMemory, InThePlane)
{
    EXPECT_LE(memoryOfPlane(1).peak, 5.0);
    EXPECT_LE(memoryOfPlane(2).peak, 10.0);
    EXPECT_LE(memoryOfPlane(3).peak, 50.0);
}

TEST(TraceMemory, OfHyperspheres)
{
    EXPECT_LE(memoryOfSpheres(1).peak, 15.0);
    EXPECT_LE(memoryOfSpheres(2).peak, 50.0);
    EXPECT_LE(memoryOfSpheres(3).peak, 300.0);
}
}  // namespace
}  // namespace narrows
