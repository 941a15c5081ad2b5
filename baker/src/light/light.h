// SPDX-License-Identifier: MIT
// A source of light that a path tracer can aim at.
//
// Protocol: sample() draws a direction towards the light with a solid-angle density; the caller tests visibility up to
// `distance`. The light's own pdf for a direction found by other means belongs to the concrete class, as what is known
// of the hit differs. u_select picks among the light's parts, u a point on the part.
#pragma once

#include <limits>

#include "math/vec3.h"

namespace lumi::baker
{

struct LightSample {
    Vec3 direction;
    float distance = 0;
    Rgb radiance;
    float pdf = 0;  // 0: nothing to see from there
    // The light has no size: `radiance` stands for irradiance, and no other sampling can find it.
    bool dirac = false;
};

// Veach's power heuristic with exponent 2: the weight of light that was found by one of two densities.
inline float power_weight(float own_pdf, float other_pdf)
{
    if (!(own_pdf > 0)) return 0;
    const float ratio = other_pdf / own_pdf;
    return 1 / (1 + ratio * ratio);
}

class Light
{
public:
    virtual ~Light() = default;
    virtual float power() const = 0;  // a measure for choosing among lights; 0 = dark
    virtual LightSample sample(const Vec3& from, float u_select, const Vec2& u) const = 0;
};

}  // namespace lumi::baker
