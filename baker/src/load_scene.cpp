// SPDX-License-Identifier: MIT
#include "obj_reader.h"

namespace lumi::baker
{

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, std::vector<std::string>& warnings)
{
    return build_scene(read_obj(file, warnings), options);
}

}  // namespace lumi::baker
