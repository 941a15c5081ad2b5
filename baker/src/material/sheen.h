// SPDX-License-Identifier: MIT
// Fibres that stand up from a surface and catch light at grazing angles, as velvet and cloth do: facets whose normals
// tend to the horizon, with a density in proportion to sin^(1/roughness) of their angle to the surface's normal.
// Estevez & Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017 course. Their fit of the shadowing is not
// used: Smith's integral over the same density is tabulated, so that one bounce never gains energy.
#pragma once

#include "material/albedo_table.h"

namespace lumi::baker
{

inline constexpr double kMinSheenRoughness = 0.1;  // finer fibres show at the very rim only

// White fibres of one roughness, tabulated in some 20 ms. The same roughness gives the same tables, which are all that
// a path looks at.
class SheenTable
{
public:
    // roughness in [kMinSheenRoughness, 1]: low is a narrow rim, high a broad haze.
    explicit SheenTable(float roughness);

    float roughness() const { return roughness_; }
    // f·cos θi of white fibres; both directions have z > 0.
    float value(const Vec3& wo, const Vec3& wi) const;
    // The share of light that white fibres send back in all.
    float albedo(const Vec3& w) const { return albedo_.at(w); }
    float mean_albedo() const { return albedo_.mean(); }

private:
    float density(const Vec3& half) const;

    float roughness_;
    // As functions of the sine of the facets' angle, and of the cosine of a direction: the density of facets up to a
    // factor, and their area as seen from there, of one unit of surface.
    AlbedoTable profile_, seen_;
    AlbedoTable albedo_;
};

}  // namespace lumi::baker
