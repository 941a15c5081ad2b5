// SPDX-License-Identifier: MIT
// Levels of colours as linear light, and back. The compiler evaluates the tables.
#pragma once

#include <stdint.h>

#include "lumi/detail/compiler.h"

namespace lumi::detail::generate
{

// v^(1/n), 0 < v <= 1.
constexpr double nth_root(double v, int n)
{
    double y = 1;
    for (int step = 0; step < 64; ++step) {
        double power = 1;
        for (int k = 1; k < n; ++k) power *= y;
        y += (v / power - y) / n;
    }
    return y;
}

// IEC 61966-2-1.
constexpr double light_of(double level)
{
    if (level <= 0.04045) return level / 12.92;
    const double x = (level + 0.055) / 1.055;
    return x * x * nth_root(x * x, 5);
}
constexpr double level_of(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * nth_root(light * light * light * light * light, 12) - 0.055;
}

}  // namespace lumi::detail::generate

namespace lumi::detail
{

// Linear light: white is 2^15 in the table of levels and 2^17 in sums.
inline constexpr uint32_t kWhiteQ15 = 1u << 15, kWhiteLog2 = 17, kWhiteQ17 = 1u << kWhiteLog2;
// The levels of light stand in two tables of even steps: for all light, and finer ones for what is dark.
inline constexpr uint32_t kStepsLog2 = 7, kDarkLog2 = 5;
inline constexpr uint32_t kRestBits = kWhiteLog2 - kStepsLog2;
inline constexpr int32_t kMostQ2 = 1023;

struct Levels {
    uint16_t light_q15[kMostQ2 + 1];  // of every quarter of a level
    uint16_t level_q6[2][(1 << kStepsLog2) + 1];
};

constexpr Levels make_levels()
{
    Levels levels{};
    for (uint32_t k = 0; k <= kMostQ2; ++k)
        levels.light_q15[k] = static_cast<uint16_t>(generate::light_of(k < 1020 ? k / 1020.0 : 1) * kWhiteQ15 + 0.5);
    for (uint32_t k = 0; k <= 1u << kStepsLog2; ++k) {
        const double light = static_cast<double>(k) / (1u << kStepsLog2);
        levels.level_q6[0][k] = static_cast<uint16_t>(generate::level_of(light) * 255 * 64 + 0.5);
        levels.level_q6[1][k] = static_cast<uint16_t>(generate::level_of(light / (1u << kDarkLog2)) * 255 * 64 + 0.5);
    }
    return levels;
}

inline constexpr Levels kLevels = make_levels();

// Returns the level of a sum of light: white for all that is more.
LUMI_ALWAYS_INLINE uint32_t level_q6_of(uint32_t light_q17)
{
    if (light_q17 >= kWhiteQ17) return 255 << 6;
    const uint16_t* level = kLevels.level_q6[0];
    if (light_q17 < kWhiteQ17 >> kDarkLog2) {
        light_q17 <<= kDarkLog2;
        level = kLevels.level_q6[1];
    }
    level += light_q17 >> kRestBits;
    const uint32_t rest = light_q17 & ((1u << kRestBits) - 1);
    return level[0] + (static_cast<uint32_t>(level[1] - level[0]) * rest >> kRestBits);
}

}  // namespace lumi::detail
