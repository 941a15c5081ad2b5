// SPDX-License-Identifier: MIT
// Finds an OBJ's material libraries and pictures and turns them into materials.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "image/texture.h"
#include "material/material.h"
#include "scene/obj_text.h"

namespace lumi::baker
{

// A picture as MTL names it.
struct MtlMap {
    std::string name;  // empty: none
    uint32_t line = 0;
    Vec2 scale = {1, 1}, offset;
    float strength = 1;  // of bumps
};

// A material as MTL states it, still in MTL's terms.
struct MtlMaterial {
    std::string name;
    Rgb kd, ks, ke, tf;
    float ns = 0, ni = 1, dissolve = 1, roughness = 0, metalness = 0, coat = 0, coat_roughness = 0, sheen = 0;
    float anisotropy = 0, anisotropy_turns = 0;
    int illum = 0;
    bool has_tf = false, has_pr = false;
    MtlMap map_kd, map_ks, map_ke, map_pr, map_pm, map_ps, map_d, map_bump;
    std::filesystem::path file;
    uint32_t line = 0;
};

// MTL's terms in ours, see material.h. Not yet finished, and without textures.
Material to_material(const MtlMaterial& mtl);

// The file that `name`, written in a file beside `beside`, means: as written, or only its last part; both kinds of
// slash. Empty if there is none.
std::filesystem::path find_beside(const std::filesystem::path& beside, const std::string& name);

struct MaterialSet {
    std::vector<Material> materials;  // in the order of `uses`
    std::vector<Texture> textures;
};

// One material for each use; what is not found is a grey that a warning names.
MaterialSet resolve_materials(const std::string& obj_file, const std::vector<ObjText::Use>& uses,
                              const std::vector<MtlMaterial>& known, std::vector<std::string>& warnings);

}  // namespace lumi::baker
