// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <utility>

#include "planners/NumberList.h"
#include "planners/Require.h"
#include "planners/VDSM.h"

namespace narrows
{
namespace
{
constexpr std::array<std::pair<const char *, ScalingMode>, 4> modes{{{"paper_nearest", ScalingMode::PaperNearest},
                                                                     {"paper_vertical", ScalingMode::PaperVertical},
                                                                     {"branch", ScalingMode::Branch},
                                                                     {"taut", ScalingMode::Taut}}};
}  // namespace

void VDSM::declareParameters()
{
    declareParam<std::string>("mode", this, &VDSM::setMode, &VDSM::getMode, "paper_nearest,paper_vertical,branch,taut");
    declareParam<double>("margin", this, &VDSM::setMargin, &VDSM::getMargin, "0.:1.:1000.");
    declareParam<std::string>("margins", this, &VDSM::setMargins, &VDSM::getMargins);
    declareParam<int>("side_search", this, &VDSM::setSideSearch, &VDSM::getSideSearch, "1:1:4096");
    declareParam<double>("step", this, &VDSM::setStep, &VDSM::getStep, "0.:1.:1000.");
    declareParam<double>("max_jump", this, &VDSM::setMaxJump, &VDSM::getMaxJump, "0.:1.:1000.");
    declareParam<int>("easing", this, &VDSM::setEasing, &VDSM::getEasing, "0:1:1000");
    declareParam<double>("retraction", this, &VDSM::setRetraction, &VDSM::getRetraction, "0.:1.:1000.");
}

void VDSM::setMode(const std::string &mode)
{
    for (const auto &[name, value] : modes)
        if (mode == name)
        {
            settings_.mode = value;
            return;
        }
    require(false, "mode is paper_nearest, paper_vertical, branch or taut, not \"" + mode + "\"");
}

std::string VDSM::getMode() const
{
    for (const auto &[name, value] : modes)
        if (settings_.mode == value)
            return name;
    return "";
}

void VDSM::setMargin(double margin)
{
    require(margin == 0.0 || (margin > 0.0 && (!chain_ || margin >= chain_->radius)),
            "margin must be 0 or at least the radius of the links");
    settings_.margin = margin;
}

void VDSM::setMargins(const std::string &factors)
{
    const Eigen::VectorXd values = parseVector(factors);
    require(values.size() > 0 && (values.array() > 0.0).all(), "margins needs factors above 0");
    settings_.margins.assign(values.data(), values.data() + values.size());
}

std::string VDSM::getMargins() const
{
    const std::vector<double> &factors = settings_.margins;
    return toText(Eigen::Map<const Eigen::RowVectorXd>(factors.data(), static_cast<Eigen::Index>(factors.size())));
}

void VDSM::setSideSearch(int count)
{
    settings_.sideSearch = within(1, count, 4096, "side_search");
}

void VDSM::setStep(double step)
{
    settings_.step = notNegative(step, "step");
}

void VDSM::setMaxJump(double jump)
{
    settings_.maxJump = notNegative(jump, "max_jump");
}

void VDSM::setEasing(int rounds)
{
    settings_.easing = within(0, rounds, 1000, "easing");
}

void VDSM::setRetraction(double depth)
{
    settings_.retraction = notNegative(depth, "retraction");
}
}  // namespace narrows
