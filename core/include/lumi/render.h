// SPDX-License-Identifier: MIT
// Draws a field into stripes of pixels.
//
//     Camera camera; make_camera(orbit(az, el, dist), {240, 240, fov}, camera);
//     Stripe stripe = {buffer, 0, y, 240, 16, 480};
//     render<Linear, TexelRgb565, PixelRgb565Swapped>(field, camera, OverColour{{0, 0, 0}}, stripe);
//
// Stateless and re-entrant: a stripe may be any rectangle of the image (or beside it), stripes may be drawn in any
// order and on several cores at once. Nothing is allocated; stack use is stated in docs/architecture.md.
// Policies are templates: what a firmware does not name is not linked.
#pragma once

#include "lumi/background.h"
#include "lumi/camera.h"
#include "lumi/field.h"
#include "lumi/pixel.h"
#include "lumi/reconstruction.h"
#include "lumi/sphere.h"
#include "lumi/texel.h"

namespace lumi {

enum class [[nodiscard]] RenderError : uint8_t {
    none = 0,
    wrong_texel_format,  // the field holds another texel format than the policy
};

// A rectangle of the image in the caller's memory: rows of width_px pixels, stride_bytes apart, top row first.
struct Stripe {
    uint8_t* pixels;
    int32_t x_px, y_px;  // of its first pixel in the image
    int32_t width_px, height_px;
    uint32_t stride_bytes;
};

// Draws every pixel of the stripe: over a constant colour the whole stripe is written, over the stripe's own content
// only covered pixels are.
template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError render(const Field& field, const Camera& camera, const Background& background, const Stripe& stripe);

}  // namespace lumi
