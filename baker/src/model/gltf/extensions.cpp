// SPDX-License-Identifier: MIT
#include "model/gltf/extensions.h"

#include <algorithm>
#include <cmath>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

constexpr const char* kKnown[] = {
    "EXT_meshopt_compression",
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
};

struct Remedy {
    const char* extension;
    const char* what;
    const char* mend;
};

// Blender's importer refuses these, too. Debian 12 has a converter for AVIF alone.
constexpr const char* kPlainPictures =
    "get the model with PNG or JPEG pictures (many sites offer the original beside it), or convert its pictures and "
    "remove the extension from the file's text";
constexpr Remedy kRemedies[] = {
    {"KHR_texture_basisu", "its pictures are KTX2 files",
     "get the model with PNG or JPEG pictures (many sites offer the original beside it); Debian has no converter, "
     "Khronos' own is `ktx extract`"},
    {"EXT_texture_avif", "its pictures are AVIF files",
     "get the model with PNG or JPEG pictures, or convert those beside a .gltf by `avifdec P.avif P.png` of Debian's "
     "libavif-bin, and replace in its text .avif by .png and EXT_texture_avif by EXT_texture_webp"},
    {"MSFT_texture_dds", "its pictures are DDS files", kPlainPictures},
    {"EXT_mesh_gpu_instancing", "its meshes are repeated by instancing", "export the instances as nodes"},
};

const Remedy* remedy_of(const std::string& extension)
{
    const auto* found = std::find_if(std::begin(kRemedies), std::end(kRemedies),
                                     [&](const Remedy& r) { return extension == r.extension; });
    return found == std::end(kRemedies) ? nullptr : found;
}

[[noreturn]] void refuse(const GltfModel& model, const Remedy& remedy)
{
    fail_gltf(model, std::string(remedy.what) + " (" + remedy.extension + "); " + remedy.mend);
}

}  // namespace

void fail_gltf(const GltfModel& model, const std::string& text)
{
    throw SceneError(at({model.file.string()}, text));
}

void check_gltf_version(const GltfModel& model, const std::string& version)
{
    if (version.empty() || version[0] == '2') return;  // without one, the parser has refused it
    fail_gltf(model, "this is glTF " + version.substr(0, 8) +
                         ", only 2.0 is read; open it in a program such as Blender and export glTF 2.0");
}

void check_required_extensions(const GltfModel& model, const std::vector<std::string>& required)
{
    for (const std::string& extension : required) {
        const bool drawn =
            std::any_of(std::begin(kKnown), std::end(kKnown), [&](const char* name) { return extension == name; });
        if (drawn) continue;
        if (const Remedy* remedy = remedy_of(extension)) refuse(model, *remedy);
        fail_gltf(model, "it requires the extension " + extension.substr(0, 60) +
                             ", which is not drawn; export it without this extension");
    }
}

void refuse_foreign_pictures(const GltfModel& model, const std::map<std::string, JsonValue>& extensions)
{
    for (const auto& entry : extensions)
        if (const Remedy* remedy = remedy_of(entry.first)) refuse(model, *remedy);
}

float float_of(double number)
{
    constexpr double kMost = 1e15;
    return static_cast<float>(std::clamp(number, -kMost, kMost));
}

const JsonValue* find_member(const JsonValue& value, const char* name)
{
    const auto found = std::find_if(value.members.begin(), value.members.end(),
                                    [&](const auto& member) { return member.first == name; });
    return found == value.members.end() ? nullptr : &found->second;
}

double number_member(const JsonValue& value, const char* name, double fallback)
{
    const JsonValue* member = find_member(value, name);
    return member && member->kind == JsonValue::Kind::number && std::isfinite(member->number) ? member->number
                                                                                              : fallback;
}

Rgb colour_member(const JsonValue& value, const char* name, const Rgb& fallback)
{
    const JsonValue* member = find_member(value, name);
    if (!member || member->items.size() < 3) return fallback;
    const auto component = [&](size_t k) { return float_of(member->items[k].number); };
    return {component(0), component(1), component(2)};
}

GltfTextureUse texture_use_of(const GltfModel& model, int32_t texture, int32_t uv_set,
                              const std::map<std::string, JsonValue>& extensions)
{
    if (texture == kNoIndex) return {};
    const GltfTexture& named = element_of(model, model.textures, texture, "texture");
    GltfTextureUse use;
    use.image = named.image;
    use.wrap = named.wrap;
    use.uv_set = uv_set;
    const auto found = extensions.find("KHR_texture_transform");
    if (found == extensions.end()) return use;
    const auto number = [&](const JsonValue& item, float fallback) {
        constexpr double kMost = 1e6;  // beyond it no pixel would be found again
        if (std::abs(item.number) <= kMost) return static_cast<float>(item.number);
        use.far_off = true;
        return fallback;
    };
    const auto pair = [&](const char* name, const Vec2& fallback) {
        const JsonValue* member = find_member(found->second, name);
        if (!member || member->items.size() < 2) return fallback;
        return Vec2{number(member->items[0], fallback.x), number(member->items[1], fallback.y)};
    };
    use.offset = pair("offset", {});
    use.scale = pair("scale", {1, 1});
    use.rotation = number_member(found->second, "rotation", 0);
    use.uv_set = static_cast<int32_t>(std::clamp(number_member(found->second, "texCoord", uv_set), 0.0, 100.0));
    return use;
}

GltfTextureUse texture_member(const GltfModel& model, const JsonValue& value, const char* name)
{
    const JsonValue* member = find_member(value, name);
    if (!member) return {};
    std::map<std::string, JsonValue> extensions;
    if (const JsonValue* list = find_member(*member, "extensions"))
        for (const auto& [extension, content] : list->members) extensions[extension] = content;
    const double index = std::clamp(number_member(*member, "index", kNoIndex), -1.0, 1e9);
    const double uv_set = std::clamp(number_member(*member, "texCoord", 0), 0.0, 100.0);
    return texture_use_of(model, static_cast<int32_t>(index), static_cast<int32_t>(uv_set), extensions);
}

}  // namespace lumi::baker
