// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/stepping/hits.h"

#include "chord/stepping/coarse_math.h"
#include "lumi/detail/compiler.h"

namespace lumi::detail
{
namespace
{

int32_t add_steps(int32_t value, int32_t step, int32_t count)
{
    // Modulo 2^32: the sum is in range where the pixel is covered, whatever the product overflows to.
    return static_cast<int32_t>(static_cast<uint32_t>(value) +
                                static_cast<uint32_t>(step) * static_cast<uint32_t>(count));
}

// Splits a Q40 quantity into Q28 modulo 2^32, and the 12 bits below.
struct Split {
    uint32_t high, low;

    explicit Split(int64_t v_q40)
        : high(static_cast<uint32_t>(static_cast<uint64_t>(v_q40) >> 12)), low(static_cast<uint32_t>(v_q40) & 0xFFFu)
    {
    }
};

// Returns a.at(x, y) >> 12 modulo 2^32, x and y in the image, without a 64-bit product.
int32_t affine_q28(const AffineQ40& a, uint32_t x, uint32_t y)
{
    const Split first(a.at_first);
    const Split dx(a.step_x);
    const Split dy(a.step_y);
    const uint32_t carried = (first.low + x * dx.low + y * dy.low) >> 12;
    return static_cast<int32_t>(first.high + x * dx.high + y * dy.high + carried);
}

}  // namespace

HitEvaluator::HitEvaluator(const Camera& camera)
    : camera_(camera),
      eye_direction_q15_{camera.eye_direction().x >> 15, camera.eye_direction().y >> 15,
                         camera.eye_direction().z >> 15},
      inverse_distance_q15_(camera.inverse_distance_q30() >> 15),
      perpendicular_q15_(camera.perpendicular_q30() >> 15),
      step_q28_{}
{
    for (int k = 0; k < 4; ++k) step_q28_[k] = static_cast<int32_t>(Split(source(k).step_x).high);
}

ScanlineRays HitEvaluator::rays_from(int32_t x, int32_t y) const
{
    ScanlineRays rays;
    for (int k = 0; k < 4; ++k)
        rays.value_q28[k] = affine_q28(source(k), static_cast<uint32_t>(x), static_cast<uint32_t>(y));
    return rays;
}

ScanlineRays HitEvaluator::moved(const ScanlineRays& rays, int32_t right_px, int32_t down_px) const
{
    ScanlineRays to;
    for (int k = 0; k < 4; ++k) {
        const auto step_y_q28 = static_cast<int32_t>(Split(source(k).step_y).high);
        to.value_q28[k] = add_steps(add_steps(rays.value_q28[k], step_q28_[k], right_px), step_y_q28, down_px);
    }
    return to;
}

LUMI_ALWAYS_INLINE HitEvaluator::Ray HitEvaluator::ray(const ScanlineRays& rays, int32_t ahead) const
{
    const auto q15 = [&](int k) { return add_steps(rays.value_q28[k], step_q28_[k], ahead) >> 13; };
    const int32_t px = q15(0);
    const int32_t py = q15(1);
    const int32_t pz = q15(2);
    const int32_t m = q15(3);
    const int32_t offset2_q30 = px * px + py * py + pz * pz;
    const int32_t half_chord2 = m * m - perpendicular_q15_ * (offset2_q30 >> 15);
    return {px, py, pz, m, offset2_q30, half_chord2 > 0 ? static_cast<uint32_t>(half_chord2) : 0};
}

void HitEvaluator::evaluate(const ScanlineRays& rays, int32_t ahead, HitPair& out) const
{
    const Ray r = ray(rays, ahead);
    const int32_t px = r.px_q15;
    const int32_t py = r.py_q15;
    const int32_t pz = r.pz_q15;
    const int32_t m = r.m_q15;
    const int32_t offset2_q15 = r.offset2_q30 >> 15;
    const int32_t s = coarse_root_q15(r.half_chord2_q30);
    const CoarseReciprocal inverse =
        coarse_reciprocal((r.half_chord2_q30 + static_cast<uint32_t>(r.offset2_q30)) >> 14);
    out.inverse_mantissa = inverse.mantissa;
    out.shift = inverse.exponent - 16;

    const int32_t lift = inverse_distance_q15_ * offset2_q15;
    const int32_t along = s * m;
    const int32_t shrink = (inverse_distance_q15_ * s) >> 15;
    const int32_t to_q30 = 1 << (15 - out.shift);
    const auto set = [&](Hit& hit, int32_t axial, int32_t radial) {
        hit.x_q15 = (eye_direction_q15_.x * axial + px * radial) >> 15;
        hit.y_q15 = (eye_direction_q15_.y * axial + py * radial) >> 15;
        const int32_t z_q15 = (eye_direction_q15_.z * axial + pz * radial) >> 15;
        hit.z_q30 = z_q15 * inverse.mantissa * to_q30;
        hit.longitude_turns32 = coarse_angle_turns32(hit.y_q15, hit.x_q15);
    };
    set(out.front, (lift + along) >> 15, m - shrink);
    set(out.back, (lift - along) >> 15, m + shrink);
}

}  // namespace lumi::detail
