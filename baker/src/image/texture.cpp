// SPDX-License-Identifier: MIT
#include "image/texture.h"

#include "image/picture_bytes.h"
#include "image/srgb.h"

namespace lumi::baker
{
namespace
{

int wrapped(int64_t i, int size)
{
    const int64_t r = i % size;
    return static_cast<int>(r < 0 ? r + size : r);
}

Rgb pixel(const Texture& t, int64_t x, int64_t y)
{
    const size_t row = static_cast<size_t>(wrapped(y, t.height)) * static_cast<size_t>(t.width);
    const uint8_t* p = &t.rgb[3 * (row + static_cast<size_t>(wrapped(x, t.width)))];
    if (t.encoded) return {srgb_decode(p[0]), srgb_decode(p[1]), srgb_decode(p[2])};
    constexpr float kUnit = 1.0f / 255;
    return {static_cast<float>(p[0]) * kUnit, static_cast<float>(p[1]) * kUnit, static_cast<float>(p[2]) * kUnit};
}

float height_at(const Texture& t, int x, int y)
{
    return pixel(t, x, y).r;
}

uint8_t byte_of(float component)
{
    return static_cast<uint8_t>(std::lround((component * 0.5f + 0.5f) * 255));
}

// Grey pictures of one part of each pixel.
void spread(const std::vector<uint8_t>& part, std::vector<uint8_t>& rgb)
{
    for (size_t k = 0; k < part.size(); ++k) std::fill_n(&rgb[3 * k], 3, part[k]);
}

std::vector<uint8_t> blue_of(const std::vector<uint8_t>& rgb)
{
    std::vector<uint8_t> result;
    for (size_t k = 2; k < rgb.size(); k += 3) result.push_back(rgb[k]);
    return result;
}

}  // namespace

Rgb Texture::at(const Vec2& uv) const
{
    // Only the fraction counts; taken in double so that far-off coordinates keep their pixel.
    const double u = uv.x - std::floor(static_cast<double>(uv.x));
    const double v = uv.y - std::floor(static_cast<double>(uv.y));
    const double x = u * width - 0.5;
    const double y = (1 - v) * height - 0.5;
    const int64_t x0 = static_cast<int64_t>(std::floor(x));
    const int64_t y0 = static_cast<int64_t>(std::floor(y));
    const float fx = static_cast<float>(x - static_cast<double>(x0));
    const float fy = static_cast<float>(y - static_cast<double>(y0));
    const Rgb top = pixel(*this, x0, y0) * (1 - fx) + pixel(*this, x0 + 1, y0) * fx;
    const Rgb bottom = pixel(*this, x0, y0 + 1) * (1 - fx) + pixel(*this, x0 + 1, y0 + 1) * fx;
    return top * (1 - fy) + bottom * fy;
}

Texture normals_from_heights(const Texture& heights, float strength)
{
    constexpr float kSlope = 255.0f / 32 / 2;  // heights are compared over two pixels
    Texture result{heights.width, heights.height, {}, false};
    result.rgb.reserve(heights.rgb.size());
    for (int y = 0; y < heights.height; ++y) {
        for (int x = 0; x < heights.width; ++x) {
            const float right = height_at(heights, x + 1, y) - height_at(heights, x - 1, y);
            const float up = height_at(heights, x, y - 1) - height_at(heights, x, y + 1);
            const Vec3 n = normalized({-right * kSlope * strength, -up * kSlope * strength, 1});
            result.rgb.insert(result.rgb.end(), {byte_of(n.x), byte_of(n.y), byte_of(n.z)});
        }
    }
    return result;
}

bool is_grey(const Texture& texture)
{
    for (size_t k = 0; k + 2 < texture.rgb.size(); k += 3)
        if (texture.rgb[k] != texture.rgb[k + 1] || texture.rgb[k] != texture.rgb[k + 2]) return false;
    return true;
}

Texture read_texture(const std::filesystem::path& file, PictureUse use)
{
    return decode_texture(file, picture_bytes(file), use);
}

Texture decode_texture(const std::filesystem::path& name, const std::string& bytes, PictureUse use)
{
    const bool with_alpha = use == PictureUse::alpha || use == PictureUse::opacity;
    if (!is_png(bytes) && !is_jpeg(bytes)) refuse_picture(name, bytes);
    DecodedPicture picture = is_png(bytes) ? decode_png(bytes, with_alpha) : decode_jpeg(bytes);
    if (use == PictureUse::opacity && picture.alpha.empty()) std::fill(picture.rgb.begin(), picture.rgb.end(), 255);
    spread(use == PictureUse::blue ? blue_of(picture.rgb) : picture.alpha, picture.rgb);
    return {picture.width, picture.height, std::move(picture.rgb), use == PictureUse::colour};
}

}  // namespace lumi::baker
