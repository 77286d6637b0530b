// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Whether the address sanitizer is compiled in, as 0 or 1; gcc and clang have each a way of their own to say so.
#if defined(__SANITIZE_ADDRESS__)
#define NARROWS_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define NARROWS_ADDRESS_SANITIZER 1
#endif
#endif
#ifndef NARROWS_ADDRESS_SANITIZER
#define NARROWS_ADDRESS_SANITIZER 0
#endif
