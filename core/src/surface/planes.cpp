// SPDX-License-Identifier: MIT
#include "surface/planes.h"

namespace lumi::surfaces
{

Shares shares_of_sliver(const Length& ab, const Length& ac)
{
    const Length bc = {ac.x_q6 - ab.x_q6, ac.y_q6 - ab.y_q6};
    const int32_t of_c = extent(ab), of_b = extent(ac), of_a = extent(bc);  // of the edge opposite
    const bool along_ab = of_c >= of_b && of_c >= of_a, along_ac = !along_ab && of_b >= of_a;
    const Length longest = along_ab ? ab : along_ac ? ac : bc;
    const uint32_t length2 =
        static_cast<uint32_t>(longest.x_q6 * longest.x_q6) + static_cast<uint32_t>(longest.y_q6 * longest.y_q6);
    if (length2 < 1 << 12) return {0, 0, 0, 0};  // shorter than a sample
    const Reciprocal r = reciprocal(length2);
    const int32_t right = over_area(longest.x_q6, r), down = over_area(longest.y_q6, r);
    if (along_ab) return {right, down, 0, 0};
    if (along_ac) return {0, 0, right, down};
    return {-right, -down, right, down};  // from b to c; the corner a lies beside that edge, by less than a sample
}

}  // namespace lumi::surfaces
