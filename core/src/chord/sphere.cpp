// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/sphere.h"

#include "lumi/detail/math.h"

namespace lumi::detail
{
namespace
{

// A scanline's rays as functions of x, for finding the pixel that looks closest to the sphere's centre. Scaled down by
// a common factor for P and one for m so that every product below fits 64 bits.
struct ScanlineQuadratic {
    int64_t offset2;      // |P|² at x = 0
    int64_t offset_step;  // P·P'
    int64_t step2;        // |P'|²
    int64_t facing, facing_step;
};

constexpr int kFactorBits = 20;

// How far to shift values up to `largest` right so that they take at most kFactorBits bits.
int shift_for(int64_t largest)
{
    int shift = 0;
    while ((largest >> shift) >= int64_t{1} << kFactorBits) ++shift;
    return shift;
}

ScanlineQuadratic scanline_quadratic(const Camera& camera, int32_t x, int32_t y)
{
    int64_t offset[3];
    int64_t step[3];
    int64_t largest = 1;
    for (int k = 0; k < 3; ++k) {
        offset[k] = camera.offset()[k].at(x, y);
        step[k] = camera.offset()[k].step_x;
        if (magnitude(offset[k]) > largest) largest = magnitude(offset[k]);
        if (magnitude(step[k]) > largest) largest = magnitude(step[k]);
    }
    const int shift = shift_for(largest);
    const int64_t facing = camera.facing().at(x, y);
    const int facing_shift = shift_for(magnitude(facing) + magnitude(camera.facing().step_x));
    ScanlineQuadratic scanline{0, 0, 0, facing >> facing_shift, camera.facing().step_x >> facing_shift};
    for (int k = 0; k < 3; ++k) {
        offset[k] >>= shift;
        step[k] >>= shift;
        scanline.offset2 += offset[k] * offset[k];
        scanline.offset_step += offset[k] * step[k];
        scanline.step2 += step[k] * step[k];
    }
    return scanline;
}

// |P|²/m² has one stationary point along a scanline, its minimum:
// x* = x + (|P|² m' - (P·P') m) / (|P'|² m - (P·P') m').
int32_t closest_x(const Camera& camera, int32_t x, int32_t y, Extent limits)
{
    const ScanlineQuadratic scanline = scanline_quadratic(camera, x, y);
    int64_t over = scanline.offset2 * scanline.facing_step - scanline.offset_step * scanline.facing;
    int64_t under = scanline.step2 * scanline.facing - scanline.offset_step * scanline.facing_step;
    if (under < 0) {
        over = -over;
        under = -under;
    }
    if (under == 0) return x;
    const int64_t moved = x + over / under;
    return static_cast<int32_t>(moved < limits.begin ? limits.begin : moved >= limits.end ? limits.end - 1 : moved);
}

bool is_covered(const Camera& camera, int32_t x, int32_t y)
{
    SphereRay ray;
    return ray_at(camera, x, y, ray);
}

// Between a covered and an uncovered pixel: the covered one next to the border.
int32_t border(const Camera& camera, int32_t y, int32_t covered, int32_t uncovered)
{
    while (magnitude(static_cast<int64_t>(covered) - uncovered) > 1) {
        const int32_t middle = covered + (uncovered - covered) / 2;
        (is_covered(camera, middle, y) ? covered : uncovered) = middle;
    }
    return covered;
}

// A covered pixel of the scanline, or limits.end. Apart from the pixels around the closest point, only one of its ends
// can be covered, where the closest point lies behind the eye.
int32_t find_covered(const Camera& camera, int32_t y, Extent limits)
{
    int32_t x = closest_x(camera, limits.begin + (limits.end - limits.begin) / 2, y, limits);
    x = closest_x(camera, x, y, limits);  // again from near by: the factors' bits now resolve a pixel
    const int32_t candidates[] = {x, x - 1, x + 1, limits.begin, limits.end - 1};
    for (const int32_t candidate : candidates)
        if (candidate >= limits.begin && candidate < limits.end && is_covered(camera, candidate, y)) return candidate;
    return limits.end;
}

// |D| <= 1 within the image, up to rounding; a covered pixel's m and |P| are at most |D|. The slack keeps all of Q30.
constexpr int64_t kLimitQ40 = int64_t{5} << 38;
constexpr int64_t kLimitQ60 = int64_t{5} << 58;

int32_t narrow_q30(int64_t v_q40)
{
    return static_cast<int32_t>(v_q40 >> 10);
}

}  // namespace

bool ray_at(const Camera& camera, int32_t x, int32_t y, SphereRay& out)
{
    const int64_t facing_q40 = camera.facing().at(x, y);
    if (facing_q40 <= 0 || facing_q40 > kLimitQ40) return false;
    int64_t offset_q40[3];
    for (int k = 0; k < 3; ++k) {
        offset_q40[k] = camera.offset()[k].at(x, y);
        if (magnitude(offset_q40[k]) > kLimitQ40) return false;
    }
    out.facing_q30 = narrow_q30(facing_q40);
    out.offset = {narrow_q30(offset_q40[0]), narrow_q30(offset_q40[1]), narrow_q30(offset_q40[2])};
    const int64_t offset2_q60 = dot_q60(out.offset, out.offset);
    if (offset2_q60 > kLimitQ60) return false;
    out.offset2_q30 = q60_to_q30(offset2_q60);
    const int64_t half_chord2 =
        wide_product(out.facing_q30, out.facing_q30) - wide_product(camera.perpendicular_q30(), out.offset2_q30);
    if (half_chord2 <= 0) return false;
    const int64_t length2 = half_chord2 + offset2_q60;
    if (half_chord2 < length2 >> kTangentShift) return false;
    out.half_chord2_q60 = static_cast<uint64_t>(half_chord2);
    return true;
}

SphereHits hits(const Camera& camera, const SphereRay& ray)
{
    const int32_t half_chord_q30 = static_cast<int32_t>(square_root(ray.half_chord2_q60));
    const uint64_t length2_q60 = ray.half_chord2_q60 + (static_cast<uint64_t>(ray.offset2_q30) << 30);
    const ReciprocalRoot root = reciprocal_root(length2_q60);
    // Returns 1/q in Q26: q >= 1/26, because the image's corners bound the scale of D.
    const int32_t inverse_q26 =
        static_cast<int32_t>((static_cast<uint64_t>(root.mantissa) * root.mantissa) >> (2 * root.exponent - 86));
    const int32_t lift_q30 = mul_q30(camera.inverse_distance_q30(), ray.offset2_q30);
    const int32_t along_q30 = mul_q30(half_chord_q30, ray.facing_q30);
    const int32_t shrink_q30 = mul_q30(camera.inverse_distance_q30(), half_chord_q30);

    // Numerators are below 2, so 64 bits hold their products.
    const auto over_q = [&](int64_t numerator_q30) { return (numerator_q30 * inverse_q26) >> 26; };
    const auto combine = [&](int64_t axial_q30, int64_t radial_q30) {
        const int32_t a = static_cast<int32_t>(axial_q30);
        const int64_t r_q30 = radial_q30;  // up to 8: the products with P, at most 1 in all, still fit
        const auto component = [&](int32_t e, int32_t p) {
            return static_cast<int32_t>((wide_product(a, e) + r_q30 * p + (int64_t{1} << 29)) >> 30);
        };
        return Vec3q30{component(camera.eye_direction().x, ray.offset.x),
                       component(camera.eye_direction().y, ray.offset.y),
                       component(camera.eye_direction().z, ray.offset.z)};
    };
    return {combine(over_q(static_cast<int64_t>(lift_q30) + along_q30),
                    over_q(static_cast<int64_t>(ray.facing_q30) - shrink_q30)),
            combine(over_q(static_cast<int64_t>(lift_q30) - along_q30),
                    over_q(static_cast<int64_t>(ray.facing_q30) + shrink_q30))};
}

Extent covered_extent(const Camera& camera, int32_t y, int32_t x_begin, int32_t x_end)
{
    const Extent empty = {x_begin, x_begin};
    const Extent limits = {x_begin > 0 ? x_begin : 0, x_end < camera.width_px() ? x_end : camera.width_px()};
    if (y < 0 || y >= camera.height_px() || limits.begin >= limits.end) return empty;
    const int32_t inside = find_covered(camera, y, limits);
    if (inside == limits.end) return empty;
    const int32_t first = border(camera, y, inside, limits.begin - 1);
    const int32_t last = border(camera, y, inside, limits.end);
    return {first, last + 1};
}

PixelRect covered_rectangle(const Camera& camera)
{
    Extent columns = {camera.width_px(), 0}, scanlines = {camera.height_px(), 0};
    for (int32_t y = 0; y < camera.height_px(); ++y) {
        const Extent covered = covered_extent(camera, y, 0, camera.width_px());
        if (covered.begin == covered.end) continue;
        if (covered.begin < columns.begin) columns.begin = covered.begin;
        if (covered.end > columns.end) columns.end = covered.end;
        if (y < scanlines.begin) scanlines.begin = y;
        scanlines.end = y + 1;
    }
    if (columns.end == 0) return {0, 0, 0, 0};
    return {columns.begin, scanlines.begin, columns.end - columns.begin, scanlines.end - scanlines.begin};
}

}  // namespace lumi::detail
