// SPDX-License-Identifier: MIT
// The material of a triangle, and how MTL's terms become it.
//
// MTL                      here
// Pr or Pm                 metalness Pm, alpha = Pr²; a dielectric skin over Kd, whose body is as rough as the skin
// Ks                       the skin's strength: from straight above it reflects 0.08·Ks, as Blender's "Specular" does,
//                          so that 0.5 is the index 1.5. Only the largest component counts. Black: no skin. Not given:
//                          a skin of index Ni (1.5 if Ni <= 1) beside Pr or Pm, otherwise none
// illum 3, Kd black        a metal of colour Ks, unless Pr or Pm says what it is
// Ns                       alpha = √(2/(Ns+2)), the GGX width whose peak falls off like Phong's lobe (Walter et al.,
//                          "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, section 5.2)
// illum 4, 6, 7, 9         with Ni > 1: glass, smooth unless Pr > 0, that lets Tf through along one unit of the OBJ.
//                          Not if Tf is black, nor for illum 4 and 9 if d < 1 and there is no Tf: some exporters write
//                          that for thin, see-through paint
// Pr and Tf >= 0.5         with Ni > 1: glass too; so Blender writes transmission
// aniso, anisor            facets of metal and skin that spread wider along the tangent and narrower across, as brushed
//                          metal's: by 1/√(1 - 0.9·aniso) and its inverse (Burley, "Physically Based Shading at
//                          Disney", SIGGRAPH 2012 course). The tangent is the direction of growing u, turned by anisor
//                          of a turn counterclockwise
// Pc, Pcr                  a clear coat of roughness Pcr that covers a quarter of the surface where Pc is 1
// Ps                       fine white fibres on top of all that, on a sixth of the surface where Ps is 1; not on glass.
//                          Quarter and sixth are what clearcoat and sheen of Blender's Principled shader amount to
// d, 1-Tr                  opacity: the share of light that does not pass straight through
// Ke                       radiance emitted from both sides
// map_Kd, map_Ke, map_Pr, map_Pm, map_Ps, map_d, and of metals map_Ks: times their number, or 1 where that is not given
// norm, map_Bump           a normal map; a grey picture is a height map
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "image/texture.h"
#include "material/bsdf.h"

namespace lumi::baker
{

// Facets that spread wider along one direction than across it: by 1/aspect, and by aspect. Burley, "Physically Based
// Shading at Disney", SIGGRAPH 2012 course, section 5.4.

inline constexpr float kMostStretch = 0.9f;

// `anisotropy` lies in [0, 1].
inline float aspect_of(float anisotropy)
{
    return std::sqrt(1 - kMostStretch * anisotropy);
}

// The anisotropy of facets that are `ratio` times as wide along as across, which is 1 or more; 10 and more are 1.
inline float anisotropy_of(float ratio)
{
    return std::min((1 - 1 / ratio) / kMostStretch, 1.0f);
}

inline constexpr int32_t kNoTexture = -1;
inline constexpr float kMinAlpha = 0.01f;  // sharper facets than this no field resolves, and binary32 begins to suffer
inline constexpr float kDefaultIndex = 1.5f;
// Diamond's index is 2.4, germanium's is 4. Closer to 1, facets and directions of glass can no longer be told apart.
inline constexpr double kMinIndex = 1.01, kMaxIndex = 4;
inline constexpr double kLeastLength = 1e-9;           // a way through glass is so long
inline constexpr float kDefaultSheenRoughness = 0.3f;  // cloth

// A picture on a surface: read where its coordinates lie once they are scaled, turned and moved, in this order.
struct TextureSlot {
    int32_t texture = kNoTexture;
    Vec2 scale = {1, 1}, offset;
    Vec2 turn = {1, 0};  // cosine and sine of an angle counterclockwise
    std::array<Wrap, 2> wrap = {Wrap::repeat, Wrap::repeat};
    bool takes_second_uvs = false;

