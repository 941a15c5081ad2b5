// SPDX-License-Identifier: MIT
#include "ppm_file.h"

#include <cstring>

#include "lumi/color.h"
#include "text_line.h"

namespace lumi::firmware
{
namespace
{

constexpr uint32_t kBlockPixels = 256;  // a call of semihosting costs far more than its bytes
constexpr uint32_t kBytesPerRgb565 = 2;
constexpr uint32_t kBytesPerRgb888 = 3;

void unpack(const uint8_t* rgb565, uint8_t* rgb888)
{
    const Rgb8 colour = detail::unpack_rgb565(static_cast<uint16_t>(rgb565[0] | rgb565[1] << 8));
    rgb888[0] = colour.r;
    rgb888[1] = colour.g;
    rgb888[2] = colour.b;
}

}  // namespace

PpmFile::PpmFile(const char* path, uint32_t width_px, uint32_t height_px) : file_(path)
{
    TextLine header;
    header.text("P6\n").decimal(width_px).text(" ").decimal(height_px).text("\n255\n");
    file_.write(header.c_str(), std::strlen(header.c_str()));
}

bool PpmFile::append_rgb565(const uint8_t* pixels, uint32_t bytes)
{
    uint8_t block[kBlockPixels * kBytesPerRgb888];
    const uint8_t* end = pixels + bytes;
    while (pixels < end) {
        uint32_t filled = 0;
        for (; filled < sizeof(block) && pixels < end; filled += kBytesPerRgb888, pixels += kBytesPerRgb565)
            unpack(pixels, block + filled);
        file_.write(block, filled);
    }
    return file_.ok();
}

}  // namespace lumi::firmware
