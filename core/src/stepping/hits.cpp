// SPDX-License-Identifier: MIT
#include "lumi/detail/stepping/hits.h"

#include "math/generate.h"
#include "lumi/detail/register_hints.h"

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
    uint16_t arc_turns18[kArcSteps + 2];            // atan(k/64) in units of 2^-18 turn; the last one twice
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
    for (int k = 0; k <= kArcSteps + 1; ++k) {
        const double turns =
            generate::arc_tangent(static_cast<double>(k > kArcSteps ? kArcSteps : k) / kArcSteps) / (2 * generate::kPi);
        t.arc_turns18[k] = static_cast<uint16_t>(turns * 262144 + 0.5);
    }
    return t;
}

constexpr Tables kTables = make_tables();

// Armv6-M has neither CLZ nor UDIV; both twins give the same bits.
#if defined(__ARM_ARCH_6M__)
constexpr bool kDivides = false;

int leading_zeros(uint32_t v)
{
    int count = 0;
    if (v < 1u << 16) {
        v <<= 16;
        count = 16;
    }
    for (; v < 1u << 24; v <<= 4) count += 4;
    for (; v < 1u << 31; v <<= 1) ++count;
    return count;
}
#else
constexpr bool kDivides = true;

int leading_zeros(uint32_t v)
{
    return __builtin_clz(v);
}
#endif

int32_t add_steps(int32_t value, int32_t step, int32_t count)
{
    // Modulo 2^32: the sum is in range where the pixel is covered, whatever the product overflows to.
    return static_cast<int32_t>(static_cast<uint32_t>(value) +
                                static_cast<uint32_t>(step) * static_cast<uint32_t>(count));
}

// A Q40 quantity as Q28 modulo 2^32, and the 12 bits below.
struct Split {
    uint32_t high, low;

    explicit Split(int64_t v_q40)
        : high(static_cast<uint32_t>(static_cast<uint64_t>(v_q40) >> 12)), low(static_cast<uint32_t>(v_q40) & 0xFFFu)
    {
    }
};

// a.at(x, y) >> 12 modulo 2^32, x and y in the image, without a 64-bit product.
int32_t affine_q28(const AffineQ40& a, uint32_t x, uint32_t y)
{
    const Split origin(a.at_origin);
    const Split dx(a.step_x);
    const Split dy(a.step_y);
    const uint32_t carried = (origin.low + x * dx.low + y * dy.low) >> 12;
    return static_cast<int32_t>(origin.high + x * dx.high + y * dy.high + carried);
}

// Angle of small/large in [0, 1], large > 0, in units of 2^-27 turn.
uint32_t octant_turns27(uint32_t small, uint32_t large)
{
    const uint32_t ratio = ratio_q15(small, large);
    constexpr uint32_t kShift = 9;  // 2^15 / kArcSteps
    const uint16_t* entry = &kTables.arc_turns18[ratio >> kShift];
    return (static_cast<uint32_t>(entry[0]) << kShift) +
           static_cast<uint32_t>(entry[1] - entry[0]) * (ratio & ((1u << kShift) - 1));
}

}  // namespace

CoarseReciprocal coarse_reciprocal(uint32_t v)
{
    const int shift = leading_zeros(v);
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
    const int shift = leading_zeros(v_q30) & ~1;
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

uint32_t ratio_q15(uint32_t small, uint32_t large)
{
    if (kDivides) return (small << 15) / large;
    // The table's quotient is off by a few units at most; the remainder puts it right, so that all cores agree.
    const CoarseReciprocal r = coarse_reciprocal(large);
    uint32_t ratio = (small * static_cast<uint32_t>(r.mantissa)) >> (r.exponent - 15);
    int32_t remainder = static_cast<int32_t>((small << 15) - ratio * large);
    for (; remainder < 0; remainder += static_cast<int32_t>(large)) --ratio;
    for (; remainder >= static_cast<int32_t>(large); remainder -= static_cast<int32_t>(large)) ++ratio;
    return ratio;
}

NodeEvaluator::NodeEvaluator(const Camera& camera)
    : camera_(camera),
      eye_direction_q15_{camera.eye_direction.x >> 15, camera.eye_direction.y >> 15, camera.eye_direction.z >> 15},
      inverse_distance_q15_(camera.inverse_distance_q30 >> 15),
      perpendicular_q15_(camera.perpendicular_q30 >> 15),
      step_q28_{}
{
    for (int k = 0; k < 4; ++k) step_q28_[k] = static_cast<int32_t>(Split(source(k).step_x).high);
}

RayRow NodeEvaluator::row_at(int32_t x, int32_t y) const
{
    RayRow row;
    for (int k = 0; k < 4; ++k) {
        row.value_q28[k] = affine_q28(source(k), static_cast<uint32_t>(x), static_cast<uint32_t>(y));
    }
    return row;
}

RayRow NodeEvaluator::moved(const RayRow& row, int32_t right_px, int32_t down_px) const
{
    RayRow to;
    for (int k = 0; k < 4; ++k) {
        const auto step_y_q28 = static_cast<int32_t>(Split(source(k).step_y).high);
        to.value_q28[k] = add_steps(add_steps(row.value_q28[k], step_q28_[k], right_px), step_y_q28, down_px);
    }
    return to;
}

LUMI_ALWAYS_INLINE NodeEvaluator::Ray NodeEvaluator::ray(const RayRow& row, int32_t ahead) const
{
    const auto q15 = [&](int k) { return add_steps(row.value_q28[k], step_q28_[k], ahead) >> 13; };
    const int32_t px = q15(0);
    const int32_t py = q15(1);
    const int32_t pz = q15(2);
    const int32_t m = q15(3);
    const int32_t offset2_q30 = px * px + py * py + pz * pz;
    const int32_t half_chord2 = m * m - perpendicular_q15_ * (offset2_q30 >> 15);
    return {px, py, pz, m, offset2_q30, half_chord2 > 0 ? static_cast<uint32_t>(half_chord2) : 0};
}

int32_t NodeEvaluator::half_chord_q15(const RayRow& row, int32_t ahead) const
{
    return coarse_root_q15(ray(row, ahead).half_chord2_q30);
}

void NodeEvaluator::evaluate(const RayRow& row, int32_t ahead, SpanNode& out) const
{
    evaluate_sides<true>(row, ahead, out);
}

void NodeEvaluator::evaluate_front(const RayRow& row, int32_t ahead, SpanNode& out) const
{
    evaluate_sides<false>(row, ahead, out);
}

template <bool kBack>
LUMI_ALWAYS_INLINE void NodeEvaluator::evaluate_sides(const RayRow& row, int32_t ahead, SpanNode& out) const
{
    const Ray r = ray(row, ahead);
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
    const auto set = [&](SpanHit& hit, int32_t axial, int32_t radial) {
        hit.x_q15 = (eye_direction_q15_.x * axial + px * radial) >> 15;
        hit.y_q15 = (eye_direction_q15_.y * axial + py * radial) >> 15;
        const int32_t z_q15 = (eye_direction_q15_.z * axial + pz * radial) >> 15;
        hit.z_q30 = z_q15 * inverse.mantissa * to_q30;
        hit.longitude_turns32 = coarse_angle_turns32(hit.y_q15, hit.x_q15);
    };
    set(out.front, (lift + along) >> 15, m - shrink);
    if constexpr (kBack) set(out.back, (lift - along) >> 15, m + shrink);
}

}  // namespace lumi
