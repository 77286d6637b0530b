// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <ompl/util/RandomNumbers.h>

#include "kernel/Repulsion.h"
#include "planners/CurveRecipe.h"

namespace narrows
{
/// Two ends between which curves are drawn, as configurations, and which joints may make full turns on the way.
struct CurveEnds
{
    Eigen::VectorXd start;      ///< a configuration
    Eigen::VectorXd goal;       ///< a configuration
    Eigen::VectorXi turns;      ///< full turns that bring the goal nearest to the start, as the space counts joints
    std::vector<int> turnable;  ///< joints that may be turned in full, as the space counts them
};

/// Draws homotopies worth trying between two ends. What they have in common (measured in docs/hppm.md):
///
/// - Slice directions are random. A random one bends all joints, so that the arm draws itself in on its way.
/// - Strengths are balanced: W stays moderate at both ends however narrow they are, so that poles on both sides of a
///   link get opposite signs and the curve can leave between them. Signs come from the sides on which obstacles lie at
///   the narrower end, or from chance.
/// - Curves are traced from the wider end; those that begin in a throat, with the joints in it held (JointSchedule),
///   from the narrower one, in both directions.
/// - From the third attempt on, some lead to the goal with joints turned in full.
class RecipeSampler
{
public:
    /// \param model robot and obstacles \param ends configurations of this robot
    /// \param rows rows of W, each with poles and a direction of its own; >= 1
    /// \param unit the length in joint space that counts as a radian, > 0: for robots without turning joints
    RecipeSampler(std::shared_ptr<const RepulsionModel> model, const CurveEnds &ends, int rows, double unit = 1.0);

    /// The next homotopy to try. All chance comes from `random`.
    CurveRecipe next(ompl::RNG &random);

private:
    CurveRecipe draw(ompl::RNG &random);
    void turn(ompl::RNG &random, CurveRecipe &recipe) const;
    /// Whether there are joints to hold.
    bool hold(ompl::RNG &random, CurveRecipe &recipe) const;
    void aim(ompl::RNG &random, CurveRecipe &recipe) const;
    void charge(ompl::RNG &random, CurveRecipe &recipe) const;
    void balance(ompl::RNG &random, Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> strengths) const;

    std::shared_ptr<const RepulsionModel> model_;
    CurveEnds ends_;
    int rows_;
    double unit_;
    Surroundings atStart_, atGoal_;
    int drawn_ = 0;
    std::optional<CurveRecipe> reverse_;  ///< the last recipe in the other direction, if that is to be tried next
};
}  // namespace narrows
