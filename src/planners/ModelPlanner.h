// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include <ompl/base/Planner.h>

#include "kernel/PlanarModel.h"
#include "spaces/Ompl.h"

namespace narrows
{
/// A planner that sees robot and obstacles, not only whether states are free, and that says why it stopped.
class ModelPlanner : public ob::Planner
{
public:
    ModelPlanner(const ob::SpaceInformationPtr &si, std::shared_ptr<const PlanarModel> model, const std::string &name)
      : ob::Planner(si, name), model_(std::move(model))
    {
    }

    /// Why no exact solution has been found, in one word (wrong_root, turned_back, ...); empty if one has, or after
    /// clear().
    const std::string &reason() const { return reason_; }

    /// Machine-free measures of the work since clear(), by name (homotopy_evaluations, hyperspheres, rejected_steps,
    /// ...).
    const std::map<std::string, double> &measures() const { return measures_; }

protected:
    std::shared_ptr<const PlanarModel> model_;
    std::string reason_;
    std::map<std::string, double> measures_;
};
}  // namespace narrows
