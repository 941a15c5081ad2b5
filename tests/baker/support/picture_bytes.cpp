// SPDX-License-Identifier: MIT
#include "support/picture_bytes.h"

#include <png.h>
#include <turbojpeg.h>

#include <stdexcept>

namespace lumi::baker::testing
{
namespace
{

void append(png_structp png, png_bytep bytes, size_t size)
{
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), size);
}

void set_palette(png_structp png, png_infop info, const PngKind& kind)
{
    std::vector<png_color> colours;
    for (size_t k = 0; k + 2 < kind.palette.size(); k += 3)
        colours.push_back({kind.palette[k], kind.palette[k + 1], kind.palette[k + 2]});
    if (!colours.empty()) png_set_PLTE(png, info, colours.data(), static_cast<int>(colours.size()));
    if (!kind.palette_alpha.empty())
        png_set_tRNS(png, info, kind.palette_alpha.data(), static_cast<int>(kind.palette_alpha.size()), nullptr);
}

}  // namespace

std::string png(const PngKind& kind, uint32_t width, uint32_t height, std::vector<uint8_t> rows)
{
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, nullptr);
    png_set_IHDR(png, info, width, height, kind.depth, kind.colour,
                 kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    set_palette(png, info, kind);
    png_write_info(png, info);
    const size_t row_bytes = png_get_rowbytes(png, info);
    if (rows.size() != row_bytes * height) throw std::invalid_argument("these are not the bytes of the picture's rows");
    std::vector<png_bytep> starts;
    for (size_t y = 0; y < height; ++y) starts.push_back(rows.data() + y * row_bytes);
    png_write_image(png, starts.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

std::string rgb_png(uint32_t width, const std::vector<uint8_t>& rgb)
{
    return png({PNG_COLOR_TYPE_RGB}, width, static_cast<uint32_t>(rgb.size()) / 3 / width, rgb);
}

std::string jpeg(int width, int height, bool grey, bool progressive)
{
    std::vector<uint8_t> rgb;
    for (int k = 0; k < width * height; ++k) {
        rgb.insert(rgb.end(), {static_cast<uint8_t>(k % width * 255 / width),
                               static_cast<uint8_t>(k / width * 255 / height), static_cast<uint8_t>(grey ? 90 : 9)});
    }
    tjhandle encoder = tjInitCompress();
    unsigned char* packed = nullptr;
    unsigned long size = 0;
    tjCompress2(encoder, rgb.data(), width, 0, height, TJPF_RGB, &packed, &size, grey ? TJSAMP_GRAY : TJSAMP_420, 95,
                progressive ? TJFLAG_PROGRESSIVE : 0);
    std::string bytes(reinterpret_cast<const char*>(packed), size);
    tjFree(packed);
    tjDestroy(encoder);
    return bytes;
}

}  // namespace lumi::baker::testing
