// SPDX-License-Identifier: MIT
#include "model/gltf/materials.h"

#include <algorithm>
#include <cmath>

#include "material/material.h"
#include "model/gltf/extensions.h"
#include "model/gltf/specular_glossiness.h"
#include "model/gltf/textures.h"

namespace lumi::baker
{
namespace
{

float float_member(const JsonValue& value, const char* name, double fallback)
{
    return float_of(number_member(value, name, fallback));
}

// Makes one material.
class SurfaceMaker
{
public:
    SurfaceMaker(const GltfModel& model, const GltfMaterial& gltf, GltfTextures& textures, Losses& losses)
        : model_(model), gltf_(gltf), textures_(textures), losses_(losses)
    {
    }

    GltfSurface make()
    {
        m_.name = gltf_.name;
        GltfTextureUse base = gltf_.base_texture;
        Rgb colour = gltf_.base;
        take_metal_and_roughness();
        take_specular_glossiness(colour, base);
        take_skin();
        take_anisotropy();
        take_base(colour, base);
        take_emission();
        take_layers();
        if (extension("KHR_materials_unlit")) make_unlit(colour);
        take_alpha(base);
        take_transmission(colour);
        normal_slot();
        note_losses();
        m_.finish();
        return std::move(result_);
    }

private:
    const JsonValue* extension(const char* name) const
    {
        const auto found = gltf_.extensions.find(name);
        return found == gltf_.extensions.end() ? nullptr : &found->second;
    }

    // The slot of a picture that is found.
    TextureSlot slot(const GltfTextureUse& use, int32_t texture)
    {
        if (texture == kNoTexture) return {};
        if (use.far_off)
            losses_.add(
                "picture(s) are moved or scaled by more than a million, which is left out; mend their transform");
        std::vector<int32_t>& sets = result_.uv_sets;
        const auto found = std::find(sets.begin(), sets.end(), use.uv_set);
        const size_t place = static_cast<size_t>(found - sets.begin());
        constexpr size_t kSets = 2;
        if (place == kSets) {
            losses_.add(
                "picture(s) take a third set of texture coordinates and are left out; use two UV maps a material");
            return {};
        }
        if (found == sets.end()) sets.push_back(use.uv_set);
        TextureSlot slot = slot_of(use, texture);
        slot.takes_second_uvs = place == 1;
        return slot;
    }

    void take_metal_and_roughness()
    {
        m_.metalness = std::clamp(gltf_.metalness, 0.0f, 1.0f);
        m_.alpha = alpha_from_roughness(std::clamp(gltf_.roughness, 0.0f, 1.0f));
        m_.specular = true;
        const GltfTextureUse& use = gltf_.metal_rough_texture;
        if (m_.metalness > 0) m_.maps.metalness = slot(use, textures_.find(use, PictureUse::blue));
        m_.maps.roughness = slot(use, textures_.find(use, PictureUse::data));
    }

    void take_specular_glossiness(Rgb& colour, GltfTextureUse& base)
    {
        const JsonValue* e = extension("KHR_materials_pbrSpecularGlossiness");
        if (!e) return;
        colour = colour_member(*e, "diffuseFactor", grey(1));
        base = texture_member(model_, *e, "diffuseTexture");
        const JsonValue* factor = find_member(*e, "diffuseFactor");
        alpha_ = factor && factor->items.size() == 4 ? float_of(factor->items[3].number) : 1;
        const Rgb specular = colour_member(*e, "specularFactor", grey(1));
        const float gloss = std::clamp(float_member(*e, "glossinessFactor", 1), 0.0f, 1.0f);
        const GltfTextureUse both = texture_member(model_, *e, "specularGlossinessTexture");
        m_.maps.metalness = m_.maps.roughness = {};
        m_.alpha = 1;
        const int32_t glossiness = textures_.find(both, PictureUse::opacity);
        if (glossiness == kNoTexture)
            m_.alpha = alpha_from_roughness(1 - gloss);
        else
            m_.maps.roughness = slot(both, textures_.add(roughness_picture(textures_.picture(glossiness), gloss)));
        take_specular_colour(colour, base, specular, both);
    }

    // The diffuse picture becomes one of base colours, if the specular one is that of a metal somewhere.
    void take_specular_colour(Rgb& colour, const GltfTextureUse& base, const Rgb& specular, const GltfTextureUse& both)
    {
        const int32_t diffuse_picture = textures_.find(base, PictureUse::colour);
        const int32_t specular_picture = textures_.find(both, PictureUse::colour);
        const auto picture = [&](int32_t index) { return index == kNoTexture ? nullptr : &textures_.picture(index); };
        const bool alike = diffuse_picture == kNoTexture || specular_picture == kNoTexture || base.lies_as(both);
        const MetallicPictures metal = metallic_pictures(
            {picture(diffuse_picture), colour},
            {alike ? picture(specular_picture) : nullptr, alike || specular_picture == kNoTexture
                                                              ? specular
                                                              : specular * textures_.mean_colour_of(specular_picture)});
        f0_ = metal.f0;
        m_.metalness = metal.is_metal_somewhere ? 1.0f : 0.0f;
        if (!metal.is_metal_somewhere) return;
        const GltfTextureUse& place = diffuse_picture == kNoTexture ? both : base;
        colour = metal.base.rgb.empty() ? metal.plain.base : grey(1);
        if (metal.base.rgb.empty()) {
            m_.metalness = metal.plain.metalness;
            return;
        }
        base_slot_ = slot(place, textures_.add(metal.base));
        m_.maps.metalness = slot(place, textures_.add(metal.metalness));
    }

