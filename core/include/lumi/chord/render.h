// SPDX-License-Identifier: MIT
// Draws a field into stripes of pixels.
//
//     Camera camera; make_camera(pose_of(orbit), image_of(orbit, 240, 240), camera);
//     Stripe stripe = {buffer, 0, y, 240, 16, 480};
//     render<Linear, TexelRgb565, PixelRgb565Swapped>(field, camera, OverColour{{0, 0, 0}}, stripe);
//
// Stateless and re-entrant: a stripe may be any rectangle of the image (or beside it), stripes may be drawn in any
// order and on several cores at once. Any rectangle shows the same pixels as any other. Nothing is allocated; stack use
// is stated in docs/firmware.md.
// Policies are templates: what a firmware does not name is not linked.
#pragma once
#pragma GCC system_header

#include "lumi/background.h"
#include "lumi/chord/camera.h"
#include "lumi/chord/detail/sphere.h"
#include "lumi/chord/field.h"
#include "lumi/chord/reconstruction.h"
#include "lumi/chord/texel.h"

namespace lumi
{

enum class [[nodiscard]] RenderError : uint8_t{
    none = 0,
    wrong_texel_format,  // the field holds another texel format than the policy
    unfit_for_spans,     // render_spans() only: see fits_spans(); render() draws this field
};

}  // namespace lumi

namespace lumi::detail
{

// Draws one scanline of covered pixels, every pixel evaluated exactly. `pixels` is where pixel extent.begin lies.
template <class Reconstruction, class Texel, class Pixel, class Background>
void draw_exact(const Field& field, const Camera& camera, const Background& background, const Extent& extent, int32_t y,
                uint8_t* pixels)
{
    for (int32_t x = extent.begin; x < extent.end; ++x, pixels += Pixel::kBytes) {
        LUMI_TALLY(Work::exact, 1);
        SphereRay ray;
        Gathered sums;
        if (ray_at(camera, x, y, ray)) {
            const SphereHits hit = hits(camera, ray);
            sums = gather<Reconstruction, Texel>(field, hit.front, hit.back);
        }
        Pixel::store(pixels, sums.over(background.template under<Pixel>(pixels)));
    }
}

}  // namespace lumi::detail

namespace lumi
{

// Draws every pixel of the stripe. Over a constant colour the whole stripe is written; over the stripe's own content
// only pixels that the sphere covers are touched.
template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError render(const Field& field, const Camera& camera, const Background& background, const Stripe& stripe)
{
    if (field.texel_format != Texel::kFormat) return RenderError::wrong_texel_format;
    for (int32_t y = stripe.y_px; y < stripe.bottom_px(); ++y) {
        const detail::Extent extent = detail::covered_extent(camera, y, stripe.x_px, stripe.right_px());
        detail::fill_beside<Pixel>(background, stripe, extent, y);
        if (extent.begin >= extent.end) continue;
        detail::draw_exact<Reconstruction, Texel, Pixel>(field, camera, background, extent, y,
                                                         pixel_of<Pixel>(stripe, extent.begin, y));
    }
    return RenderError::none;
}

}  // namespace lumi
