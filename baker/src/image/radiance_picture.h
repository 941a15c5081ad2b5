// SPDX-License-Identifier: MIT
// A picture of linear radiance, and the files that hold one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "math/vec3.h"

namespace lumi::baker
{

struct RadiancePicture {
    int width = 0, height = 0;  // > 0
    std::vector<Rgb> pixels;    // top row first; finite, not negative

    const Rgb& at(int x, int y) const
    {
        return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

// Radiance .hdr or OpenEXR .exr, told apart by their first bytes. Negative numbers become 0; pixels that are no number
// or infinite become black and are named in `warnings`. Throws SceneError, both with the file's name.
RadiancePicture read_radiance_picture(const std::filesystem::path& file, std::vector<std::string>& warnings);

bool is_hdr(const std::string& bytes);

// RGBE, top row first, flat or with run lengths of each channel. Throws PictureError.
RadiancePicture decode_hdr(const std::string& bytes);

bool is_exr(const std::string& bytes);

// The channels R, G, B, or Y as grey, of the first part. Throws PictureError.
RadiancePicture decode_exr(const std::string& bytes);

}  // namespace lumi::baker
