// SPDX-License-Identifier: MIT
#include "image/texture.h"

#include <algorithm>
#include <cmath>

#include "image/picture_bytes.h"
#include "image/tone.h"
#include "lumi/host/png.h"

namespace lumi::baker
{
namespace
{

int64_t repeated(int64_t i, int64_t period)
{
    const int64_t r = i % period;
    return r < 0 ? r + period : r;
}

int64_t wrapped(int64_t i, int size, Wrap wrap)
{
    if (wrap == Wrap::clamp) return std::clamp<int64_t>(i, 0, size - 1);
    if (wrap == Wrap::repeat) return repeated(i, size);
    const int64_t r = repeated(i, int64_t{2} * size);
    return r < size ? r : int64_t{2} * size - 1 - r;
}

// A coordinate without what makes no difference. Taken in double so that far-off coordinates keep their pixel. Where
// there is none, as numbers have overflowed, any pixel will do.
double near_picture(float coordinate, Wrap wrap)
{
    const double c = std::isfinite(coordinate) ? static_cast<double>(coordinate) : 0;
    if (wrap == Wrap::clamp) return std::clamp(c, -1.0, 2.0);
    const double period = wrap == Wrap::repeat ? 1 : 2;
    return c - std::floor(c / period) * period;
}

Rgb pixel(const Texture& t, int64_t x, int64_t y, const std::array<Wrap, 2>& wrap = {Wrap::repeat, Wrap::repeat})
{
    const int64_t row = wrapped(y, t.height, wrap[1]) * t.width;
    const uint8_t* p = &t.rgb[3 * static_cast<size_t>(row + wrapped(x, t.width, wrap[0]))];
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

Rgb Texture::at(const Vec2& uv, const std::array<Wrap, 2>& wrap) const
{
    const double x = near_picture(uv.x, wrap[0]) * width - 0.5;
    const double y = (1 - near_picture(uv.y, wrap[1])) * height - 0.5;
    const int64_t x0 = static_cast<int64_t>(std::floor(x));
    const int64_t y0 = static_cast<int64_t>(std::floor(y));
    const float fx = static_cast<float>(x - static_cast<double>(x0));
    const float fy = static_cast<float>(y - static_cast<double>(y0));
    const auto row = [&](int64_t row_y) {
        return pixel(*this, x0, row_y, wrap) * (1 - fx) + pixel(*this, x0 + 1, row_y, wrap) * fx;
    };
    const Rgb top = row(y0), bottom = row(y0 + 1);
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

Texture read_texture(const std::filesystem::path& file, PictureUse use, PictureRoom* room)
{
    const std::string bytes = picture_bytes(file);
    if (room) {
        room->add(bytes.size());
        room->take(pixels_of(bytes));
    }
    if (is_webp(bytes)) refuse_picture(file, bytes);  // no other program reads it beside an OBJ
    return decode_texture(file, bytes, use);
}

Texture decode_texture(const std::filesystem::path& name, const std::string& bytes, PictureUse use)
{
    const bool with_alpha = use == PictureUse::alpha || use == PictureUse::opacity;
    if (!host::is_png(bytes) && !is_jpeg(bytes) && !is_webp(bytes)) refuse_picture(name, bytes);
    DecodedPicture picture = host::is_png(bytes) ? host::decode_png(bytes, with_alpha)
                             : is_webp(bytes)    ? decode_webp(bytes, with_alpha)
                                                 : decode_jpeg(bytes);
    if (use == PictureUse::opacity && picture.alpha.empty()) std::fill(picture.rgb.begin(), picture.rgb.end(), 255);
    spread(use == PictureUse::blue ? blue_of(picture.rgb) : picture.alpha, picture.rgb);
    return {picture.width, picture.height, std::move(picture.rgb), use == PictureUse::colour};
}

}  // namespace lumi::baker
