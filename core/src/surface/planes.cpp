// SPDX-License-Identifier: MIT
#include "surface/planes.h"

namespace lumi::detail
{

Shares shares_of_sliver(Facing& f)
{
    const Length bc = {f.ac.x_q6 - f.ab.x_q6, f.ac.y_q6 - f.ab.y_q6};
    const int32_t along_ab = extent(f.ab), along_ac = extent(f.ac), along_bc = extent(bc);
    if (along_bc > along_ab && along_bc > along_ac)
        f = {f.b, f.c, f.a, bc, {-f.ab.x_q6, -f.ab.y_q6}};
    else if (along_ac > along_ab)
        f = {f.a, f.c, f.b, f.ac, f.ab};
    const uint32_t length2 =
        static_cast<uint32_t>(f.ab.x_q6 * f.ab.x_q6) + static_cast<uint32_t>(f.ab.y_q6 * f.ab.y_q6);
    if (length2 < 1 << 12) return {0, 0, 0, 0};  // shorter than a sample
    const Reciprocal r = reciprocal(length2);
    return {over_area(f.ab.x_q6, r), over_area(f.ab.y_q6, r), 0, 0};
}

}  // namespace lumi::detail
