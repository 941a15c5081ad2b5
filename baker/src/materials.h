// SPDX-License-Identifier: MIT
// Finds an OBJ's material libraries and pictures and turns them into materials.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "material.h"
#include "obj_text.h"
#include "texture.h"

namespace lumi::baker
{

// A material as MTL states it, still in MTL's terms.
struct MtlMaterial {
    std::string name;
    Rgb kd, ks, ke;
    float ns = 0, ni = 1, dissolve = 1, roughness = 0, metalness = 0;
    std::string map_kd;  // empty: none
    std::filesystem::path file;
    uint32_t line = 0, map_kd_line = 0;
};

// MTL's terms in ours, see material.h. Finished, without the texture.
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
