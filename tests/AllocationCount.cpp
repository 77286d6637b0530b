// SPDX-License-Identifier: BSD-3-Clause
#include "AllocationCount.h"

#include <algorithm>
#include <cerrno>

#include <malloc.h>

#include "benchmark/AddressSanitizer.h"

namespace
{
struct Counts
{
    bool on = false;
    std::size_t calls = 0, total = 0;
    std::ptrdiff_t live = 0, peak = 0;
};
Counts counts;  // plain numbers: the allocator is at work before anything is constructed

void handedOut(void *block, std::size_t size)
{
    if (!counts.on || block == nullptr)
        return;
    ++counts.calls;
    counts.total += size;
    counts.live += static_cast<std::ptrdiff_t>(size);
    counts.peak = std::max(counts.peak, counts.live);
}

void takenBack(std::size_t size)
{
    if (counts.on)
        counts.live -= static_cast<std::ptrdiff_t>(size);
}
}  // namespace

#if NARROWS_ADDRESS_SANITIZER

extern "C"  // as in sanitizer/allocator_interface.h, which not every compiler brings along
{
    int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void *, std::size_t),
                                                  void (*)(const volatile void *));
    std::size_t __sanitizer_get_allocated_size(const volatile void *);
}

namespace
{
// The sanitizer's allocator stands where ours would, and calls back.
void handOut(const volatile void *block, std::size_t size)
{
    handedOut(const_cast<void *>(block), size);
}

void takeBack(const volatile void *block)
{
    if (block != nullptr)
        takenBack(__sanitizer_get_allocated_size(block));
}

const int installed = __sanitizer_install_malloc_and_free_hooks(handOut, takeBack);
}  // namespace

#else

extern "C"
{
    void *__libc_malloc(std::size_t);
    void *__libc_calloc(std::size_t, std::size_t);
    void *__libc_realloc(void *, std::size_t);
    void *__libc_memalign(std::size_t, std::size_t);
    void __libc_free(void *);

    void *malloc(std::size_t size)
    {
        void *block = __libc_malloc(size);
        handedOut(block, malloc_usable_size(block));
        return block;
    }

    void *calloc(std::size_t count, std::size_t size)
    {
        void *block = __libc_calloc(count, size);
        handedOut(block, malloc_usable_size(block));
        return block;
    }

    void *realloc(void *old, std::size_t size)
    {
        const std::size_t before = malloc_usable_size(old);
        void *block = __libc_realloc(old, size);
        if (block != nullptr || size == 0)
            takenBack(before);
        handedOut(block, malloc_usable_size(block));
        return block;
    }

    void *memalign(std::size_t alignment, std::size_t size)
    {
        void *block = __libc_memalign(alignment, size);
        handedOut(block, malloc_usable_size(block));
        return block;
    }

    void *aligned_alloc(std::size_t alignment, std::size_t size)
    {
        return memalign(alignment, size);
    }

    int posix_memalign(void **block, std::size_t alignment, std::size_t size)
    {
        *block = memalign(alignment, size);
        return *block != nullptr ? 0 : ENOMEM;
    }

    void free(void *block)
    {
        takenBack(malloc_usable_size(block));
        __libc_free(block);
    }
}

#endif

namespace narrows
{
AllocationCount::AllocationCount()
{
    counts = {};
    counts.on = true;
}

AllocationCount::~AllocationCount()
{
    counts.on = false;
}

std::size_t AllocationCount::calls() const
{
    return counts.calls;
}

std::size_t AllocationCount::total() const
{
    return counts.total;
}

std::ptrdiff_t AllocationCount::peak() const
{
    return counts.peak;
}

std::ptrdiff_t AllocationCount::live() const
{
    return counts.live;
}
}  // namespace narrows
