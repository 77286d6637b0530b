// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/util/Console.h>

namespace narrows
{
/// While it lives, OMPL writes warnings and errors only. Its planners announce what they do from within solve(), which
/// would be booked as planning.
class QuietOmpl
{
public:
    QuietOmpl() { ompl::msg::setLogLevel(ompl::msg::LOG_WARN); }
    ~QuietOmpl() { ompl::msg::setLogLevel(level_); }
    QuietOmpl(const QuietOmpl &) = delete;
    QuietOmpl &operator=(const QuietOmpl &) = delete;

private:
    ompl::msg::LogLevel level_ = ompl::msg::getLogLevel();
};
}  // namespace narrows
