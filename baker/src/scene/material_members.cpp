// SPDX-License-Identifier: MIT
#include "scene/material_members.h"

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

void take_metal(JsonMembers& members, Material& m)
{
    std::vector<std::string> names;
    std::transform(std::begin(kMetals), std::end(kMetals), std::back_inserter(names),
                   [](const Metal& metal) { return metal.name; });
    if (!members.find("metal")) return;
    m.base = kMetals[members.choice("metal", names, 0)].f0;
    m.maps.base = {};
    m.metalness = 1;
    m.specular = true;
    m.glass = false;
}

// "glass": { "transmittance": [r, g, b], "at": distance }
void take_glass(const std::string& file, JsonMembers& members, Material& m)
{
    const JsonValue* value = members.find("glass");
    if (!value) return;
    JsonMembers glass(file, *value, "glass");
    const bool was_glass = m.glass;
    m.glass = true;
    m.opacity = 1;
    m.alpha = was_glass ? m.alpha : 0;
    glass.colour("transmittance", kShare, m.transmittance);
    glass.number("at", {1e-9, 1e15}, m.transmittance_length);
    glass.finish();
}

void take_roughness(JsonMembers& members, Material& m)
{
    if (!members.find("roughness")) return;
    double roughness = 0;
    members.number("roughness", kShare, roughness);
    m.alpha = alpha_from_roughness(static_cast<float>(roughness));
    m.specular = true;
}

// Turns are given in degrees here.
void take_anisotropy(JsonMembers& members, Material& m)
{
    if (members.find("anisotropy")) {
        members.number("anisotropy", kShare, m.anisotropy);
        m.specular = true;
    }
    if (members.find("anisotropy_rotation")) {
        double degrees = 0;
        members.number("anisotropy_rotation", {-360, 360}, degrees);
        m.anisotropy_turns = static_cast<float>(degrees / 360);
    }
}

// A colour alone asks for all of the sheen.
void take_sheen(JsonMembers& members, Material& m)
{
    if (members.find("sheen_colour")) {
        members.colour("sheen_colour", kShare, m.sheen_colour);
        m.sheen = m.sheen > 0 ? m.sheen : 1;
    }
    members.number("sheen", kShare, m.sheen);
    members.number("sheen_roughness", {kMinSheenRoughness, 1}, m.sheen_roughness);
}

}  // namespace

void apply_material_members(const std::string& file, const JsonValue& value, Material& m)
{
    JsonMembers members(file, value, "a material");
    if (members.find("colour")) members.colour("colour", kShare, m.base);
    take_metal(members, m);
    take_glass(file, members, m);
    take_roughness(members, m);
    if (members.find("metalness")) {
        members.number("metalness", kShare, m.metalness);
        m.specular = true;
    }
    take_anisotropy(members, m);
    members.number("index", {1.01, 4}, m.index);
    members.number("coat", kShare, m.coat);
    double coat_roughness = -1;
    members.number("coat_roughness", kShare, coat_roughness);
    m.coat_alpha = coat_roughness < 0 ? m.coat_alpha : alpha_from_roughness(static_cast<float>(coat_roughness));
    take_sheen(members, m);
    members.colour("emission", {0, 1e9}, m.emission);
    members.number("opacity", kShare, m.opacity);
    members.finish();
    m.finish();
}

}  // namespace lumi::baker
