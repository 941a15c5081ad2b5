// SPDX-License-Identifier: MIT
// The GGX distribution of microfacet normals with Smith's height-correlated shadowing. Directions are local: z is the
// surface normal, and those passed in have z > 0.
// Heitz, "Understanding the Masking-Shadowing Function", JCGT 3(2), 2014; sampling of visible normals: Heitz, "Sampling
// the GGX Distribution of Visible Normals", JCGT 7(4), 2018.
#pragma once

#include "math/vec3.h"
#include "math/warp.h"

namespace lumi::baker
{

// How far the facets' slopes spread: alike in every direction, or along x and along y. The first costs what it would
// cost without the second.
struct Isotropic {
    // NOLINTNEXTLINE(google-explicit-constructor): the width is the whole of it
    Isotropic(float a) : alpha(a) {}

    Vec3 stretched(const Vec3& v) const { return {alpha * v.x, alpha * v.y, v.z}; }
    float area() const { return alpha * alpha; }
    // Squared distance from the axis, in units of the spread's mean.
    static float across2(const Vec3& v) { return v.x * v.x + v.y * v.y; }
    float slope2(const Vec3& v) const { return alpha * alpha * (across2(v) / (v.z * v.z)); }

    float alpha;
};

struct Anisotropic {
    Vec3 stretched(const Vec3& v) const { return {alpha_x * v.x, alpha_y * v.y, v.z}; }
    float area() const { return alpha_x * alpha_y; }
    float across2(const Vec3& v) const { return v.x * v.x * (alpha_y / alpha_x) + v.y * v.y * (alpha_x / alpha_y); }
    float slope2(const Vec3& v) const { return (square(alpha_x * v.x) + square(alpha_y * v.y)) / (v.z * v.z); }

    float alpha_x, alpha_y;

private:
    static float square(float x) { return x * x; }
};

template <class Spread>
class GgxOf
{
public:
    explicit GgxOf(const Spread& spread) : spread_(spread) {}

    float density(const Vec3& half) const
    {
        const float a2 = spread_.area();
        const float s = spread_.across2(half) + a2 * half.z * half.z;
        return a2 / (kPi * s * s);
    }

    float masking(const Vec3& w) const { return 1 / (1 + lambda(w)); }
    float masking_shadowing(const Vec3& wo, const Vec3& wi) const { return 1 / (1 + lambda(wo) + lambda(wi)); }

    // Returns the solid-angle density of sample_half.
    float pdf_half(const Vec3& wo, const Vec3& half) const
    {
        return masking(wo) * std::max(0.0f, dot(wo, half)) * density(half) / wo.z;
    }

    Vec3 sample_half(const Vec3& wo, const Vec2& u) const
    {
        const Vec3 view = normalized(spread_.stretched(wo));
        const float across2 = view.x * view.x + view.y * view.y;
        const Vec3 right = across2 > 0 ? Vec3{-view.y, view.x, 0} / std::sqrt(across2) : Vec3{1, 0, 0};
        const Vec3 up = cross(view, right);
        const Vec2 disc = square_to_disc(u);
        const float rim = std::sqrt(std::max(0.0f, 1 - disc.x * disc.x));
        const float blend = 0.5f * (1 + view.z);
        const float y = (1 - blend) * rim + blend * disc.y;
        const float z = std::sqrt(std::max(0.0f, 1 - disc.x * disc.x - y * y));
        const Vec3 visible = right * disc.x + up * y + view * z;
        return normalized(spread_.stretched({visible.x, visible.y, std::max(0.0f, visible.z)}));
    }

private:
    float lambda(const Vec3& w) const { return 0.5f * (std::sqrt(1 + spread_.slope2(w)) - 1); }

    Spread spread_;
};

using Ggx = GgxOf<Isotropic>;

}  // namespace lumi::baker
