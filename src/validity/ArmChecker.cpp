// SPDX-License-Identifier: BSD-3-Clause
#include "validity/ArmChecker.h"

#include "validity/LinkwiseChecker.h"
#include "validity/PlanarChecker.h"
#include "validity/PlanarScreen.h"
#include "validity/SpatialChecker.h"

namespace narrows
{
namespace
{
/// Looks at many configurations side by side first, and one by one at those that this leaves open.
class ScreenedChecker final : public LinkwiseChecker<PlanarArm>
{
public:
    explicit ScreenedChecker(const PlanarModel &model)
      : LinkwiseChecker(model.arm, makeAnalyticChecker(model), model.selfCollision), screen_(model, pairs())
    {
    }

    void areFree(ConfigurationRows configurations, std::vector<char> &free) const override
    {
        if (configurations.rows() < worthScreening || !lanes::areFast())
            return LinkwiseChecker::areFree(configurations, free);
        thread_local std::vector<Finding> findings;
        thread_local Eigen::VectorXd q;
        screen_.examine(configurations, findings);
        free.resize(findings.size());
        for (std::size_t k = 0; k < findings.size(); ++k)
            free[k] =
                findings[k] == Finding::Unsure ? isFree(q = configurations.row(k)) : findings[k] == Finding::Clear;
    }

private:
    static constexpr Eigen::Index worthScreening = 3;

    PlanarScreen screen_;
};
}  // namespace

void ArmChecker::areFree(ConfigurationRows configurations, std::vector<char> &free) const
{
    free.resize(static_cast<std::size_t>(configurations.rows()));
    thread_local Eigen::VectorXd q;
    for (Eigen::Index k = 0; k < configurations.rows(); ++k)
        free[k] = isFree(q = configurations.row(k));
}

std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const PlanarModel &model)
{
    if (name == "analytic")
        return std::make_unique<ScreenedChecker>(model);
    return std::make_unique<LinkwiseChecker<PlanarArm>>(model.arm, makeChecker(name, model), model.selfCollision);
}

std::unique_ptr<ArmChecker> makeArmChecker(const std::string &name, const SpatialModel &model)
{
    return std::make_unique<LinkwiseChecker<SpatialArm>>(model.arm, makeChecker(name, model), model.selfCollision);
}
}  // namespace narrows
