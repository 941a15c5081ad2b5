// SPDX-License-Identifier: MIT
#include "lumi/detail/math.h"

#include "math/generate.h"
#include "math/reciprocal.h"

namespace lumi
{
namespace
{

using namespace detail;

constexpr int kSteps = 64;  // table steps per quarter turn (sine) and per unit of the tangent (arc tangent)

struct Tables {
    uint16_t reciprocal_root_q15[192];  // at the middle of [k, k+1)/256, k = 64 .. 255
    int32_t sine_q30[kSteps + 1];       // sin(k/64 · 1/4 turn)
    uint32_t arc_turns32[kSteps + 1];   // atan(k/64) in turns
    int32_t arc_slope_q30[kSteps + 1];  // 1/(1 + (k/64)²)
};

constexpr Tables make_tables()
{
    Tables t{};
    for (int k = 0; k < 192; ++k) {
        const double v = 1.0 / generate::root((64.5 + k) / 256);
        t.reciprocal_root_q15[k] = static_cast<uint16_t>(v * 32768 + 0.5);
    }
    for (int k = 0; k <= kSteps; ++k) {
        const double x = static_cast<double>(k) / kSteps;
        t.sine_q30[k] = static_cast<int32_t>(generate::sine(x * generate::kPi / 2) * kOneQ30 + 0.5);
        t.arc_turns32[k] = static_cast<uint32_t>(generate::arc_tangent(x) / (2 * generate::kPi) * 4294967296.0 + 0.5);
        t.arc_slope_q30[k] = static_cast<int32_t>(kOneQ30 / (1 + x * x) + 0.5);
    }
    return t;
}

constexpr Tables kTables = make_tables();

constexpr int32_t kHalfPiQ30 = 1686629713;    // π/2: turns32 to radians in Q30
constexpr int32_t kTwoOverPiQ30 = 683565276;  // 2/π: radians in Q30 to turns32
constexpr int32_t kSixthQ30 = 178956971;
constexpr int32_t kThirdQ30 = 357913941;

int leading_zeros(uint64_t v)
{
    const uint32_t high = static_cast<uint32_t>(v >> 32);
    return high != 0 ? __builtin_clz(high) : 32 + __builtin_clz(static_cast<uint32_t>(v));
}

// Takes one Newton step for y = 1/sqrt(m): y·(3 - m·y²)/2, m in Q32, y in Q30.
uint32_t newton_step(uint32_t m_q32, uint32_t y_q30)
{
    const uint32_t y2_q29 = static_cast<uint32_t>((static_cast<uint64_t>(y_q30) * y_q30 + (1u << 30)) >> 31);
    const uint32_t my2_q29 = static_cast<uint32_t>((static_cast<uint64_t>(m_q32) * y2_q29 + (1u << 31)) >> 32);
    const uint32_t factor_q30 = (3u << 29) - my2_q29;  // (3 - m·y²)/2 in Q30
    return static_cast<uint32_t>((static_cast<uint64_t>(y_q30) * factor_q30 + (1u << 29)) >> 30);
}

int32_t sine_at(int index)
{
    return kTables.sine_q30[index];
}

// Angle of the ratio r in [0, 1], Q30, in turns32. With r0 the nearest table point, atan(r) - atan(r0) is the arc
// tangent of u = d/(1 + r·r0), expanded in d = r - r0.
uint32_t octant_angle(int32_t ratio_q30)
{
    const int shift = 24;
    const int index = (ratio_q30 + (1 << (shift - 1))) >> shift;
    const int32_t d = ratio_q30 - (index << shift);
    const int32_t x = mul_q30(d, kTables.arc_slope_q30[index]);
    const int32_t y = mul_q30(x, index << shift);
    const int32_t u = x - mul_q30(x, y - mul_q30(y, y));
    const int32_t cube = mul_q30(mul_q30(u, u), u);
    return kTables.arc_turns32[index] + static_cast<uint32_t>(mul_q30(u - mul_q30(cube, kThirdQ30), kTwoOverPiQ30));
}

// Returns small/large in Q30 for 0 <= small <= large, large > 0.
int32_t ratio(uint32_t small, uint32_t large)
{
    const ReciprocalRoot root = reciprocal_root(static_cast<uint64_t>(large) * large);
    const uint64_t product = static_cast<uint64_t>(small) * root.mantissa;
    const uint64_t rounded = (product + (uint64_t{1} << (root.exponent - 31))) >> (root.exponent - 30);
    return rounded > static_cast<uint64_t>(kOneQ30) ? kOneQ30 : static_cast<int32_t>(rounded);
}

constexpr ReciprocalTable make_reciprocals()
{
    ReciprocalTable t{};
    // 2^29 / (256 (k + 1/2)) = 2^22 / (2 k + 1), rounded.
    for (uint32_t k = 128; k < 512; ++k) {
        const uint32_t odd = 2 * k + 1;
        t.q29[k - 128] = static_cast<uint16_t>(((uint32_t{1} << 22) + odd / 2) / odd);
    }
    return t;
}

}  // namespace

constexpr ReciprocalTable detail::kReciprocals = make_reciprocals();

ReciprocalRoot detail::reciprocal_root(uint64_t v)
{
    const int shift = leading_zeros(v) & ~1;
    const uint32_t m_q32 = static_cast<uint32_t>((v << shift) >> 32);  // [1/4, 1)
    uint32_t y_q30 = static_cast<uint32_t>(kTables.reciprocal_root_q15[(m_q32 >> 24) - 64]) << 15;
    y_q30 = newton_step(m_q32, y_q30);
    y_q30 = newton_step(m_q32, y_q30);
    return {y_q30, 62 - shift / 2};  // v = m·2^(64-shift)
}

uint32_t detail::coarse_inverse_root_q15(uint32_t m_q32)
{
    const uint32_t y_q15 = kTables.reciprocal_root_q15[(m_q32 >> 24) - 64];
    const uint32_t my2_q31 = (m_q32 >> 16) * ((y_q15 * y_q15) >> 15);
    const int32_t rest_q16 = static_cast<int32_t>((1u << 31) - my2_q31) >> 15;
    return y_q15 + static_cast<uint32_t>((static_cast<int32_t>(y_q15) * rest_q16) >> 17);
}

uint32_t detail::square_root(uint64_t v)
{
    if (v == 0) return 0;
    const ReciprocalRoot root = reciprocal_root(v);
    const int shift = leading_zeros(v) & ~1;
    const uint64_t m_q32 = (v << shift) >> 32;
    const uint64_t s_q62 = m_q32 * root.mantissa;  // sqrt(m) in Q62
    const uint64_t result = s_q62 >> (30 + shift / 2);
    return result > 0xFFFFFFFFu ? 0xFFFFFFFFu : static_cast<uint32_t>(result);
}

SinCos sin_cos(uint32_t angle)
{
    const uint32_t in_quarter = angle & 0x3FFFFFFFu;
    const int index = static_cast<int>((in_quarter + (1u << 23)) >> 24);
    const int32_t rest = static_cast<int32_t>(in_quarter) - (index << 24);
    const int32_t h = mul_q30(rest, kHalfPiQ30);
    const int32_t h2 = mul_q30(h, h);
    const int32_t odd = h - mul_q30(mul_q30(h, h2), kSixthQ30);
    const int32_t even = h2 / 2;
    const int32_t s0 = sine_at(index);
    const int32_t c0 = sine_at(kSteps - index);
    const int32_t s = s0 + mul_q30(c0, odd) - mul_q30(s0, even);
    const int32_t c = c0 - mul_q30(s0, odd) - mul_q30(c0, even);
    switch (angle >> 30) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

uint32_t detail::angle_turns32(int32_t y, int32_t x)
{
    const uint32_t ax = static_cast<uint32_t>(x < 0 ? -x : x);
    const uint32_t ay = static_cast<uint32_t>(y < 0 ? -y : y);
    if ((ax | ay) == 0) return 0;
    constexpr uint32_t kQuarter = 1u << 30;
    uint32_t angle = ay <= ax ? octant_angle(ratio(ay, ax)) : kQuarter - octant_angle(ratio(ax, ay));
    if (x < 0) angle = 2 * kQuarter - angle;
    return y < 0 ? 0u - angle : angle;
}

int64_t detail::multiply_shift(int64_t a, int32_t b, int shift)
{
    const int64_t high = (a >> 32) * b;
    const int64_t low = static_cast<int64_t>(static_cast<uint32_t>(a)) * b;
    return high * (int64_t{1} << (32 - shift)) + (low >> shift);
}

}  // namespace lumi
