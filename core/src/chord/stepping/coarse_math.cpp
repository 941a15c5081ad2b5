// SPDX-License-Identifier: MIT
#include "chord/stepping/coarse_math.h"

#include "math/generate.h"

namespace lumi::detail
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
    for (int k = 0; k <= kReciprocalSteps; ++k)
        t.reciprocal_q15[k] = static_cast<uint16_t>(32768.0 * kReciprocalSteps / (kReciprocalSteps + k) + 0.5);
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

}  // namespace lumi::detail
