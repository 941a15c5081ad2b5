// SPDX-License-Identifier: MIT
// Reads pictures (PNG, JPEG, TGA, BMP, ...) as textures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "texture.h"

namespace lumi::baker
{

// Nothing, with the reason in `why`, if the file is no picture that can be read.
std::optional<Texture> read_texture(const std::filesystem::path& file, std::string& why);

}  // namespace lumi::baker
