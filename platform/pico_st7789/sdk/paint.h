// SPDX-License-Identifier: MIT
// How far a stack was used, from painted memory.
#pragma once

#include <stdint.h>

constexpr uint32_t kPaint = 0xC5C5C5C5;

inline void paint(uint32_t* bottom, const uint32_t* end)
{
    for (volatile uint32_t* word = bottom; word < end; ++word) *word = kPaint;
}

inline uint32_t used_bytes(const uint32_t* bottom, const uint32_t* top)
{
    const volatile uint32_t* word = bottom;
    while (word < top && *word == kPaint) ++word;
    return static_cast<uint32_t>(top - word) * sizeof(uint32_t);
}
