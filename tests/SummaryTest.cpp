// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/Summary.h"

namespace narrows
{
namespace
{
// Expected values: scipy 1.10.1, binomtest(k, n).proportion_ci(method="wilson").
TEST(Wilson, AgreesWithScipy)
{
    struct Case
    {
        int k, n;
        double lower, upper;
    };
    for (const Case &c :
         {Case{0, 20, 0.0, 0.16112515805281935}, Case{20, 20, 0.8388748419471808, 1.0},
          Case{7, 20, 0.1811918241010821, 0.5671457233147637}, Case{1, 3, 0.06149194472039626, 0.7923403991979523},
          Case{50, 100, 0.4038315303659956, 0.5961684696340044}})
    {
        SCOPED_TRACE(testing::Message() << c.k << " of " << c.n);
        const Spread interval = wilson(c.k, c.n);
        EXPECT_NEAR(interval.lower, c.lower, 1e-12);
        EXPECT_NEAR(interval.upper, c.upper, 1e-12);
        EXPECT_DOUBLE_EQ(interval.middle, static_cast<double>(c.k) / c.n);
    }
    EXPECT_THROW(wilson(0, 0), std::invalid_argument);
    EXPECT_THROW(wilson(3, 2), std::invalid_argument);
    EXPECT_THROW(wilson(-1, 2), std::invalid_argument);
}

// Expected values: numpy.percentile(x, [25, 50, 75]).
TEST(Quartiles, AgreeWithNumpy)
{
    const auto spread = quartiles({9.0, 1.0, 4.0, 2.5, 7.0, 3.0});
    ASSERT_TRUE(spread);
    EXPECT_DOUBLE_EQ(spread->lower, 2.625);
    EXPECT_DOUBLE_EQ(spread->middle, 3.5);
    EXPECT_DOUBLE_EQ(spread->upper, 6.25);
    const auto single = quartiles({5.0});
    EXPECT_DOUBLE_EQ(single->lower, 5.0);
    EXPECT_DOUBLE_EQ(single->upper, 5.0);
    EXPECT_FALSE(quartiles({}));
}

RunRow row(const std::string &label, Outcome outcome, std::optional<double> cpu, const std::string &reason = "")
{
    RunRow result;
    result.instance = result.group = "case_analytic";
    result.label = label;
    result.outcome = outcome;
    result.reason = reason;
    result.cpuTime = cpu;
    return result;
}

TEST(Summary, SortsBySuccessThenTimeAndIgnoresTimesOfUnsolvedRuns)
{
    std::vector<RunRow> runs{row("slow", Outcome::Solved, 0.020),
                             row("slow", Outcome::Solved, 0.040),
                             row("fast", Outcome::Solved, 0.001),
                             row("fast", Outcome::Solved, 0.003),
                             row("rare", Outcome::Solved, 0.0001),
                             row("rare", Outcome::Timeout, 2.0, "limit"),
                             row("never", Outcome::Timeout, 2.0),
                             row("never", Outcome::Crash, {}, "SIGSEGV: at 1"),
                             row("never", Outcome::Crash, {}, "SIGSEGV: at 2")};
    runs[2].prescribed = true;
    const std::vector<SummaryRow> rows = summarize(runs);
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0].label, "fast");
    EXPECT_DOUBLE_EQ(rows[0].cpuMilliseconds->middle, 2.0);
    EXPECT_TRUE(rows[0].prescribed);
    EXPECT_EQ(rows[1].label, "slow");
    EXPECT_DOUBLE_EQ(rows[1].cpuMilliseconds->lower, 25.0);
    EXPECT_EQ(rows[2].label, "rare");
    EXPECT_DOUBLE_EQ(rows[2].cpuMilliseconds->middle, 0.1);
    EXPECT_EQ(rows[2].failures, "timeout (limit) 1");
    EXPECT_EQ(rows[3].label, "never");
    EXPECT_FALSE(rows[3].cpuMilliseconds);
    EXPECT_EQ(rows[3].failures, "crash (SIGSEGV) 2, timeout 1");
}

TEST(Summary, KeepsTheOrderOfGroups)
{
    std::vector<RunRow> runs{row("a", Outcome::Solved, 1.0), row("a", Outcome::Solved, 1.0)};
    runs[0].group = "zebra";
    runs[1].group = "ant";
    const std::vector<SummaryRow> rows = summarize(runs);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].group, "zebra");
}

TEST(Summary, PutsScenesOfOneGroupTogetherAndCountsThoseThatHaveASolution)
{
    std::vector<RunRow> runs{row("a", Outcome::Solved, 1.0), row("a", Outcome::Timeout, {}),
                             row("a", Outcome::Timeout, {}), row("b", Outcome::Timeout, {}),
                             row("b", Outcome::Solved, 3.0), row("b", Outcome::Timeout, {})};
    for (std::size_t i = 0; i < runs.size(); ++i)
        runs[i].instance = "scene" + std::to_string(i % 3);
    const std::vector<SummaryRow> rows = summarize(runs);
    ASSERT_EQ(rows.size(), 2u);
    for (const SummaryRow &entry : rows)
    {
        EXPECT_EQ(entry.runs, 3);
        EXPECT_EQ(entry.solved, 1);
        EXPECT_EQ(entry.instances, 3);
        EXPECT_EQ(entry.solvableInstances, 2);
    }
    EXPECT_THAT(summaryText(rows), testing::HasSubstr("case_analytic (3 instances, 2 of them solved by some planner)"));
    runs.resize(1);
    EXPECT_THAT(summaryMarkdown(summarize(runs)), testing::HasSubstr("### case_analytic\n"));
}

TEST(Summary, TablesMarkPrescribedRowsAndSayWhatMediansAreOver)
{
    std::vector<RunRow> runs{row("hppm", Outcome::Solved, 0.001), row("a|b", Outcome::Timeout, {})};
    const std::string plain = summaryText(summarize(runs));
    EXPECT_THAT(plain, testing::HasSubstr("medians over solved runs only"));
    EXPECT_THAT(plain, testing::Not(testing::HasSubstr("recipe")));
    runs[0].prescribed = true;
    const std::string text = summaryText(summarize(runs));
    EXPECT_THAT(text, testing::HasSubstr("hppm *"));
    EXPECT_THAT(text, testing::HasSubstr("1 [1, 1]"));
    EXPECT_THAT(text, testing::HasSubstr("* uses the recipe prescribed for this scenario"));
    const std::string markdown = summaryMarkdown(summarize(runs));
    EXPECT_THAT(markdown, testing::HasSubstr("| hppm \\* | 1/1 | 100 % [21, 100] | 1 [1, 1] | - |"));
    EXPECT_THAT(markdown, testing::HasSubstr("| a\\|b | 0/1 |"));
}
}  // namespace
}  // namespace narrows
