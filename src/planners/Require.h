// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>

namespace narrows
{
/// @name What setters of parameters do with values that are out of range
/// All throw std::invalid_argument; the message begins with the parameter's name.
///@{
/// \throws std::invalid_argument with the message unless the condition holds
void require(bool condition, const std::string &message);

/// \return the value, which must lie between the two others or be one of them; NaN does not
int within(int least, int value, int most, const std::string &name);
double within(double least, double value, double most, const std::string &name);  ///< \copydoc within

/// \return the value, which must be one of the words
const std::string &oneOf(std::initializer_list<const char *> words, const std::string &value, const std::string &name);
///@}
}  // namespace narrows
