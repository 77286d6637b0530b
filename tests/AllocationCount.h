// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace narrows
{
/// What was asked of the allocator while one of these lived; at most one may live at a time. Works in programs that
/// link AllocationCount.cpp, which puts itself in front of the C library's allocator (new and Eigen's both go through
/// it). Sizes are the allocator's own, so they include what it rounds up.
class AllocationCount
{
public:
    AllocationCount();
    ~AllocationCount();
    AllocationCount(const AllocationCount &) = delete;
    AllocationCount &operator=(const AllocationCount &) = delete;

    std::size_t calls() const;    ///< blocks that were handed out
    std::size_t total() const;    ///< their bytes
    std::ptrdiff_t peak() const;  ///< most bytes that lived at once, beyond those that lived before
    std::ptrdiff_t live() const;  ///< bytes that live now, beyond those that lived before
};
}  // namespace narrows
