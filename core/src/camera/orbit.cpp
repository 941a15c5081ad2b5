// SPDX-License-Identifier: MIT
#include "lumi/orbit.h"

#include "lumi/detail/math.h"

namespace lumi
{
namespace
{

using namespace detail;

constexpr int64_t kMarginQ20 = (106 * int64_t{kOneQ20} + 50) / 100;

// sqrt(e² - 1), Q20, with as many bits as the root has. e > 1.
uint64_t tangent_length_q30(int32_t distance_q20)
{
    const uint64_t square_q40 = static_cast<uint64_t>(wide_product(distance_q20, distance_q20)) - (uint64_t{1} << 40);
    int shift = 0;
    while ((square_q40 << shift) < uint64_t{1} << 60) shift += 2;  // has 62 bits at most
    const uint64_t root = square_root(square_q40 << shift);        // Q(20 + shift/2), 30 or 31 bits
    const int down = 20 + shift / 2 - 30;
    return down >= 0 ? root >> down : root << -down;
}

// The field of view of which half has the tangent across/along, within what a camera takes.
uint32_t angle_of(uint64_t across, uint64_t along)
{
    while ((across | along) >= uint64_t{1} << 30) across >>= 1, along >>= 1;
    const uint32_t half = angle_turns32(static_cast<int32_t>(across), static_cast<int32_t>(along));
    if (half > kMaxFovTurns32 / 2) return kMaxFovTurns32;
    return half < kMinFovTurns32 / 2 ? kMinFovTurns32 : 2 * half;
}

}  // namespace

uint32_t fit_sphere(int32_t width_px, int32_t height_px, int32_t distance_q20)
{
    if (distance_q20 <= kOneQ20 || distance_q20 > kMaxEyeDistanceQ20) return kMaxFovTurns32;
    // The silhouette is a cone whose half angle has the tangent 1/sqrt(e² - 1); the longer side shows more by the ratio
    // of the sides.
    const bool is_wide = width_px > height_px;
    const int64_t longer = is_wide ? width_px : height_px, shorter = is_wide ? height_px : width_px;
    uint64_t across = static_cast<uint64_t>(longer * kMarginQ20) << 10;                  // Q30, below 2^44
    uint64_t along = static_cast<uint64_t>(shorter) * tangent_length_q30(distance_q20);  // Q30, below 2^54
    return angle_of(across, along);
}

uint32_t zoomed(uint32_t fov_turns32, uint32_t zoom_q16)
{
    const SinCos half = sin_cos(fov_turns32 / 2);  // both are positive, Q30
    return angle_of(static_cast<uint64_t>(half.sin_q30) << 16, static_cast<uint64_t>(half.cos_q30) * zoom_q16);
}

Image image_of(const Orbit& orbit, int32_t width_px, int32_t height_px)
{
    const bool fits = orbit.fov_turns32 == kFitSphere, zooms = orbit.zoom_q16 != 0 && orbit.zoom_q16 != kNoZoom;
    const uint32_t fov = fits ? fit_sphere(width_px, height_px, orbit.distance_q20) : orbit.fov_turns32;
    const bool is_valid = fov >= kMinFovTurns32 && fov <= kMaxFovTurns32;  // else make_camera finds the fault
    return {width_px, height_px, zooms && is_valid ? zoomed(fov, orbit.zoom_q16) : fov};
}

}  // namespace lumi
