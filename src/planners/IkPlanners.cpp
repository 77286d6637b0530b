// SPDX-License-Identifier: BSD-3-Clause
#include "planners/IkPlanners.h"

#include "kernel/DampedTipSearch.h"
#include "kernel/PostureWish.h"
#include "planners/NloptTipSearch.h"
#include "planners/Require.h"

namespace narrows
{
DampedFollower::DampedFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model)
  : DampedFollower(si, std::move(model), "IkDls")
{
}

DampedFollower::DampedFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model,
                               const std::string &name)
  : TipFollower(si, std::move(model), name)
{
    declareParam<double>("lambda", this, &DampedFollower::setLambda, &DampedFollower::getLambda, "1e-6:1e-3:1");
}

void DampedFollower::setLambda(double lambda)
{
    lambda_ = within(1e-6, lambda, 1.0, "lambda");
}

std::unique_ptr<TipSearch> DampedFollower::makeSearch(const TipSearchTask &task) const
{
    DampedTipSearchOptions options;
    options.lambda = lambda_;
    return std::make_unique<DampedTipSearch>(model().arm, task, options);
}

ProjectionFollower::ProjectionFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model)
  : DampedFollower(si, std::move(model), "IkProjection"), influence_(length() / 20.0)
{
    using Self = ProjectionFollower;
    declareParam<int>("null_steps", this, &Self::setNullSteps, &Self::getNullSteps, "1:1:100");
    declareParam<double>("bend_gain", this, &Self::setBendGain, &Self::getBendGain, "0:0.01:1");
    declareParam<double>("obstacle_gain", this, &Self::setObstacleGain, &Self::getObstacleGain, "0:0.01:1");
    declareParam<double>("influence", this, &Self::setInfluence, &Self::getInfluence);
}

void ProjectionFollower::setNullSteps(int steps)
{
    nullSteps_ = within(1, steps, 100, "null_steps");
}

void ProjectionFollower::setBendGain(double gain)
{
    bendGain_ = within(0.0, gain, 1.0, "bend_gain");
}

void ProjectionFollower::setObstacleGain(double gain)
{
    obstacleGain_ = within(0.0, gain, 1.0, "obstacle_gain");
}

void ProjectionFollower::setInfluence(double distance)
{
    influence_ = notNegative(distance, "influence");
}

std::unique_ptr<TipSearch> ProjectionFollower::makeSearch(const TipSearchTask &task) const
{
    const PostureWishOptions wish{bendGain_, obstacleGain_, influence_};
    DampedTipSearchOptions options;
    options.lambda = getLambda();
    options.nullMotion = PostureWish(std::make_shared<const SpatialPoles>(model()), wish);
    options.nullSteps = nullSteps_;
    return std::make_unique<DampedTipSearch>(model().arm, task, options);
}

NloptFollower::NloptFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model)
  : TipFollower(si, std::move(model), "IkNlopt"), margin_(length() / 500.0)
{
    declareParam<std::string>("algorithm", this, &NloptFollower::setAlgorithm, &NloptFollower::getAlgorithm,
                              "slsqp,cobyla");
    declareParam<double>("margin", this, &NloptFollower::setMargin, &NloptFollower::getMargin);
}

void NloptFollower::setAlgorithm(const std::string &algorithm)
{
    algorithm_ = oneOf({"slsqp", "cobyla"}, algorithm, "algorithm");
}

void NloptFollower::setMargin(double margin)
{
    margin_ = notNegative(margin, "margin");
}

std::unique_ptr<TipSearch> NloptFollower::makeSearch(const TipSearchTask &task) const
{
    const auto poles = std::make_shared<const SpatialPoles>(model());
    return std::make_unique<NloptTipSearch>(poles, task, NloptOptions{algorithm_ == "cobyla", margin_});
}

namespace
{
std::string whyNotInSpace(const PlannerContext &context)
{
    return context.spatial ? "" : "follows tips of robots in space";
}

template <typename Follower>
PlannerEntry entry(const char *name, const char *summary)
{
    PlannerEntry result;
    result.name = name;
    result.summary = summary;
    result.usesModel = true;
    result.followsTipPath = true;
    result.make = [](const PlannerContext &context)
    {
        if (const std::string why = whyNotInSpace(context); !why.empty())
            throw std::invalid_argument("numerical inverse kinematics " + why);
        return std::make_shared<Follower>(context.si, context.spatial);
    };
    result.unsupported = whyNotInSpace;
    return result;
}
}  // namespace

std::vector<PlannerEntry> ikPlanners()
{
    return {
        entry<DampedFollower>("ikdls", "follows a tip path by damped least squares, blind for obstacles"),
        entry<ProjectionFollower>("ikprojection", "follows a tip path by gradient projection away from obstacles"),
        entry<NloptFollower>("iknlopt", "follows a tip path by constrained optimization (NLopt's SLSQP or COBYLA)"),
    };
}
}  // namespace narrows
