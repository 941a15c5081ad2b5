// SPDX-License-Identifier: MIT
// Tables of how much a rough surface sends on after one bounce off a facet, by quadrature, some milliseconds each. The
// same arguments give the same table; the quadrature's error is at most 0.002.
//
// Skin: what a dielectric skin reflects; Plastic and Coated need it so that skin and body together conserve energy.
// FacetTable: what white metal reflects; the rest is light that bounced between facets more than once.
// GlassTable: what a dielectric boundary reflects and transmits, from either side.
// The tables of an Anisotropic spread depend on the azimuth as well.
// Kulla & Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017 course.
#pragma once

#include "material/albedo_table.h"
#include "material/microfacet.h"

namespace lumi::baker
{

template <class Spread>
using AlbedoOf = std::conditional_t<std::is_same_v<Spread, Isotropic>, AlbedoTable, AnisotropicAlbedo>;

template <class Spread>
class SkinOf
{
public:
    // Precondition: eta > 1 and widths > 0.
    SkinOf(float eta, const Spread& spread);

    float eta() const { return eta_; }
    const GgxOf<Spread>& facets() const { return facets_; }
    float albedo(const Vec3& w) const { return table_.at(w); }
    float albedo(float cosine) const { return table_.at(cosine); }  // for isotropic skins
    float mean_albedo() const { return table_.mean(); }

private:
    float eta_;
    GgxOf<Spread> facets_;
    AlbedoOf<Spread> table_;
};

template <class Spread>
class FacetTableOf
{
public:
    explicit FacetTableOf(const Spread& spread);

    const GgxOf<Spread>& facets() const { return facets_; }
    float lost(const Vec3& w) const { return 1 - table_.at(w); }
    float lost(float cosine) const { return 1 - table_.at(cosine); }  // for isotropic facets
    float mean_lost() const { return 1 - table_.mean(); }

private:
    GgxOf<Spread> facets_;
    AlbedoOf<Spread> table_;
};

using Skin = SkinOf<Isotropic>;
using FacetTable = FacetTableOf<Isotropic>;

class GlassTable
{
public:
    // `eta` > 1 is the index inside against that outside.
    GlassTable(float eta, float alpha);

    float eta() const { return eta_; }
    float alpha() const { return alpha_; }
    // The share that one bounce loses of light from a side; of it, the share that later bounces transmit. Chosen so
    // that the whole is reciprocal.
    float lost(bool outside, float cosine) const { return 1 - (outside ? outer_ : inner_).at(cosine); }
    float mean_lost(bool outside) const { return 1 - (outside ? outer_ : inner_).mean(); }
    float transmitted_share(bool outside) const { return outside ? outer_share_ : inner_share_; }

private:
    float eta_, alpha_;
    AlbedoTable outer_, inner_;
    float outer_share_ = 0, inner_share_ = 0;
};

}  // namespace lumi::baker
