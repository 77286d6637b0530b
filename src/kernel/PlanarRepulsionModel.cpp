// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/PlanarRepulsionModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "kernel/DistanceRepulsion.h"
#include "kernel/PointRepulsion.h"

namespace narrows
{
namespace
{
class PlanarRepulsionModel : public RepulsionModel
{
public:
    PlanarRepulsionModel(std::shared_ptr<const PlanarModel> model, const JointLimits &limits)
      : model_(std::move(model)), poles_(std::make_shared<const PlanarPoles>(*model_, limits))
    {
    }

    int dimension() const override { return model_->arm.dimension(); }
    const std::vector<std::string> &groups() const override { return poles_->groups(); }
    std::size_t obstacleCount() const override { return poles_->obstacles().size(); }

    double naturalStrength(std::size_t group) const override
    {
        const double ordinary = 0.25 * model_->arm.reach();
        return static_cast<int>(group) == poles_->limitGroup() ? 0.1 : ordinary * ordinary;
    }

    std::shared_ptr<const Repulsion> continuous(const std::vector<double> &strengths) const override
    {
        return std::make_shared<const DistanceRepulsion>(poles_, strengths);
    }

    int workspace() const override { return 2; }
    bool supportsPoints() const override { return PointRepulsion::supports(*model_); }

    std::shared_ptr<const Repulsion> points(const std::vector<double> &strengths, int pointsPerLink) const override
    {
        requireStrengths(strengths, groups().size(), "group of poles");
        const auto end = strengths.begin() + static_cast<std::ptrdiff_t>(model_->obstacles.size());
        for (auto strength = end; strength != strengths.end(); ++strength)
            if (*strength != 0.0)
                throw std::invalid_argument("the paper has no function for joint limits and self-collision");
        return std::make_shared<const PointRepulsion>(*model_, std::vector<double>(strengths.begin(), end),
                                                      pointsPerLink);
    }

    double clearance(ConfigurationRef q, Eigen::VectorXd &gradient) const override;
    Surroundings surroundings(ConfigurationRef q, double throat) const override;

private:
    /// The link and all that hangs on it.
    void pin(int link, std::vector<int> &joints) const;

    std::shared_ptr<const PlanarModel> model_;
    std::shared_ptr<const PlanarPoles> poles_;
};

double PlanarRepulsionModel::clearance(ConfigurationRef q, Eigen::VectorXd &gradient) const
{
    std::vector<Eigen::Vector2d> points, carried;
    std::vector<Segment> links;
    poles_->arm().place(q, points);
    poles_->segments(points, links);
    std::vector<LinkForce> forces(links.size());
    double least = std::numeric_limits<double>::infinity();
    for (const auto &obstacle : poles_->obstacles())
        for (std::size_t t = 0; t < links.size(); ++t)
        {
            const LinkTerm term = obstacle->clearance(links[t]);
            if (!(term.value < least))
                continue;
            least = term.value;
            forces.assign(links.size(), {});
            forces[t] = term.slope;
        }
    for (const SelfPair &pair : poles_->pairs())
    {
        const PairTerm term = pairClearance(links[pair.first], links[pair.second], 2.0 * model_->arm.radius());
        if (!(term.value < least))
            continue;
        least = term.value;
        forces.assign(links.size(), {});
        forces[pair.first] = term.first;
        forces[pair.second] = term.second;
    }
    gatherGradient(poles_->arm(), points, forces, carried, gradient);
    return least;
}

void PlanarRepulsionModel::pin(int link, std::vector<int> &joints) const
{
    const PlanarArm &arm = poles_->arm();
    std::vector<char> carried(static_cast<std::size_t>(arm.linkCount()), 0);
    for (int i = link; i < arm.linkCount(); ++i)
    {
        const int parent = arm.links()[static_cast<std::size_t>(i)].parent;
        carried[i] = i == link || (parent >= link && carried[parent]);
        const int joint = arm.firstAngle() + i;
        if (carried[i] && std::find(joints.begin(), joints.end(), joint) == joints.end())
            joints.push_back(joint);
    }
}

Surroundings PlanarRepulsionModel::surroundings(ConfigurationRef q, double throat) const
{
    Surroundings result = RepulsionModel::surroundings(q, throat);
    std::vector<Eigen::Vector2d> points;
    std::vector<Segment> links;
    poles_->arm().place(q, points);
    poles_->segments(points, links);
    std::vector<double> nearest(poles_->obstacles().size(), std::numeric_limits<double>::infinity());
    for (std::size_t t = 0; t < links.size(); ++t)
    {
        bool left = false, right = false;
        for (std::size_t i = 0; i < nearest.size(); ++i)
        {
            const LinkTerm term = poles_->obstacles()[i]->clearance(links[t]);
            // The slope by the link's place points away from the obstacle.
            const double lateral = -links[t].normal().dot(term.slope.force);
            const bool beside = term.value < throat && std::abs(lateral) > 0.5;
            left = left || (beside && lateral > 0.0);
            right = right || (beside && lateral < 0.0);
            if (term.value < nearest[i])
            {
                nearest[i] = term.value;
                result.sides[i] = lateral > 0.0 ? 1 : -1;
            }
        }
        if (left && right)
            pin(static_cast<int>(t), result.pinned);
    }
    return result;
}
}  // namespace

std::shared_ptr<const RepulsionModel> planarRepulsionModel(std::shared_ptr<const PlanarModel> model,
                                                           const JointLimits &limits)
{
    return std::make_shared<const PlanarRepulsionModel>(std::move(model), limits);
}
}  // namespace narrows
