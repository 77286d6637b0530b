// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace narrows
{
/// Why there is no trajectory.
enum class TrajectoryFailure
{
    None,
    NotFinite,   ///< a position, time or parameter is NaN or infinite
    BadTime,     ///< times do not ascend from 0, or lie outside [1e-6, 1e6]
    BadBase,     ///< n or n_v is not above 1
    BadShape,    ///< the shape of an own-clock rise lies outside [0.01, 600], or the overlap outside [0, 1]
    BadCount,    ///< numbers of points, joints and times do not fit
    BadLimit,    ///< a limit is not positive and finite
    Pole,        ///< a term's denominator vanishes within its time, or nearly: offset too large for n and the duration
    Singular,    ///< K = 1 (or equal shapes, or windows that coincide): the via point does not determine the terms
    NoMotion,    ///< all points are equal
    Infeasible,  ///< no parameters were found that keep the limits and the overshoot asked for
};

/// "pole", "bad time", ...
std::string toText(TrajectoryFailure failure);

/// A value, or the reason why there is none.
template <class Value>
struct OrFailure
{
    /// There is a value.
    OrFailure(Value given) : value(std::move(given)) {}
    /// There is none, for this reason.
    OrFailure(TrajectoryFailure reason) : failure(reason) {}

    /// Whether there is a value.
    explicit operator bool() const { return value.has_value(); }
    /// \pre there is a value
    const Value &operator*() const { return *value; }
    /// \pre there is a value
    const Value *operator->() const { return &*value; }

    TrajectoryFailure failure = TrajectoryFailure::None;  ///< none if there is a value
    std::optional<Value> value;                           ///< empty if there is a failure
};
}  // namespace narrows
