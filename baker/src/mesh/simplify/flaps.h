// SPDX-License-Identifier: MIT
// Leaves out flaps: small surfaces at edges of more than two triangles, as meshes that were scanned or made coarser
// have them by the thousand.
#pragma once

#include <cstdint>
#include <vector>

#include "math/vec3.h"

namespace lumi::baker
{

// Corners of triangles, three by three, without those surfaces that are smaller than `small`, in square radii, that
// hang at the rest by an edge and leave no hole in it. No body loses more than a fiftieth of its area. A body is what
// shares no vertex with the rest. `surfaces`: by triangle, which it is of, numbers below that of the corners.
std::vector<uint32_t> without_flaps(const std::vector<Vec3>& positions, const std::vector<uint32_t>& corners,
                                    const std::vector<uint32_t>& surfaces, double small);

}  // namespace lumi::baker
