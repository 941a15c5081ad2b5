// SPDX-License-Identifier: MIT
#include "png_file.h"

#include <png.h>

namespace simulator
{

bool write_png(const std::string& path, int side_px, const uint8_t* rgb)
{
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = static_cast<png_uint_32>(side_px);
    image.format = PNG_FORMAT_RGB;
    return png_image_write_to_file(&image, path.c_str(), 0, rgb, 0, nullptr) != 0;
}

}  // namespace simulator
