// SPDX-License-Identifier: BSD-3-Clause
#include "kernel/SpatialRepulsionModel.h"

#include <limits>
#include <stdexcept>

#include "kernel/SpatialRepulsion.h"

namespace narrows
{
namespace
{
class SpatialRepulsionModel : public RepulsionModel
{
public:
    explicit SpatialRepulsionModel(const SpatialModel &model) : poles_(std::make_shared<const SpatialPoles>(model)) {}

    int dimension() const override { return poles_->arm().dimension(); }
    const std::vector<std::string> &groups() const override { return poles_->groups(); }
    std::size_t obstacleCount() const override { return poles_->obstacles().size(); }

    double naturalStrength(std::size_t group) const override
    {
        const double ordinary = 0.25 * poles_->arm().reach();
        return static_cast<int>(group) == poles_->limitGroup() ? 0.1 : ordinary * ordinary;
    }

    std::shared_ptr<const Repulsion> continuous(const std::vector<double> &strengths) const override
    {
        return std::make_shared<const SpatialRepulsion>(poles_, strengths);
    }

    int workspace() const override { return 3; }
    bool supportsPoints() const override { return false; }

    std::shared_ptr<const Repulsion> points(const std::vector<double> &, int) const override
    {
        throw std::invalid_argument("the paper has no singular points in space");
    }

    double clearance(const Eigen::Ref<const Eigen::VectorXd> &q, Eigen::VectorXd &gradient) const override;

private:
    std::shared_ptr<const SpatialPoles> poles_;
};

double SpatialRepulsionModel::clearance(const Eigen::Ref<const Eigen::VectorXd> &q, Eigen::VectorXd &gradient) const
{
    const SpatialArm &arm = poles_->arm();
    SpatialArm::Placement placement;
    arm.place(q, placement);
    std::vector<EndForces> forces(arm.links().size());
    double least = std::numeric_limits<double>::infinity();
    for (const SpatialPole &obstacle : poles_->obstacles())
        for (int i = 0; i < arm.linkCount(); ++i)
        {
            const SpatialTerm term =
                obstacle.clearance(placement.points[2 * i], placement.points[2 * i + 1], arm.links()[i].radius);
            if (!(term.value < least))
                continue;
            least = term.value;
            forces.assign(forces.size(), {});
            forces[i] = term.slope;
        }
    for (const auto &[first, second] : poles_->pairs())
    {
        const SpatialPairTerm term = pairClearance(arm, placement, first, second);
        if (!(term.value < least))
            continue;
        least = term.value;
        forces.assign(forces.size(), {});
        forces[first] = term.first;
        forces[second] = term.second;
    }
    gatherGradient(arm, placement, forces, gradient);
    return least;
}
}  // namespace

std::shared_ptr<const RepulsionModel> spatialRepulsionModel(std::shared_ptr<const SpatialModel> model)
{
    return std::make_shared<const SpatialRepulsionModel>(*model);
}
}  // namespace narrows
