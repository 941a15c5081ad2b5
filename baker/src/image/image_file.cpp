// SPDX-License-Identifier: MIT
#include "image/image_file.h"

#include "image/jpeg_file.h"
#include "image/picture_bytes.h"
#include "image/png_file.h"

namespace lumi::baker
{
namespace
{

DecodedPicture read_picture(const std::filesystem::path& file, bool with_alpha)
{
    const std::string bytes = picture_bytes(file);
    if (is_png(bytes)) return decode_png(bytes, with_alpha);
    if (is_jpeg(bytes)) return decode_jpeg(bytes);
    refuse_picture(file, bytes);
}

}  // namespace

Texture read_texture(const std::filesystem::path& file, PictureUse use)
{
    DecodedPicture picture = read_picture(file, use == PictureUse::alpha);
    for (size_t k = 0; k < picture.alpha.size(); ++k) std::fill_n(&picture.rgb[3 * k], 3, picture.alpha[k]);
    return {picture.width, picture.height, std::move(picture.rgb), use == PictureUse::colour};
}

}  // namespace lumi::baker
