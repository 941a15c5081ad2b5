// SPDX-License-Identifier: MIT
#include "model/materials.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <unordered_map>

#include "image/picture_bytes.h"
#include "image/texture.h"
#include "model/losses.h"

namespace lumi::baker
{
namespace
{

std::string with_slashes(std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

std::string without_quotes(const std::string& name)
{
    const bool quoted = name.size() > 2 && name.front() == '"' && name.back() == '"';
    return quoted ? name.substr(1, name.size() - 2) : name;
}

// The first by name, so that every machine finds the same.
std::filesystem::path find_in_any_case(const std::filesystem::path& folder, const std::string& name)
{
    std::filesystem::path found;
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, failed)) {
        const std::filesystem::path file = entry.path().filename();
        const bool better = found.empty() || file < found.filename();
        if (better && in_small_letters(file.string()) == in_small_letters(name) && entry.is_regular_file(failed))
            found = folder / file;
    }
    return found;
}

TextureSlot slot_of(const MtlMap& map, int32_t texture)
{
    TextureSlot slot;
    slot.texture = texture;
    slot.scale = map.scale;
    slot.offset = map.offset;
    return slot;
}

class TextureStore
{
public:
    TextureStore(const std::filesystem::path& model, std::vector<Texture>& textures) : room_(model), textures_(textures)
    {
    }

    // None where `map` is null.
    TextureSlot slot(const std::filesystem::path& mtl, const MtlMap* named, PictureUse use)
    {
        if (!named) return {};
        const MtlMap& map = *named;
        const std::filesystem::path file = find_beside(mtl, map.name);
        if (file.empty()) {
            losses_[mtl].add_at(map.line, "use(s) of the picture '" + map.name +
                                              "', which is missing, take the plain number; put it beside " +
                                              mtl.string());
            return {};
        }
        if (is_in_other_case(file, map.name)) {
            losses_[mtl].add_at(map.line, "use(s) of the picture '" + map.name + "' take '" + file.filename().string() +
                                              "' for it; write the name as the file's");
        }
        const Key key = {file.string(), use};
        const auto [entry, fresh] = loaded_.try_emplace(key, kNoTexture);
        if (fresh) entry->second = load(mtl, map.line, file, use);
        return slot_of(map, entry->second);
    }

    // The slot that cuts out what the picture's alpha hides; none where alpha hides all or nothing.
    TextureSlot alpha_slot(const std::filesystem::path& mtl, const MtlMap& map)
    {
        const Key key = {find_beside(mtl, map.name).string(), PictureUse::opacity};
        const auto [entry, fresh] = loaded_.try_emplace(key, kNoTexture);
        if (fresh) {
            Texture opacity = read_texture(key.first, key.second, &room_);
            const auto [least, most] = std::minmax_element(opacity.rgb.begin(), opacity.rgb.end());
            if (*least < *most) {
                textures_.push_back(std::move(opacity));
                entry->second = static_cast<int32_t>(textures_.size() - 1);
            }
        }
        return slot_of(map, entry->second);
    }

    // A grey picture holds heights, any other one normals.
    TextureSlot normal_slot(const std::filesystem::path& mtl, const MtlMap* map)
    {
        TextureSlot found = slot(mtl, map, PictureUse::data);
        if (!found.used() || !is_grey(textures_[static_cast<size_t>(found.texture)])) return found;
        const auto [entry, fresh] = normals_.try_emplace({found.texture, map->strength}, kNoTexture);
        if (fresh) {
            room_.take(static_cast<int64_t>(textures_[static_cast<size_t>(found.texture)].rgb.size() / 3));
            textures_.push_back(normals_from_heights(textures_[static_cast<size_t>(found.texture)], map->strength));
            entry->second = static_cast<int32_t>(textures_.size() - 1);
        }
        found.texture = entry->second;
        return found;
    }

    void report(std::vector<std::string>& warnings) const
    {
        for (const auto& [mtl, losses] : losses_) losses.report(mtl, warnings);
    }

private:
    using Key = std::pair<std::string, PictureUse>;

    int32_t load(const std::filesystem::path& mtl, uint32_t line, const std::filesystem::path& file, PictureUse use)
    {
        try {
            textures_.push_back(read_texture(file, use, &room_));
        } catch (const PictureError& e) {
            losses_[mtl].add_at(line, "use(s) of the picture '" + file.string() + "' take the plain number (" +
                                          e.what() + "); convert it to PNG");
            return kNoTexture;
        }
        return static_cast<int32_t>(textures_.size() - 1);
    }

