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
    DampedFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model);

    /// \throws std::invalid_argument from every setter if the value is out of range
    void setLambda(double lambda);  ///< damping as a share of the arm's reach, in [1e-6, 1]
    double getLambda() const { return lambda_; }

protected:
    std::unique_ptr<TipSearch> makeSearch(const TipSearchTask &task) const override;
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
    ProjectionFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model);

    void setNullSteps(int steps);  ///< iterations per waypoint that the null space is used in, at least; > 0
    int getNullSteps() const { return nullSteps_; }
    void setBendGain(double gain);  ///< in [0, 1]
    double getBendGain() const { return bendGain_; }
    void setObstacleGain(double gain);  ///< in [0, 1]
    double getObstacleGain() const { return obstacleGain_; }
    void setInfluence(
        double distance);  ///< from where on obstacles repel, >= 0; a 20th of all links' lengths if not set
    double getInfluence() const { return influence_; }

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
    NloptFollower(const ob::SpaceInformationPtr &si, std::shared_ptr<const SpatialModel> model);

    void setAlgorithm(const std::string &algorithm);  ///< slsqp (Kraft 1994) | cobyla (Powell 1994; no derivatives)
    std::string getAlgorithm() const { return algorithm_; }
    void setMargin(double margin);  ///< clearance to keep, >= 0; a 500th of all links' lengths if not set
    double getMargin() const { return margin_; }

protected:
    std::unique_ptr<TipSearch> makeSearch(const TipSearchTask &task) const override;

private:
    std::string algorithm_ = "slsqp";
    double margin_;
};

/// `ikdls`, `ikprojection` and `iknlopt`, for tip goals of robots in space.
std::vector<PlannerEntry> ikPlanners();
}  // namespace narrows
