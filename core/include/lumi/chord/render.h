// SPDX-License-Identifier: MIT
// Draws a field into stripes of pixels.
//
//     Camera camera; make_camera(orbit(az, el, dist), {240, 240, fov}, camera);
//     Stripe stripe = {buffer, 0, y, 240, 16, 480};
//     render<Linear, TexelRgb565, PixelRgb565Swapped>(field, camera, OverColour{{0, 0, 0}}, stripe);
//
// Stateless and re-entrant: a stripe may be any rectangle of the image (or beside it), stripes may be drawn in any
// order and on several cores at once. Any rectangle shows the same pixels as any other. Nothing is allocated; stack use
// is stated in docs/boards.md.
// Policies are templates: what a firmware does not name is not linked.
#pragma once

#include "lumi/background.h"
#include "lumi/camera.h"
#include "lumi/chord/reconstruction.h"
#include "lumi/chord/sphere.h"
#include "lumi/chord/texel.h"
#include "lumi/field.h"
#include "lumi/pixel.h"
#include "lumi/stripe.h"

namespace lumi
{

enum class [[nodiscard]] RenderError : uint8_t{
    none = 0,
    wrong_texel_format,  // the field holds another texel format than the policy
    unfit_for_spans,     // render_spans() only: see fits_spans(); render() draws this field
};

// Draws one scanline of covered pixels, every pixel evaluated exactly. `pixels` is where pixel extent.begin lies.
template <class Reconstruction, class Texel, class Pixel, class Background>
void draw_exact(const Field& field, const Camera& camera, const Background& background, const Extent& extent, int32_t y,
                uint8_t* pixels)
{
    for (int32_t x = extent.begin; x < extent.end; ++x, pixels += Pixel::kBytes) {
        SphereRay ray;
        Gathered sums;
        if (ray_at(camera, x, y, ray)) {
            const SphereHits hit = hits(camera, ray);
            sums = gather<Reconstruction, Texel>(field, hit.front, hit.back);
        }
        Pixel::store(pixels, sums.over(background.template under<Pixel>(pixels)));
    }
}

// Writes `count` pixels of a background of the kind that fills.
template <class Pixel, class Background>
void fill_pixels(const Background& background, uint8_t* pixel, int32_t count)
{
    if constexpr (kKeepsCoverage<Background>) {
        __builtin_memset(pixel, 0, static_cast<uint32_t>(count) * Pixel::kBytes);
    } else {
        const Rgb8 colour = background.template under<Pixel>(nullptr);
#pragma GCC unroll 8
        for (int32_t k = 0; k < count; ++k, pixel += Pixel::kBytes) Pixel::store(pixel, colour);
    }
}

// Writes the background on both sides of a scanline's covered extent, where the background is of the kind that fills:
// never beside the stripe, wherever the extent lies.
template <class Pixel, class Background>
void fill_beside(const Background& background, const Stripe& stripe, const Extent& extent, int32_t y)
{
    if (!Background::kFills) return;
    const auto within = [](int32_t x, int32_t from, int32_t to) { return x < from ? from : x < to ? x : to; };
    const int32_t left = stripe.x_px;
    const int32_t right = stripe.right_px();
    const int32_t begin = within(extent.begin, left, right);
    const int32_t end = within(extent.end, begin, right);
    fill_pixels<Pixel>(background, pixel_of<Pixel>(stripe, left, y), begin - left);
    fill_pixels<Pixel>(background, pixel_of<Pixel>(stripe, end, y), right - end);
}

// Draws every pixel of the stripe. Over a constant colour the whole stripe is written; over the stripe's own content
// only pixels that the sphere covers are touched.
template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError render(const Field& field, const Camera& camera, const Background& background, const Stripe& stripe)
{
    if (field.texel_format != Texel::kFormat) return RenderError::wrong_texel_format;
    for (int32_t y = stripe.y_px; y < stripe.bottom_px(); ++y) {
        const Extent extent = covered_extent(camera, y, stripe.x_px, stripe.right_px());
        fill_beside<Pixel>(background, stripe, extent, y);
        if (extent.begin >= extent.end) continue;
        draw_exact<Reconstruction, Texel, Pixel>(field, camera, background, extent, y,
                                                 pixel_of<Pixel>(stripe, extent.begin, y));
    }
    return RenderError::none;
}

}  // namespace lumi