    PictureRoom room_;
    std::vector<Texture>& textures_;
    std::map<std::filesystem::path, Losses> losses_;  // by MTL file
    std::map<Key, int32_t> loaded_;
    std::map<std::pair<int32_t, float>, int32_t> normals_;  // by picture of heights and strength
};

Material default_material(const std::string& name)
{
    Material material;
    material.name = name;
    material.finish();
    return material;
}

// Illumination models 4 to 9 of MTL that let light through a body; and materials of the PBR extension with a Tf, as
// Blender writes its transmission. Without Pr, many exporters write Tf 1 1 1 for what is opaque.
bool is_glass(const MtlMaterial& mtl)
{
    const bool refracts = mtl.illum == 6 || mtl.illum == 7;
    const bool clear = mtl.illum == 4 || mtl.illum == 9;
    if (mtl.number("Ni", 1) <= 1 || (mtl.has("Tf") && is_black(mtl.colour("Tf")))) return false;
    constexpr float kMostlyClear = 0.5f;
    const bool transmits = mtl.has("Pr") && max_component(mtl.colour("Tf")) >= kMostlyClear;
    return refracts || transmits || (clear && (mtl.has("Tf") || mtl.opacity >= 1));
}

void make_glass(const MtlMaterial& mtl, Material& m)
{
    m.glass = true;
    m.index = mtl.number("Ni", kDefaultIndex);
    m.alpha = alpha_from_roughness(mtl.number("Pr", 0));
    m.opacity = 1;
    m.metalness = 0;
}

// A number of 1 means this in the Principled shader (Burley 2012), which Blender exports up to version 3.6: a skin that
// reflects this much from straight above, a coat that reflects a quarter of what it would, and of sheen the share of
// the finest fibres that sends back as much (tools/lab/materials compares with Cycles).
constexpr float kMostReflectance = 0.08f, kCoat = 0.25f, kSheen = 1.0f / 6;

// A number that only a picture gives counts as 1.
void open_for_maps(const MtlMaterial& mtl, Material& m)
{
    if (mtl.map("map_Ke") && is_black(m.emission)) m.emission = grey(1);
    if (mtl.map("map_Pm") && !(m.metalness > 0)) m.metalness = 1;
    if (mtl.map("map_Ps") && !(m.sheen > 0)) m.sheen = kSheen;
    if (mtl.map("map_Pr") && !(mtl.number("Pr", 0) > 0)) m.alpha = 1;
}

// White where only a picture gives it.
Rgb colour_of(const MtlMaterial& mtl, const char* keyword, const char* map)
{
    return mtl.map(map) && !mtl.has(keyword) ? grey(1) : mtl.colour(keyword);
}

// The usual grey where neither a number nor a picture gives it. A black one beside a picture is what some exporters
// write for white.
Rgb base_of(const MtlMaterial& mtl)
{
    if (mtl.map("map_Kd")) return mtl.has("Kd") && !is_black(mtl.colour("Kd")) ? mtl.colour("Kd") : grey(1);
    return mtl.has("Kd") ? mtl.colour("Kd") : MaterialNumbers().base;
}

// Gives the body a skin, and coat and fibres as Blender exports them.
void take_layers(const MtlMaterial& mtl, Material& m)
{
    const Rgb ks = colour_of(mtl, "Ks", "map_Ks");
    const float strength = std::min(max_component(ks), 1.0f);
    m.specular = mtl.has("Ks") ? strength > 0 : m.rough_body || strength > 0;
    if (mtl.has("Ks") && m.specular) m.index = index_from_reflectance(kMostReflectance * strength);
    m.coat = std::min(m.coat, 1.0f) * kCoat;
    m.sheen = std::min(m.sheen, 1.0f) * kSheen;
    if (mtl.has("Ps") || mtl.map("map_Ps")) m.sheen_roughness = static_cast<float>(kMinSheenRoughness);
    constexpr int kMirror = 3;
    if (mtl.illum == kMirror && !m.rough_body && m.specular && is_black(mtl.colour("Kd")) && !mtl.map("map_Kd")) {
        m.metalness = 1;
        m.base = ks;
    }
}

// Not yet finished, and without textures.
Material to_material(const MtlMaterial& mtl)
{
    Material m;
    m.name = mtl.name;
    for (const MaterialParameter& p : kMaterialParameters) {
        if (!p.mtl || !mtl.has(p.mtl)) continue;
        if (const auto* colour = std::get_if<Rgb MaterialNumbers::*>(&p.member))
            m.** colour = mtl.colour(p.mtl);
        else
            m.*std::get<float MaterialNumbers::*>(p.member) = stated(p, mtl.number(p.mtl, 0));
    }
    m.base = base_of(mtl);
    m.opacity = mtl.opacity;
    const bool physical = mtl.has("Pr") || m.metalness > 0 || mtl.map("map_Pr") || mtl.map("map_Pm");
    m.alpha = physical ? alpha_from_roughness(mtl.number("Pr", 0)) : alpha_from_phong_exponent(mtl.number("Ns", 1));
    m.rough_body = physical;
    take_layers(mtl, m);
    open_for_maps(mtl, m);
    if (is_glass(mtl))
        make_glass(mtl, m);
    else
        m.transmittance = grey(1);  // says nothing of other materials
    return m;
}

struct MapUse {
    const char* keyword;
    TextureSlot TextureSlots::*slot;
    PictureUse use;
};
constexpr MapUse kMaps[] = {
    {"map_Ke", &TextureSlots::emission, PictureUse::colour}, {"map_Pr", &TextureSlots::roughness, PictureUse::data},
    {"map_Pm", &TextureSlots::metalness, PictureUse::data},  {"map_Ps", &TextureSlots::sheen, PictureUse::data},
    {"map_d", &TextureSlots::opacity, PictureUse::alpha},
};

void add_maps(const MtlMaterial& mtl, TextureStore& textures, Material& m)
{
    const bool metal = m.metalness > 0 && !mtl.map("map_Kd");
    m.maps.base = textures.slot(mtl.file, mtl.map(metal ? "map_Ks" : "map_Kd"), PictureUse::colour);
    for (const MapUse& use : kMaps) m.maps.*use.slot = textures.slot(mtl.file, mtl.map(use.keyword), use.use);
    if (!metal && m.maps.base.used() && !mtl.map("map_d") && !m.glass)
        m.maps.opacity = textures.alpha_slot(mtl.file, *mtl.map("map_Kd"));
    m.maps.normal = textures.normal_slot(mtl.file, mtl.map(mtl.map("norm") ? "norm" : "bump"));
}

}  // namespace

