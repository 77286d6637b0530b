// SPDX-License-Identifier: BSD-3-Clause
#include "validity/SpatialChecker.h"

#include <stdexcept>

namespace narrows
{
std::unique_ptr<SpatialChecker> makeChecker(const std::string &name, const SpatialModel &model)
{
    if (name == "analytic")
        return makeAnalyticChecker(model);
    if (name == "fcl")
        return makeFclChecker(model);
    throw std::invalid_argument("checker \"" + name + "\" is unknown; there are analytic and fcl");
}
}  // namespace narrows
