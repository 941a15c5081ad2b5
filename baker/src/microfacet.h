// SPDX-License-Identifier: MIT
// The isotropic GGX distribution of microfacet normals with Smith's height-correlated shadowing. Directions are local:
// z is the surface normal, and those passed in have z > 0.
// Heitz, "Understanding the Masking-Shadowing Function", JCGT 3(2), 2014; sampling of visible normals: Heitz, "Sampling
// the GGX Distribution of Visible Normals", JCGT 7(4), 2018.
#pragma once

#include "vec3.h"
#include "warp.h"

namespace lumi::baker
{

class Ggx
{
public:
    explicit Ggx(float alpha) : alpha_(alpha) {}

    float density(const Vec3& half) const
    {
        const float a2 = alpha_ * alpha_;
        const float s = half.x * half.x + half.y * half.y + a2 * half.z * half.z;
        return a2 / (kPi * s * s);
    }

    float masking(const Vec3& w) const { return 1 / (1 + lambda(w)); }
    float masking_shadowing(const Vec3& wo, const Vec3& wi) const { return 1 / (1 + lambda(wo) + lambda(wi)); }

    // Solid-angle density of sample_half.
    float pdf_half(const Vec3& wo, const Vec3& half) const
    {
        return masking(wo) * std::max(0.0f, dot(wo, half)) * density(half) / wo.z;
    }

    Vec3 sample_half(const Vec3& wo, const Vec2& u) const
    {
        const Vec3 view = normalized({alpha_ * wo.x, alpha_ * wo.y, wo.z});
        const float across2 = view.x * view.x + view.y * view.y;
        const Vec3 right = across2 > 0 ? Vec3{-view.y, view.x, 0} / std::sqrt(across2) : Vec3{1, 0, 0};
        const Vec3 up = cross(view, right);
        const Vec2 disc = square_to_disc(u);
        const float rim = std::sqrt(std::max(0.0f, 1 - disc.x * disc.x));
        const float blend = 0.5f * (1 + view.z);
        const float y = (1 - blend) * rim + blend * disc.y;
        const float z = std::sqrt(std::max(0.0f, 1 - disc.x * disc.x - y * y));
        const Vec3 stretched = right * disc.x + up * y + view * z;
        return normalized({alpha_ * stretched.x, alpha_ * stretched.y, std::max(0.0f, stretched.z)});
    }

private:
    float lambda(const Vec3& w) const
    {
        const float tangent2 = (w.x * w.x + w.y * w.y) / (w.z * w.z);
        return 0.5f * (std::sqrt(1 + alpha_ * alpha_ * tangent2) - 1);
    }

    float alpha_;
};

}  // namespace lumi::baker
