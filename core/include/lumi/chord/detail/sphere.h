// SPDX-License-Identifier: MIT
// Rasterizes the unit sphere: which pixels of a scanline a camera's sphere covers, and where a pixel's ray enters and
// leaves.
#pragma once

#include "lumi/chord/camera.h"
#include "lumi/stripe.h"

namespace lumi::detail
{

// Describes a pixel's ray that hits the sphere, by the quantities of camera.h. All are at most 1.
struct SphereRay {
    int32_t facing_q30;        // m > 0
    Vec3q30 offset;            // P
    int32_t offset2_q30;       // |P|²
    uint64_t half_chord2_q60;  // s², whose root is 2^-9 to 1
};

// The ray through the centre of pixel (x, y) of the image; false if it misses the sphere, is tangential or the sphere
// lies behind.
bool ray_at(const Camera& camera, int32_t x, int32_t y, SphereRay& out);

// Where a ray enters (front) and leaves (back) the sphere: unit vectors. For the ray that the camera's numbers describe
// the error is below 2^-23 for eyes within 10 R, and below 2^-17 for the farthest. For the ray of the pose itself the
// camera's roundings count, too: an implementation in double precision measured 2^-20, and 2^-15.6 at the rim, where
// rays are almost tangents.
struct SphereHits {
    Vec3q30 front, back;
};
SphereHits hits(const Camera& camera, const SphereRay& ray);

// The pixels [begin, end) of a scanline of the image whose rays hit the sphere, within [x_begin, x_end): exact, as
// ray_at decides. The sphere's outline is convex, so they are one extent. Nothing beside the image is covered. Empty:
// both x_begin.
Extent covered_extent(const Camera& camera, int32_t y, int32_t x_begin, int32_t x_end);

// Returns the smallest rectangle with all of these pixels.
PixelRect covered_rectangle(const Camera& camera);

}  // namespace lumi::detail
