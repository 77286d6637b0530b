// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ompl
{
namespace base
{
}
namespace geometric
{
}
}  // namespace ompl

namespace narrows
{
namespace ob = ompl::base;
namespace og = ompl::geometric;
}  // namespace narrows
