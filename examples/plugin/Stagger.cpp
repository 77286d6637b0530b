// SPDX-License-Identifier: BSD-3-Clause
// A planner as a plugin: joins start and goal by straight motions over one random state, then over two, and so on.
#include <memory>
#include <vector>

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/PathGeometric.h>
#include <planners/PlannerPlugin.h>

namespace
{
namespace ob = ompl::base;
namespace og = ompl::geometric;

class Stagger : public ob::Planner
{
public:
    explicit Stagger(const ob::SpaceInformationPtr &si) : ob::Planner(si, "stagger")
    {
        declareParam<unsigned int>("tries", this, &Stagger::setTries, &Stagger::getTries, "1:1:100000");
    }

    void setTries(unsigned int tries) { tries_ = tries; }
    unsigned int getTries() const { return tries_; }

    using ob::Planner::solve;
    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override
    {
        checkValidity();
        if (!pdef_->getGoal()->hasType(ob::GOAL_SAMPLEABLE_REGION))
            return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
        const ob::State *start = pis_.nextStart();
        if (start == nullptr)
            return ob::PlannerStatus::INVALID_START;
        const ob::State *goal = pis_.nextGoal(ptc);
        if (goal == nullptr)
            return ob::PlannerStatus::INVALID_GOAL;

        const ob::StateSamplerPtr sampler = si_->allocStateSampler();
        for (unsigned int corners = 0; !ptc; ++corners)
            for (unsigned int i = 0; i < (corners == 0 ? 1 : tries_) && !ptc; ++i)
            {
                const auto path = draw(start, goal, corners, *sampler);
                if (isFree(*path))
                {
                    pdef_->addSolutionPath(path, false, 0.0, getName());
                    return ob::PlannerStatus::EXACT_SOLUTION;
                }
            }
        return ob::PlannerStatus::TIMEOUT;
    }

private:
    std::shared_ptr<og::PathGeometric> draw(const ob::State *start, const ob::State *goal, unsigned int corners,
                                            ob::StateSampler &sampler) const
    {
        auto path = std::make_shared<og::PathGeometric>(si_, start);
        ob::State *corner = si_->allocState();
        for (unsigned int i = 0; i < corners; ++i)
        {
            sampler.sampleUniform(corner);
            path->append(corner);
        }
        si_->freeState(corner);
        path->append(goal);
        return path;
    }

    bool isFree(og::PathGeometric &path) const
    {
        for (std::size_t i = 1; i < path.getStateCount(); ++i)
            if (!si_->isValid(path.getState(i)) || !si_->checkMotion(path.getState(i - 1), path.getState(i)))
                return false;
        return true;
    }

    unsigned int tries_ = 100;
};

ob::Planner *makeStagger(const ob::SpaceInformationPtr &si)
{
    return new Stagger(si);
}

const NarrowsPluginPlanner planners[] = {{"stagger", "straight motions over random states", makeStagger, false}};
const NarrowsPlugin plugin{NARROWS_PLUGIN_INTERFACE, OMPL_VERSION_VALUE, NARROWS_PLUGIN_ABI, 1, planners};
}  // namespace

const NarrowsPlugin *narrowsPlugin()
{
    return &plugin;
}