std::filesystem::path find_beside(const std::filesystem::path& beside, const std::string& name)
{
    const std::string plain = without_quotes(name), slashed = with_slashes(plain);
    const std::filesystem::path folder = beside.parent_path();
    const std::filesystem::path last = std::filesystem::path(slashed).filename();
    for (const std::filesystem::path& candidate : {folder / plain, folder / slashed, folder / last}) {
        std::error_code ignored;
        if (!candidate.filename().empty() && std::filesystem::is_regular_file(candidate, ignored)) return candidate;
    }
    return last.empty() ? std::filesystem::path() : find_in_any_case(folder, last.string());
}

bool is_in_other_case(const std::filesystem::path& found, const std::string& name)
{
    return found.filename() != std::filesystem::path(with_slashes(without_quotes(name))).filename();
}

MaterialSet resolve_materials(const std::string& obj_file, const std::vector<ObjName>& uses,
                              const std::vector<MtlMaterial>& known, std::vector<std::string>& warnings)
{
    MaterialSet set;
    Losses losses;
    TextureStore textures(obj_file, set.textures);
    std::unordered_map<std::string_view, const MtlMaterial*> by_name;
    for (const MtlMaterial& m : known) by_name.try_emplace(m.name, &m);  // the first one counts
    for (const ObjName& use : uses) {
        const auto found = by_name.find(use.name);
        if (found == by_name.end()) {
            losses.add_at(use.line, "material(s) are not defined and are drawn grey; export the MTL file too",
                          use.name);
            set.materials.push_back(default_material(use.name));
            continue;
        }
        Material material = to_material(*found->second);
        add_maps(*found->second, textures, material);
        material.finish();
        set.materials.push_back(std::move(material));
    }
    losses.report(obj_file, warnings);
    textures.report(warnings);
    return set;
}

}  // namespace lumi::baker
