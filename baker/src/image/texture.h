// SPDX-License-Identifier: MIT
// An 8-bit picture, read with bilinear filtering in linear light.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "lumi/baker/picture_file.h"
#include "math/vec3.h"

namespace lumi::baker
{

// The colours beyond a picture's border: the picture again, its outermost pixels, or its mirror image.
enum class Wrap : uint8_t { repeat, clamp, mirror };

struct Texture {
    int width = 0, height = 0;  // > 0
    std::vector<uint8_t> rgb;   // 3 bytes a pixel, top row first
    bool encoded = true;        // sRGB; otherwise bytes stand for 0 to 1

    // u to the right, v upwards, the picture fills [0,1]². `wrap`: in u and in v.
    Rgb at(const Vec2& uv, const std::array<Wrap, 2>& wrap = {Wrap::repeat, Wrap::repeat}) const;
};

// A grey picture of heights as a normal map: the slope is `strength` times the height's change from pixel to pixel, in
// bytes over 32.
Texture normals_from_heights(const Texture& heights, float strength);

// All three channels are alike everywhere.
bool is_grey(const Texture& texture);

// Which part of a picture is read: its colours, its bytes as plain numbers, its alpha channel (brightness where it has
// none), its alpha channel as opacity (full where it has none), or its blue bytes as plain numbers.
enum class PictureUse : uint8_t { colour, data, alpha, opacity, blue };

class PictureRoom;

// Throws PictureError, and SceneError where `room` does not suffice.
Texture read_texture(const std::filesystem::path& file, PictureUse use, PictureRoom* room = nullptr);
// Does the same, also of WebP, with a file's bytes, which `name` names in messages only.
Texture decode_texture(const std::filesystem::path& name, const std::string& bytes, PictureUse use);

}  // namespace lumi::baker
