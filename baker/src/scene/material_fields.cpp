// SPDX-License-Identifier: MIT
#include "scene/material_fields.h"

#include <algorithm>

#include "scene/number_ranges.h"

namespace lumi::baker
{
namespace
{

struct Metal {
    const char* name;
    Rgb f0;
};

// Linear reflectance at normal incidence: Akenine-Möller et al., "Real-Time Rendering", 4th edition, table 9.2.
constexpr Metal kMetals[] = {
    {"aluminium", {0.913f, 0.922f, 0.924f}}, {"brass", {0.910f, 0.778f, 0.423f}},
    {"chromium", {0.549f, 0.556f, 0.554f}},  {"copper", {0.955f, 0.638f, 0.538f}},
    {"gold", {1.000f, 0.782f, 0.344f}},      {"iron", {0.562f, 0.565f, 0.578f}},
    {"nickel", {0.660f, 0.609f, 0.526f}},    {"platinum", {0.673f, 0.637f, 0.585f}},
    {"silver", {0.972f, 0.960f, 0.915f}},    {"titanium", {0.542f, 0.497f, 0.449f}},
};

void take_metal(JsonFields& fields, Material& m)
{
    std::vector<std::string> names;
    std::transform(std::begin(kMetals), std::end(kMetals), std::back_inserter(names),
                   [](const Metal& metal) { return metal.name; });
    if (!fields.find("metal")) return;
    m.base = kMetals[fields.choice("metal", names, 0)].f0;
    m.maps.base = {};
    m.metalness = 1;
    m.specular = true;
    m.glass = false;
}

// "glass": { "transmittance": [r, g, b], "at": distance }
void take_glass(const std::string& file, JsonFields& fields, Material& m)
{
    const JsonValue* value = fields.find("glass");
    if (!value) return;
    JsonFields glass(file, *value, "glass");
    const bool was_glass = m.glass;
    m.glass = true;
    m.opacity = 1;
    m.alpha = was_glass ? m.alpha : 0;
    glass.colour("transmittance", kShare, m.transmittance);
    glass.number("at", {1e-9, 1e15}, m.transmittance_length);
    glass.finish();
}

void take_roughness(JsonFields& fields, Material& m)
{
    if (!fields.find("roughness")) return;
    double roughness = 0;
    fields.number("roughness", kShare, roughness);
    m.alpha = alpha_from_roughness(static_cast<float>(roughness));
    m.specular = true;
}

// Turns are given in degrees here.
void take_anisotropy(JsonFields& fields, Material& m)
{
    if (fields.find("anisotropy")) {
        fields.number("anisotropy", kShare, m.anisotropy);
        m.specular = true;
    }
    if (fields.find("anisotropy_rotation")) {
        double degrees = 0;
        fields.number("anisotropy_rotation", {-360, 360}, degrees);
        m.anisotropy_turns = static_cast<float>(degrees / 360);
    }
}

// A colour alone asks for all of the sheen.
void take_sheen(JsonFields& fields, Material& m)
{
    if (fields.find("sheen_colour")) {
        fields.colour("sheen_colour", kShare, m.sheen_colour);
        m.sheen = m.sheen > 0 ? m.sheen : 1;
    }
    fields.number("sheen", kShare, m.sheen);
    fields.number("sheen_roughness", {kMinSheenRoughness, 1}, m.sheen_roughness);
}

}  // namespace

void apply_material_fields(const std::string& file, const JsonValue& value, Material& m)
{
    JsonFields fields(file, value, "a material");
    if (fields.find("colour")) fields.colour("colour", kShare, m.base);
    take_metal(fields, m);
    take_glass(file, fields, m);
    take_roughness(fields, m);
    if (fields.find("metalness")) {
        fields.number("metalness", kShare, m.metalness);
        m.specular = true;
    }
    take_anisotropy(fields, m);
    fields.number("index", {1.01, 4}, m.index);
    fields.number("coat", kShare, m.coat);
    double coat_roughness = -1;
    fields.number("coat_roughness", kShare, coat_roughness);
    m.coat_alpha = coat_roughness < 0 ? m.coat_alpha : alpha_from_roughness(static_cast<float>(coat_roughness));
    take_sheen(fields, m);
    fields.colour("emission", {0, 1e9}, m.emission);
    fields.number("opacity", kShare, m.opacity);
    fields.finish();
    m.finish();
}

}  // namespace lumi::baker
