// SPDX-License-Identifier: BSD-3-Clause
#include "planners/RecipeSampler.h"

#include <algorithm>
#include <cmath>

namespace narrows
{
namespace
{
constexpr double mostAtEnds = 3.0;  // |W| at start and goal, in radians of the slice's direction
constexpr double weakest = 0.05;    // strengths, in natural ones
constexpr double weakestInSpace = 0.005;
constexpr double strongest = 1.0;
constexpr double turnedPart = 0.3;         // of the attempts
constexpr double heldPart = 0.75;          // of the attempts that could hold joints
constexpr double sidedPart = 0.5;          // of the attempts: signs by sides instead of chance
constexpr double equalPart = 0.9;          // of the attempts in space: one sign for all
constexpr double deviationPerJoint = 5.2;  // radians; grows with the square root of the number of joints

/// Wide enough for a link in the narrowest throat to have both sides in it.
double throatWidth(const RepulsionModel &model, const Eigen::VectorXd &q)
{
    constexpr double leastPart = 0.01;  // of the distance at which poles of natural strength count
    Eigen::VectorXd gradient;
    const double ordinary = model.obstacleCount() > 0 ? std::sqrt(model.naturalStrength(0)) : 1.0;
    return std::max(2.0 * model.clearance(q, gradient), leastPart * ordinary);
}
}  // namespace

RecipeSampler::RecipeSampler(std::shared_ptr<const RepulsionModel> model, const CurveEnds &ends, int rows, double unit)
  : model_(std::move(model)), ends_(ends), rows_(rows), unit_(unit)
{
    atStart_ = model_->surroundings(ends.start, throatWidth(*model_, ends.start));
    atGoal_ = model_->surroundings(ends.goal, throatWidth(*model_, ends.goal));
}

CurveRecipe RecipeSampler::next(ompl::RNG &random)
{
    if (reverse_)
    {
        const CurveRecipe recipe = *reverse_;
        reverse_.reset();
        return recipe;
    }
    return draw(random);
}

CurveRecipe RecipeSampler::draw(ompl::RNG &random)
{
    CurveRecipe recipe;
    recipe.turns = ends_.turns;
    if (++drawn_ > 2 && random.uniform01() < turnedPart)
        turn(random, recipe);
    const bool held = hold(random, recipe);
    const bool goalIsNarrower = atGoal_.clearance < atStart_.clearance;
    recipe.fromGoal = held == goalIsNarrower;
    aim(random, recipe);
    charge(random, recipe);
    recipe.window.lambdaMin = held ? -3.0 : -0.1;
    recipe.window.lambdaMax = held ? 2.0 : 1.5;
    recipe.window.maxDeviation = unit_ * deviationPerJoint * std::sqrt(static_cast<double>(ends_.start.size()));
    if (held)
    {
        reverse_ = recipe;
        reverse_->window.decreasing = true;
    }
    return recipe;
}

void RecipeSampler::turn(ompl::RNG &random, CurveRecipe &recipe) const
{
    if (ends_.turnable.empty())
        return;
    const int count = random.uniform01() < 0.7 ? 1 : 2;
    for (int i = 0; i < count; ++i)
    {
        const int joint = ends_.turnable[random.uniformInt(0, static_cast<int>(ends_.turnable.size()) - 1)];
        recipe.turns[joint] += random.uniformBool() ? 1 : -1;
    }
}

bool RecipeSampler::hold(ompl::RNG &random, CurveRecipe &recipe) const
{
    if (atStart_.pinned.empty() && atGoal_.pinned.empty())
        return false;
    if (random.uniform01() >= heldPart)
        return false;
    // As the curve is traced: from the narrower end.
    const bool fromGoal = atGoal_.clearance < atStart_.clearance;
    recipe.schedule.held.assign(static_cast<std::size_t>(ends_.start.size()), 0);
    for (const int joint : (fromGoal ? atStart_ : atGoal_).pinned)
        recipe.schedule.held[joint] = 1;
    for (const int joint : (fromGoal ? atGoal_ : atStart_).pinned)
        recipe.schedule.held[joint] = -1;
    const std::vector<int> &held = recipe.schedule.held;
    if (std::count(held.begin(), held.end(), 0) <= rows_)
    {
        recipe.schedule = {};  // too few are left to lead them out: the slice needs all its dimensions
        return false;
    }
    recipe.schedule.share = random.uniformReal(0.1, 0.7);
    return true;
}

void RecipeSampler::aim(ompl::RNG &random, CurveRecipe &recipe) const
{
    const Eigen::Index joints = ends_.start.size();
    recipe.directions.resize(joints, rows_);
    recipe.couplings = Eigen::VectorXd::Ones(rows_);
    const auto isFree = [&](Eigen::Index joint)
    {
        return recipe.schedule.held.empty() || recipe.schedule.held[static_cast<std::size_t>(joint)] == 0;
    };
    for (int row = 0; row < rows_; ++row)
    {
        Eigen::VectorXd direction(joints);
        for (Eigen::Index j = 0; j < joints; ++j)
            direction[j] = isFree(j) ? random.gaussian01() : 0.0;
        for (int other = 0; other < row; ++other)
            direction -= recipe.directions.col(other).dot(direction) * recipe.directions.col(other);
        recipe.directions.col(row) = direction.normalized();
    }
}

void RecipeSampler::charge(ompl::RNG &random, CurveRecipe &recipe) const
{
    const std::size_t groups = model_->groups().size();
    const std::vector<int> &sides = (atGoal_.clearance < atStart_.clearance ? atGoal_ : atStart_).sides;
    recipe.strengths = Eigen::MatrixXd::Zero(rows_, static_cast<Eigen::Index>(groups));
    // In space obstacles have no sides: curves pass obstacles on any side, so that poles of one sign, which do not
    // cancel each other, do best; and they pass through rings, which takes weak ones.
    const bool planar = model_->workspace() == 2;
    const double least = planar ? weakest : weakestInSpace;
    const double share = unit_ * std::exp(random.uniformReal(std::log(least), std::log(strongest)));
    const bool byRule = random.uniform01() < (planar ? sidedPart : equalPart);
    const int mirror = random.uniformBool() ? 1 : -1;
    for (std::size_t i = 0; i < groups; ++i)
    {
        // What an end touches, a limit as a rule, can have no pole: it would be infinite there.
        if (!std::isfinite(atStart_.weights[i]) || !std::isfinite(atGoal_.weights[i]))
            continue;
        const int chance = random.uniformBool() ? 1 : -1;
        const int side = byRule ? mirror * (sides[i] != 0 ? sides[i] : 1) : chance;
        const int row = rows_ == 1 ? 0 : random.uniformInt(0, rows_ - 1);
        recipe.strengths(row, static_cast<Eigen::Index>(i)) = side * share * model_->naturalStrength(i);
    }
    for (int row = 0; row < rows_; ++row)
        balance(random, recipe.strengths.row(row));
}

void RecipeSampler::balance(ompl::RNG &random, Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> strengths) const
{
    const double size = strengths.norm();
    const Eigen::Array<bool, 1, Eigen::Dynamic> present = strengths.array() != 0.0;
    for (int sweep = 0; sweep < 3; ++sweep)
    {
        // Nearly equal signs leave little when they are balanced; too weak poles are walls that steps jump over.
        if (strengths.norm() < 0.3 * size)
            strengths *= size / strengths.norm();
        for (const Surroundings *end : {&atStart_, &atGoal_})
        {
            const Eigen::Map<const Eigen::RowVectorXd> all(end->weights.data(), strengths.size());
            const Eigen::RowVectorXd weights = present.select(all, 0.0);
            const double value = weights.dot(strengths);
            if (!(std::abs(value) > mostAtEnds * unit_))
                continue;
            const double wanted = std::copysign(mostAtEnds * unit_ * random.uniform01(), value);
            strengths -= (value - wanted) / weights.squaredNorm() * weights;
        }
    }
}
}  // namespace narrows
