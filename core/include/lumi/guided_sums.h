// SPDX-License-Identifier: MIT
// Three numbers that are affine in a surface point, the larger part of what an origin costs a pixel. Armv6-M reaches
// eight registers and Armv7-M reads two words in one instruction where it is asked to; compilers make neither fit, so
// both are written out. The same bits as the portable sums.
#pragma once

#include <cstdint>

#include "lumi/always_inline.h"
#include "lumi/surface_point.h"

namespace lumi
{

// A surface point X, its components and |X|² modulo 2^32.
struct SquaredPoint {
    uint32_t x_q14, y_q14, z_q14, square_q28;
};

LUMI_ALWAYS_INLINE SquaredPoint squared(const SurfacePoint& point)
{
    const uint32_t x = static_cast<uint32_t>(point.x_q14), y = static_cast<uint32_t>(point.y_q14);
    const uint32_t z = static_cast<uint32_t>(point.z_q14);
    return {x, y, z, x * x + y * y + z * z};
}

// A number that is affine in X, modulo 2^32: constant + x·X.x + y·X.y + z·X.z.
struct PointForm {
    uint32_t x, y, z, constant;
};

// An origin p as its chart needs it: |X - p|² - |X|², and the grid point (u, v) times |X - p|. A unit direction along
// an axis makes (T + B/√3)·G/2 and (2/√3)·B·G/2, |step| <= 231 grid points; products with X - p are the same modulo
// 2^32 whether p is taken off before or after.
struct ChartAxes {
    PointForm distance2_q28, u_q22, v_q22;
};

// The three of X, the first with |X|².
struct PointSums {
    uint32_t distance2_q28, u_q22, v_q22;
};

// Only where all registers may be used: GCC leaves r8 and up alone when it optimises for size.
#if defined(__ARM_ARCH_6M__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
LUMI_ALWAYS_INLINE PointSums point_sums(const ChartAxes& axes, const SquaredPoint& point)
{
    uint32_t distance2_q28, u_q22;
    const ChartAxes* form = &axes;
    const SquaredPoint* sum = &point;
    // r4 to r6 hold X, r2 and r3 the form's words.
    __asm(
        ".syntax unified\n\t"
        "ldmia %[sum]!, {r4, r5, r6}\n\t"
        "ldr %[sum], [%[sum]]\n\t"
        "ldmia %[form]!, {r2, r3}\n\t"
        "muls r2, r4, r2\n\t"
        "muls r3, r5, r3\n\t"
        "adds %[sum], %[sum], r2\n\t"
        "adds %[sum], %[sum], r3\n\t"
        "ldmia %[form]!, {r2, r3}\n\t"
        "muls r2, r6, r2\n\t"
        "adds %[sum], %[sum], r2\n\t"
        "adds %[sum], %[sum], r3\n\t"
        "mov %[distance2], %[sum]\n\t"
        "ldmia %[form]!, {r2, r3}\n\t"
        "muls r2, r4, r2\n\t"
        "muls r3, r5, r3\n\t"
        "adds %[sum], r2, r3\n\t"
        "ldmia %[form]!, {r2, r3}\n\t"
        "muls r2, r6, r2\n\t"
        "adds %[sum], %[sum], r2\n\t"
        "adds %[sum], %[sum], r3\n\t"
        "mov %[u], %[sum]\n\t"
        "ldmia %[form]!, {r2, r3}\n\t"
        "muls r2, r4, r2\n\t"
        "muls r3, r5, r3\n\t"
        "adds %[sum], r2, r3\n\t"
        "ldmia %[form]!, {r2, r3}\n\t"
        "muls r2, r6, r2\n\t"
        "adds %[sum], %[sum], r2\n\t"
        "adds %[sum], %[sum], r3"
        : [sum] "+l"(sum), [form] "+l"(form), [distance2] "=&h"(distance2_q28), [u] "=&h"(u_q22)
        :
        : "r2", "r3", "r4", "r5", "r6", "cc", "memory");
    return {distance2_q28, u_q22, reinterpret_cast<uint32_t>(sum)};
}
#elif defined(__thumb2__)
LUMI_ALWAYS_INLINE PointSums point_sums(const ChartAxes& axes, const SquaredPoint& point)
{
    uint32_t distance2_q28, u_q22, v_q22, x, y, z, a, b;
    __asm(
        "ldrd %[x], %[y], [%[point]]\n\t"
        "ldrd %[z], %[d], [%[point], #8]\n\t"
        "ldrd %[a], %[b], [%[form]]\n\t"
        "mla %[d], %[a], %[x], %[d]\n\t"
        "mla %[d], %[b], %[y], %[d]\n\t"
        "ldrd %[a], %[b], [%[form], #8]\n\t"
        "mla %[d], %[a], %[z], %[d]\n\t"
        "add %[d], %[d], %[b]\n\t"
        "ldrd %[a], %[u], [%[form], #24]\n\t"
        "mla %[u], %[a], %[z], %[u]\n\t"
        "ldrd %[a], %[b], [%[form], #16]\n\t"
        "mla %[u], %[a], %[x], %[u]\n\t"
        "mla %[u], %[b], %[y], %[u]\n\t"
        "ldrd %[a], %[v], [%[form], #40]\n\t"
        "mla %[v], %[a], %[z], %[v]\n\t"
        "ldrd %[a], %[b], [%[form], #32]\n\t"
        "mla %[v], %[a], %[x], %[v]\n\t"
        "mla %[v], %[b], %[y], %[v]"
        : [d] "=&r"(distance2_q28), [u] "=&r"(u_q22), [v] "=&r"(v_q22), [x] "=&r"(x), [y] "=&r"(y), [z] "=&r"(z),
          [a] "=&r"(a), [b] "=&r"(b)
        : [form] "r"(&axes), [point] "r"(&point)
        : "memory");
    return {distance2_q28, u_q22, v_q22};
}
#else
LUMI_ALWAYS_INLINE PointSums point_sums(const ChartAxes& axes, const SquaredPoint& point)
{
    const auto at = [&](const PointForm& form) {
        return form.constant + form.x * point.x_q14 + form.y * point.y_q14 + form.z * point.z_q14;
    };
    return {point.square_q28 + at(axes.distance2_q28), at(axes.u_q22), at(axes.v_q22)};
}
#endif

}  // namespace lumi
