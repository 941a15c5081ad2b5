// SPDX-License-Identifier: MIT
// Three numbers that are affine in a surface point, the larger part of what an origin costs a pixel. Armv6-M reaches
// eight registers and Armv7-M reads two words in one instruction where it is asked to; compilers make neither fit, so
// both are written out. The same bits as the portable sums.
#pragma once

#include <cstdint>

#include "lumi/detail/register_hints.h"
#include "lumi/guided/surface_point.h"

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
#elif defined(__thumb2__) && defined(__OPTIMIZE__)
LUMI_ALWAYS_INLINE PointSums point_sums(const ChartAxes& axes, const SquaredPoint& point)
{
    register uint32_t distance2_q28 __asm("r8");
    register uint32_t u_q22 __asm("r12");
    register uint32_t v_q22 __asm("lr");
    const ChartAxes* form = &axes;
    // r4 to r6 hold X, r9 to r11 a form's factors; a form's constant comes into the register of its sum.
    __asm(
        "ldmia %[point], {r4, r5, r6, r8}\n\t"
        "ldmia %[form]!, {r9, r10, r11, r12}\n\t"
        "mla r8, r9, r4, r8\n\t"
        "mla r8, r10, r5, r8\n\t"
        "mla r8, r11, r6, r8\n\t"
        "add r8, r8, r12\n\t"
        "ldmia %[form]!, {r9, r10, r11, r12}\n\t"
        "mla r12, r9, r4, r12\n\t"
        "mla r12, r10, r5, r12\n\t"
        "mla r12, r11, r6, r12\n\t"
        "ldmia %[form], {r9, r10, r11, lr}\n\t"
        "mla lr, r9, r4, lr\n\t"
        "mla lr, r10, r5, lr\n\t"
        "mla lr, r11, r6, lr"
        : [form] "+r"(form), "=r"(distance2_q28), "=r"(u_q22), "=r"(v_q22)
        : [point] "r"(&point)
        : "r4", "r5", "r6", "r9", "r10", "r11", "memory");
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
