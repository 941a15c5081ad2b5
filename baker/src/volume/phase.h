// SPDX-License-Identifier: MIT
// Into which directions a medium scatters: L. Henyey and J. Greenstein, "Diffuse radiation in the galaxy", 1941.
// Cosines are between the ways of the light before and after: 1 is straight on.
#pragma once

#include "math/frame.h"
#include "math/warp.h"

namespace lumi::baker
{

class Phase
{
public:
    // g: the mean cosine, between -1 and 1 and neither of them; 0 scatters alike into all directions.
    explicit Phase(float g = 0) : g_(g) {}

    // Per solid angle; both the value and the density of sample().
    float density(float cosine) const
    {
        const float d = 1 + g_ * g_ - 2 * g_ * cosine;
        return (1 - g_ * g_) / (4 * kPi * d * std::sqrt(d));
    }

    Vec3 sample(const Vec3& way, const Vec2& u) const { return Frame(way).to_world(direction_at(cosine_of(u.x), u.y)); }

    float anisotropy() const { return g_; }

private:
    float cosine_of(float u) const
    {
        constexpr float kEven = 1e-3f;  // below it the other formula loses its digits; this one is off by less than 2·g
        if (std::abs(g_) < kEven) return 1 - 2 * u;
        const float q = (1 - g_ * g_) / (1 + g_ - 2 * g_ * u);
        return std::clamp((1 + g_ * g_ - q * q) / (2 * g_), -1.0f, 1.0f);
    }

    float g_;
};

}  // namespace lumi::baker
