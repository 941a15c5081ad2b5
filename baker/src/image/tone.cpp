// SPDX-License-Identifier: MIT
#include "image/tone.h"

#include <algorithm>

#include "image/agx.h"

namespace lumi::baker
{
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
