// SPDX-License-Identifier: MIT
#include "lumi/linear_light.h"

#include "math/generate.h"

namespace lumi
{
namespace
{

// x^2.4 = x²·(x²)^(1/5) for x in (0, 1].
constexpr double power_2_4(double x)
{
    const double square = x * x;
    double fifth = 1;
    for (int i = 0; i < 64; ++i) {
        const double fourth = fifth * fifth * fifth * fifth;
        fifth = (4 * fifth + square / fourth) / 5;
    }
    return square * fifth;
}

constexpr LinearLight make_light()
{
    LinearLight t{};
    for (int k = 0; k < 256; ++k) {
        const double v = k / 255.0;
        const double light = v <= 0.04045 ? v / 12.92 : power_2_4((v + 0.055) / 1.055);
        t.at[k] = static_cast<uint16_t>(light * 65535 + 0.5);
    }
    return t;
}

// 2^16/n for n = 0 .. 4.
constexpr uint32_t kShareQ16[5] = {0, 65536, 32768, 21845, 16384};

}  // namespace

constexpr LinearLight kLinearLight = make_light();

uint8_t encoded_level(uint32_t light)
{
    // The last level whose light is not above: eight halvings.
    uint32_t level = 0;
    for (uint32_t step = 128; step > 0; step >>= 1) {
        if (kLinearLight.at[level + step] <= light) level += step;
    }
    if (level < 255 && kLinearLight.at[level + 1] - light < light - kLinearLight.at[level]) ++level;
    return static_cast<uint8_t>(level);
}

Rgb8 LightMixture::colour() const
{
    // Sums are at most 4·65,535: in Q14 their product with a share stays below 2^32.
    const auto level = [&](uint32_t sum) { return encoded_level((sum * (kShareQ16[weight_] >> 2)) >> 14); };
    return {level(r_), level(g_), level(b_)};
}

}  // namespace lumi
