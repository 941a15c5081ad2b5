// SPDX-License-Identifier: MIT
#include "lumi/twin/picture.h"

#include "lumi/chord/texel.h"
#include "viewing.h"

namespace lumi::twin
{
namespace
{

constexpr double kFullyCovered = 255;

detail::Rgba8 load(const Field& field, uint32_t i, uint32_t j)
{
    const uint8_t* row = field.row(i);
    if (row == nullptr) return {0, 0, 0, 0};
    return detail::with_texel(field.texel_format, [&](auto texel) { return decltype(texel)::load(field, row, j); });
}

}  // namespace

Hits hits_of_pixel(const Pose& pose, const Image& image, int32_t x, int32_t y)
{
    const Viewing view(pose, image);
    const Vec3& eye = view.eye();
    const Vec3 d = normalised(view.vector(x + 0.5, y + 0.5));
    const double middle = -dot(eye, d);
    const double half_chord = std::sqrt(std::fmax(0.0, middle * middle - dot(eye, eye) + 1));
    return {normalised(eye + (middle - half_chord) * d), normalised(eye + (middle + half_chord) * d)};
}

Colour blended(const Field& field, const Weights& origins, const Weights& directions, const Rgb8& background)
{
    Colour sum;
    double coverage = 0;
    for (const auto& [i, wi] : origins) {
        for (const auto& [j, wj] : directions) {
            const detail::Rgba8 texel = load(field, i, j);
            sum.r += wi * wj * texel.r;
            sum.g += wi * wj * texel.g;
            sum.b += wi * wj * texel.b;
            coverage += wi * wj * texel.a / kFullyCovered;
        }
    }
    const double rest = 1 - coverage;
    return {sum.r + rest * background.r, sum.g + rest * background.g, sum.b + rest * background.b};
}

}  // namespace lumi::twin
