// SPDX-License-Identifier: MIT
#include "image/tone.h"

namespace lumi::baker
{
namespace
{

float filmic(float x)
{
    return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
}

}  // namespace

Rgb toned(ToneCurve curve, const Rgb& c)
{
    switch (curve) {
        case ToneCurve::reinhard:
            return c * (1 / (1 + luminance(c)));
        case ToneCurve::aces:
            return {filmic(c.r), filmic(c.g), filmic(c.b)};
        case ToneCurve::srgb:
            break;
    }
    return c;
}

}  // namespace lumi::baker
