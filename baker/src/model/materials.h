// SPDX-License-Identifier: MIT
// Finds an OBJ's material libraries and pictures and turns them into materials.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "image/texture.h"
#include "material/material.h"
#include "model/mtl_reader.h"
#include "model/obj_lines.h"

namespace lumi::baker
{

// The file that `name`, written in a file beside `beside`, means: as written, or only its last part; both kinds of
// slash, with or without quotes, and the last part in another letter case. Empty if there is none.
std::filesystem::path find_beside(const std::filesystem::path& beside, const std::string& name);
// Whether that file was found only by another letter case.
bool is_in_other_case(const std::filesystem::path& found, const std::string& name);

struct MaterialSet {
    std::vector<Material> materials;  // in the order of `uses`
    std::vector<Texture> textures;
};

// One material for each use; what is not found is a grey that a warning names.
MaterialSet resolve_materials(const std::string& obj_file, const std::vector<ObjName>& uses,
                              const std::vector<MtlMaterial>& known, std::vector<std::string>& warnings);

}  // namespace lumi::baker
