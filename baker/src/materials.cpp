// SPDX-License-Identifier: MIT
#include "materials.h"

#include <algorithm>
#include <map>

#include "image_file.h"

namespace lumi::baker
{
namespace
{

class TextureStore
{
public:
    TextureStore(std::vector<Texture>& textures, std::vector<std::string>& warnings)
        : textures_(textures), warnings_(warnings)
    {
    }

    int32_t index_of(const MtlMaterial& mtl)
    {
        const Place place = {mtl.file.string(), mtl.map_kd_line};
        const std::filesystem::path file = find_beside(mtl.file, mtl.map_kd);
        if (file.empty()) {
            warnings_.push_back(at(place, "the picture '" + mtl.map_kd +
                                              "' is missing, the plain Kd is used; put it beside " +
                                              mtl.file.filename().string()));
            return kNoTexture;
        }
        const auto [entry, fresh] = loaded_.try_emplace(file, kNoTexture);
        if (fresh) {
            entry->second = load(place, file);
        }
        return entry->second;
    }

private:
    int32_t load(const Place& place, const std::filesystem::path& file)
    {
        std::string why;
        std::optional<Texture> texture = read_texture(file, why);
        if (!texture) {
            warnings_.push_back(at(place, "the picture '" + file.string() + "' is not used (" + why +
                                              "), the plain Kd is; save it as PNG or JPEG"));
            return kNoTexture;
        }
        textures_.push_back(std::move(*texture));
        return static_cast<int32_t>(textures_.size() - 1);
    }

    std::vector<Texture>& textures_;
    std::vector<std::string>& warnings_;
    std::map<std::filesystem::path, int32_t> loaded_;
};

Material default_material(const std::string& name)
{
    Material material;
    material.name = name;
    material.finish();
    return material;
}

}  // namespace

Material to_material(const MtlMaterial& mtl)
{
    Material m;
    m.name = mtl.name;
    m.base = mtl.kd;
    m.emission = mtl.ke;
    m.index = mtl.ni;
    m.opacity = mtl.dissolve;
    const bool physical = mtl.roughness > 0 || mtl.metalness > 0;
    m.alpha = physical ? alpha_from_roughness(mtl.roughness) : alpha_from_phong_exponent(mtl.ns);
    m.specular = physical || !is_black(mtl.ks);
    m.metalness = mtl.metalness;
    if (!physical && m.specular && is_black(mtl.kd) && mtl.map_kd.empty()) {
        m.metalness = 1;
        m.base = mtl.ks;
    }
    m.finish();
    return m;
}

std::filesystem::path find_beside(const std::filesystem::path& beside, const std::string& name)
{
    std::string slashed = name;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const std::filesystem::path folder = beside.parent_path();
    const std::filesystem::path last = std::filesystem::path(slashed).filename();
    for (const std::filesystem::path& candidate : {folder / name, folder / slashed, folder / last}) {
        std::error_code ignored;
        if (!candidate.filename().empty() && std::filesystem::is_regular_file(candidate, ignored)) {
            return candidate;
        }
    }
    return {};
}

MaterialSet resolve_materials(const std::string& obj_file, const std::vector<ObjText::Use>& uses,
                              const std::vector<MtlMaterial>& known, std::vector<std::string>& warnings)
{
    MaterialSet set;
    TextureStore textures(set.textures, warnings);
    for (const ObjText::Use& use : uses) {
        const auto found =
            std::find_if(known.begin(), known.end(), [&](const MtlMaterial& m) { return m.name == use.name; });
        if (found == known.end()) {
            warnings.push_back(
                at({obj_file, use.line},
                   "the material '" + use.name + "' is not defined, it is drawn grey; export the MTL file too"));
            set.materials.push_back(default_material(use.name));
            continue;
        }
        Material material = to_material(*found);
        if (!found->map_kd.empty()) {
            material.base_texture = textures.index_of(*found);
        }
        set.materials.push_back(std::move(material));
    }
    return set;
}

}  // namespace lumi::baker
