// SPDX-License-Identifier: MIT
// The one file of the baker that sees libwebp.

#include <webp/decode.h>

#include "image/picture_bytes.h"

namespace lumi::baker
{

bool is_webp(const std::string& bytes)
{
    return bytes.size() >= 12 && bytes.compare(0, 4, "RIFF") == 0 && bytes.compare(8, 4, "WEBP") == 0;
}

int64_t pixels_of_webp(const std::string& bytes)
{
    int width = 0, height = 0;
    const auto* data = reinterpret_cast<const uint8_t*>(bytes.data());
    return WebPGetInfo(data, bytes.size(), &width, &height) ? int64_t{width} * height : 0;
}

DecodedPicture decode_webp(const std::string& bytes, bool with_alpha)
{
    const auto* data = reinterpret_cast<const uint8_t*>(bytes.data());
    WebPBitstreamFeatures head;
    if (WebPGetFeatures(data, bytes.size(), &head) != VP8_STATUS_OK) throw PictureError("it is damaged");
    if (head.has_animation) throw PictureError("it is an animation");
    check_picture_size(head.width, head.height);
    DecodedPicture picture;
    picture.width = head.width;
    picture.height = head.height;
    const size_t pixels = static_cast<size_t>(head.width) * static_cast<size_t>(head.height);
    std::string rgba(4 * pixels, '\0');
    if (!WebPDecodeRGBAInto(data, bytes.size(), reinterpret_cast<uint8_t*>(rgba.data()), rgba.size(), 4 * head.width))
        throw PictureError("it is damaged");
    picture.rgb.resize(3 * pixels);
    if (with_alpha && head.has_alpha) picture.alpha.resize(pixels);
    for (size_t k = 0; k < pixels; ++k) {
        for (size_t c = 0; c < 3; ++c) picture.rgb[3 * k + c] = static_cast<uint8_t>(rgba[4 * k + c]);
        if (!picture.alpha.empty()) picture.alpha[k] = static_cast<uint8_t>(rgba[4 * k + 3]);
    }
    return picture;
}

}  // namespace lumi::baker
