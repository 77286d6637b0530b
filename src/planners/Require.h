// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace narrows
{
/// What setters of parameters do with values that are out of range.
/// \throws std::invalid_argument with the message unless the condition holds
inline void require(bool condition, const std::string &message)
{
    if (!condition)
        throw std::invalid_argument(message);
}
}  // namespace narrows