    bool used() const { return texture != kNoTexture; }
    Vec2 place(const Vec2& uv) const
    {
        const float u = uv.x * scale.x, v = uv.y * scale.y;
        return {turn.x * u - turn.y * v + offset.x, turn.y * u + turn.x * v + offset.y};
    }
};

struct TextureSlots {
    TextureSlot base, emission, roughness, metalness, opacity, normal, sheen, transmission;
};
// Lists all of them.
inline constexpr std::array kTextureSlots = {
    &TextureSlots::base,    &TextureSlots::emission, &TextureSlots::roughness, &TextureSlots::metalness,
    &TextureSlots::opacity, &TextureSlots::normal,   &TextureSlots::sheen,     &TextureSlots::transmission};
static_assert(sizeof(TextureSlots) == kTextureSlots.size() * sizeof(TextureSlot), "a slot is missing");

// Holds a material's numbers at one point, with its textures.
struct PointValues {
    Rgb base;
    float metalness, roughness;
    bool outside;  // the viewer is on the side that the triangle's winding faces
    float sheen;
    float transmission = 1;  // of glass and panes
    Rgb tint = grey(1);      // light gets this colour where it crosses the boundary of glass
};

// A property that a user can set has a member here, its row in kMaterialParameters, and its use in one lobe.
struct MaterialNumbers {
    Rgb base = grey(0.6f);  // reflectance of the diffuse body, or of the metal at normal incidence
    Rgb emission;
    Rgb sheen_colour = grey(1);
    Rgb transmittance = grey(1);  // glass lets this through along `transmittance_length`
    float metalness = 0;
    float alpha = 1;  // GGX width
    float index = kDefaultIndex;
    float opacity = 1;
    float anisotropy = 0, anisotropy_turns = 0;
    float coat = 0, coat_alpha = kMinAlpha;
    float sheen = 0, sheen_roughness = kDefaultSheenRoughness;
    float transmittance_length = 1;
};

// How the numbers of files become those of a material.
enum class Stated : uint8_t {
    plainly,
    as_roughness,  // the width is its square
    as_turns,      // in MTL; degrees in scene files
};

struct MaterialParameter {
    const char* json;  // a material's member in scene files; null: not there, or within "glass"
    const char* mtl;   // keyword of MTL, or null
    double low, high;  // other values are refused in scene files, and clamped with a warning in MTL
    std::variant<Rgb MaterialNumbers::*, float MaterialNumbers::*> member;
    Stated stated = Stated::plainly;
    bool shines = false;  // who sets it in a scene file asks for a specular skin and a body as rough as that
};

// In the order in which scenes are fingerprinted: new rows go to the end.
inline constexpr MaterialParameter kMaterialParameters[] = {
    {"colour", "Kd", 0, 1, &MaterialNumbers::base},
    {"emission", "Ke", 0, kMaxRadiance, &MaterialNumbers::emission},
    {"sheen_colour", nullptr, 0, 1, &MaterialNumbers::sheen_colour},
    {nullptr, "Tf", 0, 1, &MaterialNumbers::transmittance},
    {"metalness", "Pm", 0, 1, &MaterialNumbers::metalness, Stated::plainly, true},
    {"roughness", "Pr", 0, 1, &MaterialNumbers::alpha, Stated::as_roughness, true},
    {"index", "Ni", kMinIndex, kMaxIndex, &MaterialNumbers::index},
    {"opacity", "d", 0, 1, &MaterialNumbers::opacity},
    {"anisotropy", "aniso", 0, 1, &MaterialNumbers::anisotropy, Stated::plainly, true},
    {"anisotropy_rotation", "anisor", -1, 1, &MaterialNumbers::anisotropy_turns, Stated::as_turns},
    {"coat", "Pc", 0, 1, &MaterialNumbers::coat},
    {"coat_roughness", "Pcr", 0, 1, &MaterialNumbers::coat_alpha, Stated::as_roughness},
    {"sheen", "Ps", 0, 1, &MaterialNumbers::sheen},
    {"sheen_roughness", nullptr, kMinSheenRoughness, 1, &MaterialNumbers::sheen_roughness},
    {nullptr, nullptr, kLeastLength, std::numeric_limits<float>::max(), &MaterialNumbers::transmittance_length},
};

struct Material : MaterialNumbers {
    std::string name;
    std::string state;        // the label of the light state that it shines in; may be empty
    bool specular = false;    // a dielectric skin where the surface is not metal
    bool rough_body = false;  // the diffuse body is as rough as its skin (DiffuseShape); otherwise Lambert's
    bool glass = false;       // clear inside; the triangles' winding faces outwards
    bool thin = false;        // a pane: what lies behind shows through in place, coloured once by tint and base picture
    bool blends = false;      // soft edges of the picture of opacity stay soft in fields
    // For glass and panes: the share of light that is not metal's and enters, where the rest is plastic, and the colour
    // of light that passes, in at one side and out at the other.
    float transmission = 1;
    Rgb tint = grey(1);
    TextureSlots maps;

