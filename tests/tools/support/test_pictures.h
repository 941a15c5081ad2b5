// SPDX-License-Identifier: MIT
// Pictures with known content for tests of the metrics.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "image/picture.h"

namespace lumi::tools::test
{

inline uint8_t byte_from(double value)
{
    return static_cast<uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

// A grey picture of the function's values at the pixel centres, in pixels from the picture's centre.
inline Picture sampled(int width, int height, const std::function<double(double, double)>& value)
{
    Picture picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            std::fill_n(picture.pixel(x, y), 3, byte_from(value(x + 0.5 - width / 2.0, y + 0.5 - height / 2.0)));
    return picture;
}

// Something like a rendered object: a shaded ball with a stripe texture and a soft rim before a dark ground. Values
// stay within 20 .. 220, so that changes of up to 20 grey levels do not clip.
inline double ball(double x, double y)
{
    constexpr double kGround = 30, kRadius = 45, kRim = 1.5;
    const double distance = std::hypot(x, y);
    const double inside = std::clamp((kRadius - distance) / kRim + 0.5, 0.0, 1.0);
    const double shade = 150 - 0.6 * x - 0.8 * y;
    const double stripes = 25 * std::sin(0.35 * x + 0.2 * y) + 15 * std::sin(0.9 * y - 0.1 * x);
    return kGround + inside * (shade + stripes - kGround);
}

inline Picture ball_picture(double shift_x = 0, double turn_rad = 0, double gain = 1, double offset = 0)
{
    const double c = std::cos(turn_rad), s = std::sin(turn_rad);
    return sampled(128, 128, [=](double x, double y) {
        return offset + gain * ball(c * (x - shift_x) - s * y, s * (x - shift_x) + c * y);
    });
}

inline Picture with_noise(Picture picture, double sigma, unsigned seed = 1)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, sigma);
    for (uint8_t& value : picture.rgb) value = byte_from(value + normal(random));
    return picture;
}

// Mean over (2r+1)² pixels, clamped at the border.
inline Picture blurred(const Picture& picture, int radius)
{
    Picture result = picture;
    const int side = 2 * radius + 1;
    for (int y = 0; y < picture.height_px; ++y)
        for (int x = 0; x < picture.width_px; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int dy = -radius; dy <= radius; ++dy)
                    for (int dx = -radius; dx <= radius; ++dx)
                        sum += picture.pixel(std::clamp(x + dx, 0, picture.width_px - 1),
                                             std::clamp(y + dy, 0, picture.height_px - 1))[channel];
                result.pixel(x, y)[channel] = static_cast<uint8_t>((sum + side * side / 2) / (side * side));
            }
    return result;
}

inline Picture random_picture(int width, int height, unsigned seed)
{
    std::mt19937 random(seed);
    Picture picture(width, height);
    for (uint8_t& value : picture.rgb) value = static_cast<uint8_t>(random() >> 24);
    return picture;
}

}  // namespace lumi::tools::test
