// SPDX-License-Identifier: MIT
#include "scene/model_reader.h"

#include <algorithm>
#include <cctype>

#include "model/gltf/reader.h"
#include "model/obj_reader.h"

namespace lumi::baker
{
namespace
{

std::string extension_of(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

}  // namespace

SceneParts read_model(const std::filesystem::path& file, std::vector<std::string>& warnings)
{
    const std::string extension = extension_of(file);
    if (extension == ".glb" || extension == ".gltf") return read_gltf(file, warnings);
    return read_obj(file, warnings);
}

}  // namespace lumi::baker
