// SPDX-License-Identifier: MIT
#include "lumi/span_node.h"

#include "generate.h"

namespace lumi
{
namespace
{

constexpr int kReciprocalSteps = 128;
constexpr int kRootSteps = 192;
constexpr int kArcSteps = 64;

struct Tables {
    uint16_t reciprocal_q15[kReciprocalSteps + 1];  // 2^15·128/(128 + k): 1/v for v in [1, 2]
    uint16_t root_q16[kRootSteps + 1];              // sqrt((64 + k)/256), v in [1/4, 1]
    uint16_t arc_turns18[kArcSteps + 1];            // atan(k/64) in units of 2^-18 turn
};

constexpr Tables make_tables()
{
    Tables t{};
    for (int k = 0; k <= kReciprocalSteps; ++k) {
        t.reciprocal_q15[k] = static_cast<uint16_t>(32768.0 * kReciprocalSteps / (kReciprocalSteps + k) + 0.5);
    }
    for (int k = 0; k <= kRootSteps; ++k) {
        const double v = generate::root((64 + k) / 256.0) * 65536 + 0.5;
        t.root_q16[k] = static_cast<uint16_t>(v > 65535 ? 65535 : v);
    }
    for (int k = 0; k <= kArcSteps; ++k) {
        const double turns = generate::arc_tangent(static_cast<double>(k) / kArcSteps) / (2 * generate::kPi);
        t.arc_turns18[k] = static_cast<uint16_t>(turns * 262144 + 0.5);
    }
    return t;
}

constexpr Tables kTables = make_tables();

int32_t saturated_q28(int64_t v_q40)
{
    const int64_t v = v_q40 >> 12;
    return v > INT32_MAX ? INT32_MAX : v < INT32_MIN ? INT32_MIN : static_cast<int32_t>(v);
}

int32_t add_steps(int32_t value, int32_t step, int32_t count)
{
    // Modulo 2^32: the sum is in range where the pixel is covered, whatever the product overflows to.
    return static_cast<int32_t>(static_cast<uint32_t>(value) +
                                static_cast<uint32_t>(step) * static_cast<uint32_t>(count));
}

// Angle of small/large in [0, 1], both Q15, large > 0, in units of 2^-18 turn·2^9 (Q27 turns).
uint32_t octant_turns27(uint32_t small, uint32_t large)
{
    const CoarseReciprocal r = coarse_reciprocal(large);
    const uint32_t ratio_q15 = (small * static_cast<uint32_t>(r.mantissa)) >> (r.exponent - 15);
    constexpr uint32_t kShift = 9;  // 2^15 / kArcSteps
    const uint32_t index = ratio_q15 >> kShift;
    if (index >= kArcSteps) return static_cast<uint32_t>(kTables.arc_turns18[kArcSteps]) << kShift;
    const uint32_t a = kTables.arc_turns18[index];
    const uint32_t b = kTables.arc_turns18[index + 1];
    return (a << kShift) + (b - a) * (ratio_q15 & ((1u << kShift) - 1));
}

}  // namespace

CoarseReciprocal coarse_reciprocal(uint32_t v)
{
    const int shift = __builtin_clz(v);
    const uint32_t m_q31 = v << shift;  // [1, 2) in Q31
    const uint32_t index = (m_q31 >> 24) & 127u;
    const uint32_t part_q16 = (m_q31 >> 8) & 0xFFFFu;
    const uint32_t a = kTables.reciprocal_q15[index];
    const uint32_t b = kTables.reciprocal_q15[index + 1];
    const uint32_t mantissa = a - (((a - b) * part_q16 + 0x8000u) >> 16);
    return {static_cast<int32_t>(mantissa), 46 - shift};  // v = m·2^(31-shift)
}

int32_t coarse_root_q15(uint32_t v_q30)
{
    if (v_q30 == 0) return 0;
    const int shift = __builtin_clz(v_q30) & ~1;
    const uint32_t m_q32 = v_q30 << shift;  // [1/4, 1)
    const uint32_t index = (m_q32 >> 24) - 64;
    const uint32_t part_q16 = (m_q32 >> 8) & 0xFFFFu;
    const uint32_t a = kTables.root_q16[index];
    const uint32_t b = kTables.root_q16[index + 1];
    const uint32_t root_q16 = a + (((b - a) * part_q16) >> 16);
    return static_cast<int32_t>(root_q16 >> (shift / 2));  // sqrt(v·2^-30)·2^15 = sqrt(m)·2^(16 - shift/2)
}

uint32_t coarse_angle_turns32(int32_t y, int32_t x)
{
    const uint32_t ax = static_cast<uint32_t>(x < 0 ? -x : x);
    const uint32_t ay = static_cast<uint32_t>(y < 0 ? -y : y);
    if ((ax | ay) == 0) return 0;
    constexpr uint32_t kQuarter = 1u << 30;
    uint32_t angle = ay <= ax ? octant_turns27(ay, ax) << 5 : kQuarter - (octant_turns27(ax, ay) << 5);
    if (x < 0) angle = 2 * kQuarter - angle;
    return y < 0 ? 0u - angle : angle;
}

RowNodes::RowNodes(const Camera& camera, int32_t x, int32_t y)
    : eye_direction_q15_{camera.eye_direction.x >> 15, camera.eye_direction.y >> 15, camera.eye_direction.z >> 15},
      inverse_distance_q15_(camera.inverse_distance_q30 >> 15),
      perpendicular_q15_(camera.perpendicular_q30 >> 15),
      facing_q28_(saturated_q28(camera.facing.at(x, y))),
      facing_step_q28_(saturated_q28(camera.facing.step_x))
{
    for (int k = 0; k < 3; ++k) {
        offset_q28_[k] = saturated_q28(camera.offset[k].at(x, y));
        offset_step_q28_[k] = saturated_q28(camera.offset[k].step_x);
    }
}

SpanNode RowNodes::at(int32_t ahead) const
{
    const auto q15 = [&](int32_t v, int32_t step) { return (add_steps(v, step, ahead) + (1 << 12)) >> 13; };
    const int32_t m = q15(facing_q28_, facing_step_q28_);
    const int32_t px = q15(offset_q28_[0], offset_step_q28_[0]);
    const int32_t py = q15(offset_q28_[1], offset_step_q28_[1]);
    const int32_t pz = q15(offset_q28_[2], offset_step_q28_[2]);

    const int32_t offset2_q30 = px * px + py * py + pz * pz;
    const int32_t offset2_q15 = offset2_q30 >> 15;
    const int32_t half_chord2 = m * m - perpendicular_q15_ * offset2_q15;
    const uint32_t half_chord2_q30 = half_chord2 > 0 ? static_cast<uint32_t>(half_chord2) : 0;
    const int32_t s = coarse_root_q15(half_chord2_q30);
    const CoarseReciprocal inverse = coarse_reciprocal((half_chord2_q30 + static_cast<uint32_t>(offset2_q30)) >> 14);
    const int shift = inverse.exponent - 16;  // 1/q = mantissa·2^-shift

    const int32_t lift = inverse_distance_q15_ * offset2_q15;
    const int32_t along = s * m;
    const int32_t shrink = (inverse_distance_q15_ * s) >> 15;
    const auto hit = [&](int32_t axial_q30, int32_t radial_q15) {
        const int32_t a = ((axial_q30 >> 15) * inverse.mantissa) >> shift;
        // Up to 2^31: unsigned. m ± s/e is never negative, since m² - s²/e² = q·(1 - 1/e²).
        const int32_t r = static_cast<int32_t>(
            (static_cast<uint32_t>(radial_q15) * static_cast<uint32_t>(inverse.mantissa)) >> shift);
        const int32_t hx = (eye_direction_q15_.x * a + px * r) >> 15;
        const int32_t hy = (eye_direction_q15_.y * a + py * r) >> 15;
        const int32_t hz = eye_direction_q15_.z * a + pz * r;
        return SpanHit{coarse_angle_turns32(hy, hx), hx, hy, hz};
    };
    return {hit(lift + along, m - shrink), hit(lift - along, m + shrink)};
}

}  // namespace lumi