    // glTF widens the facets along the tangent towards 1 by the strength's square, and leaves them across.
    void take_anisotropy()
    {
        const JsonValue* e = extension("KHR_materials_anisotropy");
        if (!e) return;
        const float strength = std::clamp(float_member(*e, "anisotropyStrength", 0), 0.0f, 1.0f);
        const float across = m_.alpha, along = across + (1 - across) * strength * strength;
        m_.alpha = std::sqrt(along * across);
        m_.anisotropy = anisotropy_of(along / across);
        m_.anisotropy_turns = std::remainder(float_member(*e, "anisotropyRotation", 0) / (2 * kPi), 1.0f);
        if (has_one_of(*e, {"anisotropyTexture"}))
            losses_.add("picture(s) of anisotropy are left out, its numbers are drawn; give parts their own materials");
    }

    // Returns 1 where there is no picture.
    float mean_of_alpha(const JsonValue& extension, const char* texture)
    {
        const int32_t found = textures_.find(texture_member(model_, extension, texture), PictureUse::opacity);
        return found == kNoTexture ? 1.0f : static_cast<float>(textures_.mean_of(found));
    }

    void take_skin()
    {
        const JsonValue* ior = extension("KHR_materials_ior");
        index_ = ior ? float_member(*ior, "ior", kDefaultIndex) : kDefaultIndex;
        index_ = index_ < 1 ? kDefaultIndex : index_;
        const float ratio = (index_ - 1) / (index_ + 1);
        if (f0_ < 0) f0_ = ratio * ratio;
        if (const JsonValue* e = extension("KHR_materials_specular")) {
            f0_ *= float_member(*e, "specularFactor", 1) *
                   max_component(colour_member(*e, "specularColorFactor", grey(1)));
            f0_ *= mean_of_alpha(*e, "specularTexture");
            if (has_one_of(*e, {"specularTexture"}))
                losses_.add("picture(s) of specular strength count by their mean; give it by a number");
            if (has_one_of(*e, {"specularColorTexture"}))
                losses_.add("picture(s) of specular colours are left out; give the strength by a number");
        }
        constexpr float kMostReflectance = 0.36f;  // the largest index that materials have reflects so much
        f0_ = std::clamp(f0_, 0.0f, kMostReflectance);
        m_.specular = f0_ > 0;
        m_.index = index_from_reflectance(f0_);
        m_.rough_body = true;
    }

    void take_base(const Rgb& colour, const GltfTextureUse& use)
    {
        const float metal = m_.maps.metalness.used()
                                ? m_.metalness * static_cast<float>(textures_.mean_of(m_.maps.metalness.texture))
                                : m_.metalness;
        m_.base = colour * (1 - f0_ * (1 - metal));
        m_.maps.base = base_slot_.used() ? base_slot_ : slot(use, textures_.find(use, PictureUse::colour));
    }

    void take_emission()
    {
        const JsonValue* e = extension("KHR_materials_emissive_strength");
        m_.emission = gltf_.emission * (e ? float_member(*e, "emissiveStrength", 1) : 1);
        if (is_black(m_.emission)) return;
        m_.maps.emission = slot(gltf_.emission_texture, textures_.find(gltf_.emission_texture, PictureUse::colour));
    }

    void take_layers()
    {
        if (const JsonValue* e = extension("KHR_materials_clearcoat")) {
            m_.coat = std::clamp(float_member(*e, "clearcoatFactor", 0), 0.0f, 1.0f);
            if (m_.coat > 0) take_means_of_coat(*e);
        }
        if (const JsonValue* e = extension("KHR_materials_sheen")) {
            m_.sheen_colour = colour_member(*e, "sheenColorFactor", {});
            m_.sheen = is_black(m_.sheen_colour) ? 0.0f : 1.0f;
            m_.sheen_roughness = float_member(*e, "sheenRoughnessFactor", 0);
            if (m_.sheen > 0 && has_one_of(*e, {"sheenColorTexture", "sheenRoughnessTexture"}))
                losses_.add("picture(s) of sheen are left out, its numbers are drawn; bake them into the base colour");
        }
    }

    // Red, 0, green, 1, or blue, 2, of a picture, or 1 without one.
    float mean_of(const JsonValue& extension, const char* texture, size_t channel)
    {
        const int32_t found = textures_.find(texture_member(model_, extension, texture), PictureUse::data);
        return found == kNoTexture ? 1.0f : static_cast<float>(textures_.mean_of(found, channel));
    }

