// SPDX-License-Identifier: MIT
#include "image/jpeg.h"

#include "lumi/baker/picture_file.h"

namespace lumi::tools
{

std::string jpeg_bytes(const Picture& picture, int quality)
{
    return baker::jpeg_bytes({picture.width_px, picture.height_px, picture.rgb.data()}, quality);
}

Picture through_jpeg(const Picture& picture, size_t bytes)
{
    int low = 1, high = 101;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (jpeg_bytes(picture, middle).size() <= bytes ? low : high) = middle;
    }
    Picture shown(picture.width_px, picture.height_px);
    shown.rgb = baker::decode_jpeg(jpeg_bytes(picture, low)).rgb;
    return shown;
}

}  // namespace lumi::tools