    // Clamps what must be in range and derives what is derived. Call after filling in or changing.
    void finish();

    bool emits() const { return !is_black(emission); }
    // Whether it looks different when turned in its plane.
    bool brushed() const { return !brushed_skins.empty() || !brushed_facets.empty(); }
    // Whether what light it reflects hardly depends on the view, where its body has this colour: what a dull skin
    // reflects, some 4 % straight on and more aslant, shows unless the body is bright.
    bool is_matt(const Rgb& body) const
    {
        constexpr float kRough = 0.64f;  // a roughness of 0.8
        constexpr float kBright = 0.6f;
        const bool is_rough = alpha >= kRough && !maps.roughness.used();
        const bool is_dull = !specular || (is_rough && max_component(body) >= kBright);
        return is_dull && !glass && !thin && metalness == 0 && !maps.metalness.used() && coat == 0 && sheen == 0;
    }
    bool may_pass() const { return opacity < 1 || maps.opacity.used() || thin; }
    // Whether glass is something else, too, at some points.
    bool is_mixed_glass() const { return glass && (transmission < 1 || maps.transmission.used() || metalness > 0); }
    // The share and colour of light that a pane lets straight through, at this cosine to its normal. `picture` is the
    // colour of its base picture there.
    Rgb through_pane(const PointValues& at, const Rgb& picture, float cosine) const;
    // The share of light that is left after a way through the glass.
    Rgb absorbed(float distance) const;
    // A partly metallic surface is metal with probability metalness, and what is left of glass with probability
    // transmission: u.
    Bsdf bsdf(const PointValues& at, float u) const;
    // The colour of what that has below its skin: of a pane, what is left by the light that passes.
    Rgb body(const PointValues& at, float u) const;

    // Made by finish(), one for each step of roughness; just one where no texture changes it. Empty if not needed.
    // Materials share what is alike.
    std::vector<std::shared_ptr<const Skin>> skins;
    std::vector<std::shared_ptr<const FacetTable>> facets;
    std::vector<std::shared_ptr<const SkinOf<Anisotropic>>> brushed_skins;  // in place of the other two
    std::vector<std::shared_ptr<const FacetTableOf<Anisotropic>>> brushed_facets;
    std::vector<std::shared_ptr<const GlassTable>> frosts;  // of glass; null where it is smooth
    std::shared_ptr<const Skin> coat_skin;
    std::shared_ptr<const SheenTable> fibres;
    Rgb absorption;  // glass takes this out, per length
};

float alpha_from_phong_exponent(float exponent);
float alpha_from_roughness(float roughness);
// The index of refraction of what reflects the share f0 from straight above.
float index_from_reflectance(float f0);
// A file's number as a material keeps it.
float stated(const MaterialParameter& parameter, float value);

}  // namespace lumi::baker
