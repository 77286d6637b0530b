// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/util/Console.h>

namespace narrows
{
/// While it lives, OMPL writes nothing below a level: by default warnings and errors only. Its planners announce what
/// they do from within solve(), which would be booked as planning.
class QuietOmpl
{
public:
    explicit QuietOmpl(ompl::msg::LogLevel level = ompl::msg::LOG_WARN) { ompl::msg::setLogLevel(level); }
    ~QuietOmpl() { ompl::msg::setLogLevel(level_); }
    QuietOmpl(const QuietOmpl &) = delete;
    QuietOmpl &operator=(const QuietOmpl &) = delete;

private:
    ompl::msg::LogLevel level_ = ompl::msg::getLogLevel();
};
}  // namespace narrows
