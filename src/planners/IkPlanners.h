// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planners/PlannerFactory.h"
#include "planners/TipFollower.h"

namespace narrows
{
/// Damped least squares (Wampler 1986; Nakamura and Hanafusa 1986). Does not see obstacles. Parameter: `lambda`.
class DampedFollower : public TipFollower
{
public:
    /// `ikdls`. \param si of a SpatialArmStateSpace \param model its arm is that of this space
    DampedFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model);

    ///@{
    /// Damping as a share of the arm's reach, in [1e-6, 1].
    /// \throws std::invalid_argument from every setter if the value is out of range
    void setLambda(double lambda);
    double getLambda() const { return lambda_; }
    ///@}

protected:
    std::unique_ptr<TipSearch> makeSearch(const TipSearchTask &task) const override;
    /// For a method that goes on from this one, under a name of its own.
    DampedFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model,
                   const std::string &name);

private:
    double lambda_ = 0.003;
};

/// Gradient projection (Liegeois 1977): damped least squares that unbends the joints and keeps the links away from
/// obstacles as far as the tip leaves it free to (kernel/PostureWish.h). Parameters: `lambda`, `null_steps`,
/// `bend_gain`, `obstacle_gain`, `influence`.
class ProjectionFollower : public DampedFollower
{
public:
    /// `ikprojection`. \param si of a SpatialArmStateSpace \param model its arm is that of this space
    ProjectionFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model);

    ///@{
    /// Iterations per waypoint that the null space is used in, at least; > 0.
    /// \throws std::invalid_argument from every setter if the value is out of range
    void setNullSteps(int steps);
    int getNullSteps() const { return nullSteps_; }
    ///@}
    ///@{
    /// Share of its bend that a joint would lose in one step, in [0, 1].
    void setBendGain(double gain);
    double getBendGain() const { return bendGain_; }
    ///@}
    ///@{
    /// Share of the missing clearance that a link would win in one step, in [0, 1].
    void setObstacleGain(double gain);
    double getObstacleGain() const { return obstacleGain_; }
    ///@}
    ///@{
    /// Distance from where on obstacles repel, >= 0; a 20th of all links' lengths if not set.
    void setInfluence(double distance);
    double getInfluence() const { return influence_; }
    ///@}

protected:
    std::unique_ptr<TipSearch> makeSearch(const TipSearchTask &task) const override;

private:
    int nullSteps_ = 3;
    double bendGain_ = 0.01;
    double obstacleGain_ = 0.5;
    double influence_;
};

/// The nearest posture that has the tip in its place, by constrained optimization with NLopt: joint limits and a margin
/// from all obstacles are constraints. Parameters: `algorithm`, `margin`.
class NloptFollower : public TipFollower
{
public:
    /// `iknlopt`. \param si of a SpatialArmStateSpace \param model its arm is that of this space
    NloptFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model);

    ///@{
    /// slsqp (Kraft 1994) or cobyla (Powell 1994; no derivatives).
    /// \throws std::invalid_argument from every setter if the value is out of range
    void setAlgorithm(const std::string &algorithm);
    std::string getAlgorithm() const { return algorithm_; }
    ///@}
    ///@{
    /// Clearance to keep, a length >= 0; a 500th of all links' lengths if not set.
    void setMargin(double margin);
    double getMargin() const { return margin_; }
    ///@}

protected:
    std::unique_ptr<TipSearch> makeSearch(const TipSearchTask &task) const override;

private:
    std::string algorithm_ = "slsqp";
    double margin_;
};

/// `ikdls`, `ikprojection` and `iknlopt`, for tip goals of robots in space.
std::vector<PlannerEntry> ikPlanners();
}  // namespace narrows
