// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks a function whose loops are worth compiling for several generations of vector instructions; the program takes
/// the best that its processor knows. Plain arrays only: Eigen's types change their alignment with the instructions.
/// Files that use it are compiled without contraction (no fused multiply-add), so that all versions give equal bits,
/// unless nothing depends on them.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__)
#define NARROWS_MULTIVERSION __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
/// Does the processor take the longest of them, of 64 bytes?
#define NARROWS_HAS_LONG_VECTORS                                                                                      \
    (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") && \
     __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
#else
#define NARROWS_MULTIVERSION
#define NARROWS_HAS_LONG_VECTORS false
#endif
