// SPDX-License-Identifier: MIT
#include "surface/surface_settings.h"

#include "lumi/surface/format.h"
#include "store/require.h"

namespace lumi::baker
{

void require_possible_surface(const SurfaceSettings& s)
{
    constexpr float kShortest = 0.02f, kLongest = 2, kDensest = 4096;
    require(s.triangles >= 1 && s.triangles <= 2 * format::kMaxPatches,
            "the number of triangles must lie in 1 to " + std::to_string(2 * format::kMaxPatches));
    require(s.longest_edge >= kShortest && s.longest_edge <= kLongest, "the longest edge must lie in 0.02 to 2 radii");
    require(s.texels_per_radius >= 1 && s.texels_per_radius <= kDensest,
            "the density of texels must lie in 1 to 4096 a radius");
    require(s.cap > 0 && s.cap <= 1, "the cap must be more than 0 and at most 1");
    require(s.paths_per_texel >= 1, "the number of light paths a texel must be at least 1");
}

}  // namespace lumi::baker