    static bool has_one_of(const JsonValue& extension, std::initializer_list<const char*> members)
    {
        return std::any_of(
            members.begin(), members.end(), [&](const char* name) { return find_member(extension, name) != nullptr; });
    }

    void take_means_of_coat(const JsonValue& coat)
    {
        m_.coat *= mean_of(coat, "clearcoatTexture", 0);
        const float roughness = float_member(coat, "clearcoatRoughnessFactor", 0);
        m_.coat_alpha = alpha_from_roughness(roughness * mean_of(coat, "clearcoatRoughnessTexture", 1));
        if (has_one_of(coat, {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"}))
            losses_.add("clear coat(s) are drawn without their pictures, by the means of these; give numbers");
    }

    void make_unlit(const Rgb& colour)
    {
        m_.emission = colour;
        m_.maps.emission = m_.maps.base;
        m_.base = {};
        m_.maps.base = m_.maps.metalness = m_.maps.roughness = {};
        m_.metalness = m_.coat = m_.sheen = 0;
        m_.specular = false;
    }

    void take_alpha(const GltfTextureUse& base)
    {
        const float alpha = std::clamp(alpha_ < 0 ? gltf_.alpha : alpha_, 0.0f, 1.0f);
        if (gltf_.alpha_mode == GltfAlpha::blend) {
            m_.opacity = alpha;
            m_.blends = true;
            m_.maps.opacity = slot(base, textures_.find_opacity(base));
        } else if (gltf_.alpha_mode == GltfAlpha::mask) {
            m_.maps.opacity = slot(base, textures_.find_mask(base, alpha, gltf_.cutoff));
            if (!m_.maps.opacity.used() && !base.used()) m_.opacity = alpha >= gltf_.cutoff ? 1.0f : 0.0f;
        }
    }

    void take_transmission(const Rgb& colour)
    {
        const JsonValue* e = extension("KHR_materials_transmission");
        m_.transmission = e ? std::clamp(float_member(*e, "transmissionFactor", 0), 0.0f, 1.0f) : 0;
        if (m_.maps.metalness.used() && !(textures_.mean_of(m_.maps.metalness.texture) > 0)) {
            m_.maps.metalness = {};
            m_.metalness = 0;
        }
        const bool passes = m_.transmission > 0 && (m_.metalness < 1 || m_.maps.metalness.used());
        const GltfTextureUse picture = e ? texture_member(model_, *e, "transmissionTexture") : GltfTextureUse();
        const int32_t shares = passes ? textures_.find(picture, PictureUse::data) : kNoTexture;
        if (!passes || (shares != kNoTexture && !(textures_.mean_of(shares) > 0))) {
            m_.transmission = 1;  // says nothing of what is no glass
            return;
        }
        m_.maps.transmission = slot(picture, shares);
        m_.glass = true;
        m_.index = index_;
        m_.coat = m_.sheen = 0;
        const JsonValue* volume = extension("KHR_materials_volume");
        const float distance = volume ? float_member(*volume, "attenuationDistance", 0) : 0;
        if (distance > static_cast<float>(kLeastLength)) {
            m_.transmittance = colour_member(*volume, "attenuationColor", grey(1));
            m_.transmittance_length = distance;
            m_.tint = colour;
        } else {
            m_.transmittance = colour;
            result_.tinted = true;
        }
        const bool is_body = volume && (result_.tinted ? float_member(*volume, "thicknessFactor", 0) > 0 : true);
        result_.is_wall = !is_body;
    }

    void normal_slot() { m_.maps.normal = slot(gltf_.normal_texture, textures_.find_normals(gltf_.normal_texture)); }

    void note_losses()
    {
        for (const char* name :
             {"KHR_materials_iridescence", "KHR_materials_dispersion", "KHR_materials_diffuse_transmission"})
            if (extension(name))
                losses_.add("material(s) have " + std::string(name) + ", which is not drawn; check the picture");
    }

    const GltfModel& model_;
    const GltfMaterial& gltf_;
    GltfTextures& textures_;
    Losses& losses_;
    GltfSurface result_;
    Material& m_ = result_.material;
    float f0_ = -1, index_ = kDefaultIndex;  // below 0: by the index
    float alpha_ = -1;                       // below 0: of the core material
    TextureSlot base_slot_;                  // in place of the base picture's
};

}  // namespace

std::vector<GltfSurface> surfaces_of(const GltfModel& model, std::vector<Texture>& list, Losses& losses,
                                     std::vector<std::string>& warnings)
{
    GltfTextures textures(model, list, warnings);
    std::vector<GltfSurface> surfaces;
    surfaces.reserve(model.materials.size() + 1);
    for (const GltfMaterial& gltf : model.materials)
        surfaces.push_back(SurfaceMaker(model, gltf, textures, losses).make());
    surfaces.emplace_back().material.finish();
    return surfaces;
}

}  // namespace lumi::baker
