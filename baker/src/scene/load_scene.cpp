// SPDX-License-Identifier: MIT
#include "scene/obj_reader.h"
#include "scene/scene_file.h"

namespace lumi::baker
{

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, std::vector<std::string>& warnings)
{
    return build_scene(
        file.extension() == ".json" ? read_scene_file(file, options.up, warnings) : read_obj(file, warnings), options);
}

}  // namespace lumi::baker
