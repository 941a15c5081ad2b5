// SPDX-License-Identifier: MIT
#include "surface/planes.h"

namespace lumi::detail
{

namespace
{

LUMI_ALWAYS_INLINE uint32_t squared(const Length& e)
{
    return static_cast<uint32_t>(e.x_q6 * e.x_q6) + static_cast<uint32_t>(e.y_q6 * e.y_q6);
}

}  // namespace

// Seen along the longest edge, and only along that one, the third corner lies between its ends: no sample gets more or
// less of a quantity than the corners have.
Shares shares_of_sliver(Facing& f)
{
    const Length bc = {f.ac.x_q6 - f.ab.x_q6, f.ac.y_q6 - f.ab.y_q6};
    const uint32_t ab2 = squared(f.ab), ac2 = squared(f.ac), bc2 = squared(bc);
    uint32_t length2 = ab2;
    if (bc2 > ab2 && bc2 > ac2) {
        f = {f.b, f.c, f.a, bc, {-f.ab.x_q6, -f.ab.y_q6}};
        length2 = bc2;
    } else if (ac2 > ab2) {
        f = {f.a, f.c, f.b, f.ac, f.ab};
        length2 = ac2;
    }
    if (length2 < 1 << 12) return {0, 0, 0, 0};  // shorter than a sample
    const Reciprocal r = reciprocal(length2);
    return {over_area(f.ab.x_q6, r), over_area(f.ab.y_q6, r), 0, 0};
}

}  // namespace lumi::detail
