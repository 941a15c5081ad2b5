// SPDX-License-Identifier: MIT
// Reads pictures (PNG, JPEG, TGA, BMP, ...) as textures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "image/radiance_picture.h"
#include "image/texture.h"

namespace lumi::baker
{

// Which part of a picture is read: its colours, its bytes as plain numbers, or its alpha channel (brightness where it
// has none).
enum class PictureUse : uint8_t { colour, data, alpha };

// Nothing, with the reason in `why`, if the file is no picture that can be read.
std::optional<Texture> read_texture(const std::filesystem::path& file, PictureUse use, std::string& why);

// A Radiance .hdr picture from the bytes of its file. Throws SceneError with the file's name.
RadiancePicture read_hdr(const std::filesystem::path& file, const std::string& bytes);

}  // namespace lumi::baker
