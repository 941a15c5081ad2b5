// SPDX-License-Identifier: MIT
#include <algorithm>

#include "model/materials.h"
#include "scene/placement.h"
#include "scene/scene_members.h"
#include "volume/volume_file.h"

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

const Metal* metal_of(JsonMembers& members)
{
    std::vector<std::string> names;
    std::transform(std::begin(kMetals), std::end(kMetals), std::back_inserter(names),
                   [](const Metal& metal) { return metal.name; });
    return members.find("metal") ? &kMetals[members.choice("metal", names, 0)] : nullptr;
}

void make_metal(Material& m)
{
    m.maps.base = {};
    m.metalness = 1;
    m.specular = true;
    m.glass = m.thin = false;
}

// "glass": { "transmittance": [r, g, b], "at": distance }
void take_glass(const std::string& file, JsonMembers& members, Material& m)
{
    const JsonValue* value = members.find("glass");
    if (!value) return;
    JsonMembers glass(file, *value, "glass");
    const bool was_glass = m.glass;
    m.glass = true;
    m.thin = false;
    m.transmission = 1;
    m.tint = grey(1);
    m.metalness = 0;
    m.opacity = 1;
    m.alpha = was_glass ? m.alpha : 0;
    glass.colour("transmittance", kShare, m.transmittance);
    glass.number("at", {1e-9, 1e15}, m.transmittance_length);
    glass.finish();
}

void take(JsonMembers& members, const MaterialParameter& p, Material& m)
{
    if (!p.json || !members.find(p.json)) return;
    const double unit = p.stated == Stated::as_turns ? 360 : 1;  // degrees of a turn
    const NumberRange range = {unit * p.low, unit * p.high};
    if (const auto* colour = std::get_if<Rgb MaterialNumbers::*>(&p.member)) {
        members.colour(p.json, range, m.**colour);
    } else {
        double value = 0;
        members.number(p.json, range, value);
        m.*std::get<float MaterialNumbers::*>(p.member) = stated(p, static_cast<float>(value / unit));
    }
    m.specular = m.specular || p.shines;
    m.rough_body = m.rough_body || p.shines;
}

}  // namespace

void apply_material_members(const std::string& file, const JsonValue& value, Material& m)
{
    JsonMembers members(file, value, "a material");
    const Metal* metal = metal_of(members);
    if (metal) make_metal(m);
    take_glass(file, members, m);
    const bool had_sheen = m.sheen > 0;
    for (const MaterialParameter& parameter : kMaterialParameters) take(members, parameter, m);
    if (metal) m.base = metal->f0;
    if (members.find("sheen_colour") && !members.find("sheen") && !had_sheen) m.sheen = 1;
    take_state(members, m.state);
    members.finish();
    m.finish();
}

namespace
{

constexpr NumberRange kDensity = {0, 1e9};
constexpr NumberRange kMeanCosine = {-0.95, 0.95};

TransferPoint read_point(const std::string& file, const JsonValue& value)
{
    JsonMembers members(file, value, "a point of 'transfer'");
    TransferPoint point = {0, grey(1), 0};
    point.value = static_cast<float>(members.number_of(members.require("value"), "value", kScalar));
    point.density = static_cast<float>(members.number_of(members.require("density"), "density", kDensity));
    members.colour("colour", kShare, point.colour);
    members.finish();
    return point;
}

TransferFunction read_transfer(const std::string& file, JsonMembers& volume)
{
    const JsonValue& list = volume.require("transfer");
    if (list.kind != JsonValue::Kind::list || list.items.empty())
        volume.fail(list, "'transfer' must be a list of points; write [ { \"value\": 1, \"density\": 2 } ]");
    std::vector<TransferPoint> points;
    for (const JsonValue& item : list.items) {
        points.push_back(read_point(file, item));
        if (points.size() > 1 && !(points.back().value > points[points.size() - 2].value)) {
            volume.fail(item,
                        "'value' must grow from point to point of 'transfer'; sort the points, and move apart "
                        "those with the same value");
        }
    }
    return TransferFunction(std::move(points));
}

}  // namespace

Volume read_volume(const std::filesystem::path& scene_file, const JsonValue& value)
{
    const std::string name = scene_file.string();
    JsonMembers members(name, value, "the volume");
    const JsonValue& grid = members.require("file");
    const std::filesystem::path path = find_beside(scene_file, members.text_of(grid, "file"));
    if (path.empty())
        members.fail(grid,
                     "the volume '" + grid.text + "' is missing; put it beside " + scene_file.filename().string());
    const TransferFunction transfer = read_transfer(name, members);
    float anisotropy = 0;
    members.number("anisotropy", kMeanCosine, anisotropy);
    const Placement placement = read_placement(members);
    members.finish();
    Volume volume = {read_grid(path), transfer, anisotropy};
    volume.grid.voxel_to_world = combined(affine_of(placement), volume.grid.voxel_to_world);
    if (corners_of(volume).empty()) {
        members.fail(members.require("transfer"), "'transfer' gives density 0 to all values of '" + grid.text + "', " +
                                                      range_of(volume.grid) + "; give some of them more");
    }
    return volume;
}

}  // namespace lumi::baker
