// SPDX-License-Identifier: MIT
// Reads PNG and JPEG pictures as textures.
#pragma once

#include <filesystem>

#include "image/texture.h"
#include "lumi/baker/picture_file.h"

namespace lumi::baker
{

// Which part of a picture is read: its colours, its bytes as plain numbers, or its alpha channel (brightness where it
// has none).
enum class PictureUse : uint8_t { colour, data, alpha };

// Throws PictureError.
Texture read_texture(const std::filesystem::path& file, PictureUse use);

}  // namespace lumi::baker
