// SPDX-License-Identifier: MIT
#include "image/exr.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "files/output_file.h"
#include "image/png.h"
#include "lumi/baker/picture_file.h"

namespace lumi::tools
{

bool is_exr_name(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending == ".exr";
}

std::string wrong_png_or_exr_name(const std::string& path)
{
    if (is_exr_name(path)) return "";
    const std::string wrong = wrong_png_name(path);
    return wrong.empty() ? "" : wrong + "; linear light is written to names that end in .exr";
}

void write_exr(const std::string& path, const baker::RadianceImage& image)
{
    write_output(path, baker::exr_bytes({image.width, image.height, image.rgba.data()}));
}

}  // namespace lumi::tools
