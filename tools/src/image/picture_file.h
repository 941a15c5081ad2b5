// SPDX-License-Identifier: MIT
// Reads and writes files of pictures: PNG and OpenEXR (lumi/host/png.h, lumi/baker/picture_file.h).
#pragma once

#include <string>

#include "image/picture.h"
#include "lumi/baker/reference.h"

namespace lumi::tools
{

// Says what is wrong with it as the name of a picture; nothing if it ends in ".png", or is a device or a pipe.
std::string wrong_png_name(const std::string& path);

// Reads 8 bits a channel; grey becomes RGB, 16 bits are rounded to 8, and what is not opaque lies over black. Throws
// Failure.
Picture read_png(const std::string& path);

// The bytes of a PNG file, with alpha if the picture has it. Throws std::length_error for a picture that no PNG can
// hold.
std::string png_bytes(const Picture& picture);

// Writes by write_output: throws Failure and leaves earlier output where that fails.
void write_png(const std::string& path, const Picture& picture);

bool is_exr_name(const std::string& path);

// Says what is wrong with it as the name of views to trace; nothing if it ends in ".png", ".webp" or ".exr", or is a
// device or a pipe.
std::string wrong_reference_name(const std::string& path);

std::string exr_bytes(const baker::RadianceImage& image);

}  // namespace lumi::tools
