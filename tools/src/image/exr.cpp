// SPDX-License-Identifier: MIT
#include "image/exr.h"

#include "image/animation.h"
#include "image/png.h"
#include "lumi/baker/picture_file.h"

namespace lumi::tools
{

bool is_exr_name(const std::string& path)
{
    return small_ending(path) == ".exr";
}

std::string wrong_reference_name(const std::string& path)
{
    if (is_exr_name(path)) return "";
    const std::string wrong = wrong_views_name(path);
    return wrong.empty() ? "" : wrong + "; linear light is written to names that end in .exr";
}

std::string exr_bytes(const baker::RadianceImage& image)
{
    return baker::exr_bytes({image.width, image.height, image.rgba.data()});
}

}  // namespace lumi::tools
