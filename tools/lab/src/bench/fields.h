// SPDX-License-Identifier: MIT
// The field that is drawn: one scene, baked once per texel format and kept in the work folder.
#pragma once

#include <filesystem>
#include <string>

#include "lumi/baker/bake.h"

namespace lumi::bench
{

struct FieldSettings {
    std::filesystem::path scene;
    uint32_t origins = 1024, directions = 2048;
    uint32_t samples = 4;  // noise is part of any field; what is judged is how it is drawn
};

// `texel` is one of kTexels.
format::TexelFormat texel_format(const std::string& texel);

// The path of the baked field, which is baked now unless it is there.
std::filesystem::path require_field(const FieldSettings& settings, const std::string& texel,
                                    const std::filesystem::path& work);

}  // namespace lumi::bench
