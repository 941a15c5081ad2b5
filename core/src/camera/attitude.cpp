// SPDX-License-Identifier: MIT
#include "lumi/attitude.h"

#include "lumi/detail/math.h"

namespace lumi
{
namespace
{

using namespace detail;

// Returns the turn with numbers of 30 bits: four squares of them fit 64 bits.
Quaternion scaled(const Quaternion& q)
{
    const auto size = [](int32_t c) { return c < 0 ? -static_cast<uint32_t>(c) : static_cast<uint32_t>(c); };
    const uint32_t bits = size(q.w) | size(q.x) | size(q.y) | size(q.z);
    if (bits == 0) return {kOneQ30, 0, 0, 0};
    const int zeros = __builtin_clz(bits);
    const auto to_30_bits = [&](int32_t c) { return zeros < 2 ? c >> (2 - zeros) : c * (1 << (zeros - 2)); };
    return {to_30_bits(q.w), to_30_bits(q.x), to_30_bits(q.y), to_30_bits(q.z)};
}

// Returns the turn as a quaternion of length 1, Q30.
Quaternion normalised(const Quaternion& turn)
{
    const Quaternion q = scaled(turn);
    const auto square = [](int32_t c) { return static_cast<uint64_t>(wide_product(c, c)); };
    const ReciprocalRoot root = reciprocal_root(square(q.w) + square(q.x) + square(q.y) + square(q.z));
    const auto unit = [&](int32_t c) {
        return static_cast<int32_t>((c * static_cast<int64_t>(root.mantissa)) >> (root.exponent - 30));
    };
    return {unit(q.w), unit(q.x), unit(q.y), unit(q.z)};
}

}  // namespace

Pose held_pose(const Quaternion& turn, int32_t distance_q20)
{
    const Quaternion q = normalised(turn);
    const auto twice_sum_q60 = [](int32_t a, int32_t b, int32_t c, int32_t d) {
        return 2 * (wide_product(a, b) + wide_product(c, d));
    };
    const auto twice_sum = [&](int32_t a, int32_t b, int32_t c, int32_t d) {
        return q60_to_q30(twice_sum_q60(a, b, c, d));
    };
    // For a half turn the sum is 2, which Q30 does not hold.
    const auto one_minus = [&](int32_t a, int32_t b) {
        constexpr int64_t kOneQ60 = int64_t{1} << 60;
        return q60_to_q30(kOneQ60 - twice_sum_q60(a, a, b, b));
    };
    const Vec3q30 right = {one_minus(q.y, q.z), twice_sum(q.x, q.y, q.w, q.z), twice_sum(q.x, q.z, -q.w, q.y)};
    const Vec3q30 up = {twice_sum(q.x, q.y, -q.w, q.z), one_minus(q.x, q.z), twice_sum(q.y, q.z, q.w, q.x)};
    const Vec3q30 out = {twice_sum(q.x, q.z, q.w, q.y), twice_sum(q.y, q.z, -q.w, q.x), one_minus(q.x, q.y)};
    const Vec3q20 eye = {mul_q30(out.x, distance_q20), mul_q30(out.y, distance_q20), mul_q30(out.z, distance_q20)};
    return {eye, right, up, {-out.x, -out.y, -out.z}};
}

}  // namespace lumi
