// SPDX-License-Identifier: BSD-3-Clause
#include "validity/PlanarChecker.h"

#include <stdexcept>

namespace narrows
{
std::unique_ptr<PlanarChecker> makeChecker(const std::string &name, const PlanarModel &model)
{
    if (name == "analytic")
        return makeAnalyticChecker(model);
    if (name == "fcl")
        return makeFclChecker(model);
    throw std::invalid_argument("checker \"" + name + "\" is unknown; there are analytic and fcl");
}
}  // namespace narrows
