// SPDX-License-Identifier: MIT
#include "image/tone.h"

#include <algorithm>
#include <array>

namespace lumi::baker
{

namespace
{

std::array<float, 256> make_decode_table()
{
    std::array<float, 256> table{};
    for (size_t k = 0; k < table.size(); ++k) table[k] = static_cast<float>(srgb_linear(static_cast<double>(k) / 255));
    return table;
}

uint8_t encode_channel(float linear)
{
    return static_cast<uint8_t>(srgb_encode_unit(linear) * 255 + 0.5f);
}

}  // namespace

double srgb_linear(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Rgb srgb_linear(const Rgb& encoded)
{
    const auto linear = [](float v) { return static_cast<float>(srgb_linear(static_cast<double>(v))); };
    return {linear(encoded.r), linear(encoded.g), linear(encoded.b)};
}

double srgb_encoded(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

float srgb_decode(uint8_t encoded)
{
    static const std::array<float, 256> kTable = make_decode_table();
    return kTable[encoded];
}

float srgb_encode_unit(float linear)
{
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 1;
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

Rgb8 srgb_encode(const Rgb& linear)
{
    return {encode_channel(linear.r), encode_channel(linear.g), encode_channel(linear.b)};
}

namespace
{

float filmic(float light)
{
    const float x = std::max(light, 0.0f);
    return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
}

Rgb agx_toned(const Rgb& c)
{
    const Rgb m = agx::mixed(c);
    return agx::unmixed({agx::curve(m.r), agx::curve(m.g), agx::curve(m.b)});
}

}  // namespace

Rgb toned(ToneCurve curve, const Rgb& c)
{
    switch (curve) {
        case ToneCurve::reinhard:
            return c * (1 / (1 + std::max(luminance(c), 0.0f)));
        case ToneCurve::aces:
            return {filmic(c.r), filmic(c.g), filmic(c.b)};
        case ToneCurve::agx:
            return agx_toned(c);
        case ToneCurve::srgb:
            break;
    }
    return c;
}

}  // namespace lumi::baker
