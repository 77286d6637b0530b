// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ContinuousMotionValidator.h"

#include <cmath>

#include <gtest/gtest.h>

#include "PaperCases.h"
#include "scenario/Problem.h"

namespace narrows
{
namespace
{
using Eigen::Vector2d;

const double pi = std::acos(-1.0);

/// One link of length 2 at the origin and whatever stands around it.
Problem oneLink(std::vector<PlanarObstacle> obstacles, const ProblemOptions &options = {})
{
    Scenario scenario;
    scenario.name = "one-link";
    scenario.planar().model =
        std::make_shared<PlanarModel>(PlanarModel{PlanarArm({0, 0}, {{2.0, -1}}), std::move(obstacles)});
    scenario.planar().task.start = Eigen::VectorXd::Constant(1, -1.0);
    scenario.planar().task.goal = Eigen::VectorXd(Eigen::VectorXd::Constant(1, 1.0));
    return makeProblem(scenario, options);
}

ob::ScopedState<> at(const Problem &problem, double angle)
{
    ob::ScopedState<> state(problem.si);
    problem.space->fromConfiguration(Eigen::VectorXd::Constant(1, angle), state.get());
    return state;
}

/// A needle of width 2e-6 across the link's way at angle 0.
const PlanarObstacle needle{"needle", Polygon{{{1.0, -1e-6}, {3.0, -1e-6}, {3.0, 1e-6}, {1.0, 1e-6}}}};

TEST(ContinuousMotionValidator, SeesWhatSamplingJumpsOver)
{
    const Problem problem = oneLink({needle});
    EXPECT_FALSE(problem.si->checkMotion(at(problem, -0.5).get(), at(problem, 0.7).get()));
    EXPECT_TRUE(problem.si->checkMotion(at(problem, 0.1).get(), at(problem, 0.7).get()));
    // OMPL's own validator at its default resolution goes straight through.
    const Problem sampled = oneLink({needle}, {"analytic", "0.01", "absolute"});
    EXPECT_TRUE(sampled.si->checkMotion(at(sampled, -0.5).get(), at(sampled, 0.7).get()));
}

TEST(ContinuousMotionValidator, GoesTheShortWayRound)
{
    // A wall on the positive x axis: the way over pi is free, the way over 0 is not.
    const Problem wrapping = oneLink({needle});
    EXPECT_TRUE(wrapping.si->checkMotion(at(wrapping, -2.5).get(), at(wrapping, 2.5).get()));
    const Problem line = oneLink({needle}, {"analytic", "continuous", "absolute_line"});
    EXPECT_FALSE(line.si->checkMotion(at(line, -2.5).get(), at(line, 2.5).get()));
}

TEST(ContinuousMotionValidator, DecidesTightPassagesExactly)
{
    // The tip's circle passes a disc at a distance of 1e-7, or cuts it by 1e-7.
    const Problem past = oneLink({{"disc", Circle{{3.0, 0.0}, 1.0 - 1e-7}}});
    EXPECT_TRUE(past.si->checkMotion(at(past, -1.0).get(), at(past, 1.0).get()));
    const Problem through = oneLink({{"disc", Circle{{3.0, 0.0}, 1.0 + 1e-7}}});
    EXPECT_FALSE(through.si->checkMotion(at(through, -1.0).get(), at(through, 1.0).get()));
    const Problem touching = oneLink({{"disc", Circle{{3.0, 0.0}, 1.0}}});
    EXPECT_FALSE(touching.si->checkMotion(at(touching, -1.0).get(), at(touching, 1.0).get()));
}

TEST(ContinuousMotionValidator, RefusesMotionsThatEndInCollision)
{
    const Problem problem = oneLink({needle});
    EXPECT_FALSE(problem.si->checkMotion(at(problem, 1.0).get(), at(problem, 0.0).get()));
}

TEST(ContinuousMotionValidator, FindsTheFreeStretch)
{
    const Problem problem = oneLink({needle});
    ob::ScopedState<> last(problem.si);
    std::pair<ob::State *, double> lastValid(last.get(), 0.0);
    // The needle is at 5/12 of the way.
    EXPECT_FALSE(problem.si->checkMotion(at(problem, -0.5).get(), at(problem, 0.7).get(), lastValid));
    EXPECT_GT(lastValid.second, 5.0 / 12.0 - 2.0 / 256.0);
    EXPECT_LT(lastValid.second, 5.0 / 12.0);
    EXPECT_TRUE(problem.si->isValid(last.get()));
    EXPECT_TRUE(problem.si->checkMotion(at(problem, -0.5).get(), last.get()));
}

/// The last link swings across the first one; both ends of the motion are free.
TEST(ContinuousMotionValidator, KeepsLinksApartOnlyWhereAsked)
{
    for (const bool selfCollision : {false, true})
    {
        Scenario scenario;
        const PlanarArm arm({0, 0}, {{2.0, -1}, {1.0, 0}, {1.5, 1}});
        scenario.planar().model = std::make_shared<PlanarModel>(PlanarModel{arm, {}, selfCollision});
        scenario.planar().task.start = Eigen::Vector3d(0.0, 2.0, 3.0);
        scenario.planar().task.goal = Eigen::VectorXd(Eigen::Vector3d(0.0, 2.0, 5.0));
        for (const char *checker : {"analytic", "fcl"})
        {
            const Problem problem = makeProblem(scenario, {checker, "continuous", "absolute_line"});
            ob::ScopedState<> from(problem.si), to(problem.si), folded(problem.si);
            problem.space->fromConfiguration(Eigen::Vector3d(0.0, 2.0, 3.0), from.get());
            problem.space->fromConfiguration(Eigen::Vector3d(0.0, 2.0, 7.0), to.get());
            problem.space->fromConfiguration(Eigen::Vector3d(0.0, 2.0, 4.6), folded.get());
            EXPECT_TRUE(problem.si->isValid(from.get()));
            EXPECT_TRUE(problem.si->isValid(to.get()));
            EXPECT_EQ(problem.si->isValid(folded.get()), !selfCollision);
            EXPECT_EQ(problem.si->checkMotion(from.get(), to.get()), !selfCollision) << checker;
        }
    }
}

TEST(ContinuousMotionValidator, CountsWhatItDoes)
{
    const Problem problem = oneLink({needle});
    const auto before = problem.counts->placements.load();
    problem.si->checkMotion(at(problem, 1.0).get(), at(problem, 1.1).get());
    EXPECT_EQ(problem.counts->motionChecks.load(), 1u);
    EXPECT_GE(problem.counts->placements.load(), before + 1);  // in the open the middle settles it
    EXPECT_LE(problem.counts->placements.load(), before + 4);
}

/// Motions the validator calls free have no collision at densely sampled states; random motions in the paper's mazes.
TEST(ContinuousMotionValidator, FreeMotionsAreFreeWhereverOneLooks)
{
    for (const int number : {1, 2, 3})
        for (const char *space : {"absolute", "relative"})
        {
            const Problem problem = makeProblem(paperCase(number), {"analytic", "continuous", space});
            ompl::RNG::setSeed(1);
            const ob::StateSamplerPtr sampler = problem.si->allocStateSampler();
            ob::ScopedState<> from(problem.si), to(problem.si), between(problem.si);
            int free = 0;
            for (int trial = 0; trial < 400; ++trial)
            {
                sampler->sampleUniform(from.get());
                sampler->sampleUniformNear(to.get(), from.get(), 0.4);
                if (!problem.si->isValid(from.get()) || !problem.si->checkMotion(from.get(), to.get()))
                    continue;
                ++free;
                for (int i = 0; i <= 200; ++i)
                {
                    problem.space->interpolate(from.get(), to.get(), i / 200.0, between.get());
                    ASSERT_TRUE(problem.si->isValid(between.get()))
                        << "case " << number << " " << space << ", trial " << trial << ", at " << i / 200.0;
                }
            }
            EXPECT_GT(free, 40) << "case " << number << " " << space;
        }
}
}  // namespace
}  // namespace narrows
