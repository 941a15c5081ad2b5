// SPDX-License-Identifier: MIT
#include "image/radiance_picture.h"

#include "image/picture_bytes.h"
#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

// Sharpened pictures undershoot: a little below 0 is ordinary, and means 0.
Rgb clamped(const Rgb& c)
{
    return {std::clamp(c.r, 0.0f, kMaxRadiance), std::clamp(c.g, 0.0f, kMaxRadiance),
            std::clamp(c.b, 0.0f, kMaxRadiance)};
}

void repair(const std::filesystem::path& file, RadiancePicture& picture, std::vector<std::string>& warnings)
{
    size_t bad = 0, first = 0;
    for (size_t k = 0; k < picture.pixels.size(); ++k) {
        Rgb& p = picture.pixels[k];
        if (!std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b)) {
            first = bad++ == 0 ? k : first;
            p = {};
        }
        p = clamped(p);
    }
    if (bad != 0) {
        const size_t width = static_cast<size_t>(picture.width);
        warnings.push_back(at({file.string()}, std::to_string(bad) +
                                                   " pixel(s) are no number or infinite and count as black; "
                                                   "repair the picture, first at column " +
                                                   std::to_string(first % width) + ", row " +
                                                   std::to_string(first / width)));
    }
}

RadiancePicture read(const std::filesystem::path& file)
{
    const std::string bytes = picture_bytes(file);
    if (is_exr(bytes)) return decode_exr(bytes);
    if (is_hdr(bytes)) return decode_hdr(bytes);
    throw SceneError(
        at({file.string()}, "this is neither a Radiance .hdr nor an OpenEXR picture; save it as one of them"));
}

}  // namespace

RadiancePicture read_radiance_picture(const std::filesystem::path& file, std::vector<std::string>& warnings)
{
    RadiancePicture picture;
    try {
        picture = read(file);
    } catch (const PictureError& e) {
        throw SceneError(at({file.string()}, std::string("the picture cannot be read (") + e.what() +
                                                 "); save it again as .hdr or .exr"));
    }
    repair(file, picture, warnings);
    return picture;
}

}  // namespace lumi::baker
