// SPDX-License-Identifier: BSD-3-Clause
#include "planners/PlannerFactory.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "PlannerTrial.h"
#include "planners/NearNames.h"

namespace narrows
{
namespace
{
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The message with which an action is refused; empty if it is not.
template <typename Error, typename Action>
std::string refusal(const Action &action)
{
    try
    {
        action();
    }
    catch (const Error &error)
    {
        return error.what();
    }
    return {};
}

std::string parameterRefusal(const std::string &planner, const std::string &parameter, const std::string &value)
{
    const Problem problem = seededProblem();
    return refusal<ParameterError>([&] { makePlanner(planner, problem.context, {{parameter, value}}); });
}

TEST(PlannerFactory, IsSortedAndNamesAreUnique)
{
    const auto notBefore = [](const PlannerEntry &a, const PlannerEntry &b)
    {
        return a.name >= b.name;
    };
    EXPECT_EQ(std::adjacent_find(planners().begin(), planners().end(), notBefore), planners().end());
    for (const PlannerEntry &entry : planners())
        EXPECT_FALSE(entry.summary.empty()) << entry.name;
}

TEST(PlannerFactory, SaysTruthfullyWhoPlansWithThreads)
{
    const Problem problem = seededProblem();
    for (const PlannerEntry &entry : planners())
    {
        if (!whyUnsupported(entry.name, problem.context).empty() && entry.name != "lazylbtrrt")
            continue;
        EXPECT_EQ(entry.threaded, entry.make(problem.context)->getSpecs().multithreaded) << entry.name;
    }
}

TEST(PlannerFactory, ShowsSamplingPlannersNothingButTheSpace)
{
    PlannerContext context;
    context.si = seededProblem().si;
    for (const PlannerEntry &entry : planners())
    {
        EXPECT_TRUE(entry.usesModel || entry.make(context) != nullptr) << entry.name;
        if (entry.usesModel || !whyUnsupported(entry.name, context).empty())
            EXPECT_THROW(makePlanner(entry.name, context), std::invalid_argument) << entry.name;
        else
            EXPECT_NE(makePlanner(entry.name, context), nullptr) << entry.name;
    }
    EXPECT_THROW(makePlanner("lazylbtrrt", context), std::invalid_argument);
    EXPECT_THROW(makePlanner("rrt", {}), std::invalid_argument);
}

TEST(PlannerFactory, ListsNamesNearAnUnknownOne)
{
    const auto message = [](const std::string &name)
    {
        return refusal<std::invalid_argument>([&] { findPlanner(name); });
    };
    EXPECT_THAT(message("rrtconect"), AllOf(HasSubstr("\"rrtconect\""), HasSubstr("did you mean rrtconnect")));
    EXPECT_THAT(message("bitstart"), HasSubstr("bitstar"));
    EXPECT_THAT(message("zzzz"), AllOf(HasSubstr("abitstar"), HasSubstr("xxl")));
    EXPECT_THAT(message(std::string(100'000, 'x')), HasSubstr("abitstar"));
}

TEST(PlannerFactory, RefusesANameThatIsTaken)
{
    PlannerEntry entry = findPlanner("rrt");
    EXPECT_THROW(registerPlanner(entry), std::invalid_argument);
    entry.name = "rrt_again";
    registerPlanner(entry);
    EXPECT_EQ(findPlanner("rrt_again").summary, findPlanner("rrt").summary);
    EXPECT_TRUE(std::is_sorted(planners().begin(), planners().end(),
                               [](const PlannerEntry &a, const PlannerEntry &b) { return a.name < b.name; }));
}

TEST(PlannerFactory, SetsParametersOfEveryKind)
{
    const Problem problem = seededProblem();
    const auto set = [&](const std::string &planner, const std::string &parameter, const std::string &value)
    {
        const ob::PlannerPtr made = makePlanner(planner, problem.context, {{parameter, value}});
        std::string result;
        made->params().getParam(parameter, result);
        return result;
    };
    EXPECT_EQ(std::stod(set("rrtconnect", "range", "0.35")), 0.35);
    EXPECT_EQ(std::stod(set("rrtconnect", "range", "20000")), 20000.0);  // OMPL's ranges are suggestions
    EXPECT_EQ(set("fmt", "num_samples", "1234"), "1234");
    EXPECT_EQ(set("rrt", "intermediate_states", "true"), "1");
    EXPECT_EQ(set("rrt", "intermediate_states", "0"), "0");
    EXPECT_EQ(set("hppm", "form", "full"), "full");
}

TEST(PlannerFactory, RefusesValuesThatDoNotRead)
{
    EXPECT_THAT(parameterRefusal("rrtconnect", "range", "far"),
                AllOf(HasSubstr("rrtconnect.range"), HasSubstr("\"far\""), HasSubstr("a number"), HasSubstr("10000")));
    for (const char *value : {"", " 1", "1 ", "1x", "nan", "inf", "1e999"})
        EXPECT_THAT(parameterRefusal("rrtconnect", "range", value), Not(IsEmpty())) << value;
    for (const char *value : {"", "-1", "1.5", "12x", "99999999999"})
        EXPECT_THAT(parameterRefusal("fmt", "num_samples", value), HasSubstr("a whole number")) << value;
    EXPECT_THAT(parameterRefusal("rrt", "intermediate_states", "no"), HasSubstr("true or false"));
}

TEST(PlannerFactory, RefusesWhatThePlannerRefuses)
{
    EXPECT_THAT(parameterRefusal("fmt", "radius_multiplier", "-1"), HasSubstr("fmt.radius_multiplier"));
    EXPECT_THAT(parameterRefusal("hppm", "form", "round"), HasSubstr("hppm.form"));
    EXPECT_THAT(parameterRefusal("hppm", "radius", "-0.1"), HasSubstr("hppm.radius"));
}

TEST(PlannerFactory, ListsTheParametersThatThereAre)
{
    EXPECT_THAT(parameterRefusal("rrtconnect", "rnge", "1"),
                AllOf(HasSubstr("\"rnge\""), HasSubstr("intermediate_states, range")));
}

TEST(NearNames, PutsTheNearestFirst)
{
    const std::vector<std::string> names = {"est", "rrt", "rrtstar", "sst"};
    EXPECT_THAT(nearNames("rrts", names), ElementsAre("rrt", "rrtstar"));
    EXPECT_THAT(nearNames("sstt", names), ElementsAre("sst", "est"));
    EXPECT_THAT(nearNames("", names), IsEmpty());
    EXPECT_THAT(nearNames("quite another", names), IsEmpty());
}
}  // namespace
}  // namespace narrows
