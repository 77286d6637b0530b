// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>

namespace narrows
{
/// What setters of parameters do with values that are out of range.
/// \throws std::invalid_argument with the message unless the condition holds
void require(bool condition, const std::string &message);

/// The value, which must lie between the two others or be one of them; NaN does not.
/// \throws std::invalid_argument with the parameter's name and the range
int within(int least, int value, int most, const std::string &name);
/// The same for numbers that need not be whole. \throws std::invalid_argument
double within(double least, double value, double most, const std::string &name);
/// The value, which must be finite and not negative. \throws std::invalid_argument with the parameter's name
double notNegative(double value, const std::string &name);

/// The value, which must be one of the words.
/// \throws std::invalid_argument with the parameter's name and the words
const std::string &oneOf(std::initializer_list<const char *> words, const std::string &value, const std::string &name);
}  // namespace narrows
