// SPDX-License-Identifier: MIT
// Where a triangle's corners lie in its patch's rectangle of texels.
#pragma once

#include "lumi/detail/register_hints.h"
#include "lumi/surface/detail/pieces.h"

namespace lumi::detail
{

inline constexpr int32_t kInsetQ8 = 256 >> format::kPatchInsetShift;

LUMI_ALWAYS_INLINE Texture texture_of(const SurfacePatch& patch, const SurfaceField& field)
{
    return {field.texels + patch.texels, patch.columns, patch.rows};
}

// Places in the texture of a patch's first triangle (a, b, c) or second one (d, c, b): from its first corner the one
// goes right and down, the other left and up.
struct Places {
    int32_t u_q8, v_q8, across_q8, down_q8;
};

LUMI_ALWAYS_INLINE Places places_of(const SurfacePatch& patch, bool is_first)
{
    const int32_t right = static_cast<int32_t>(patch.columns << 8) - kInsetQ8;
    const int32_t bottom = static_cast<int32_t>(patch.rows << 8) - kInsetQ8;
    if (is_first) return {kInsetQ8, kInsetQ8, right, bottom};
    return {right, bottom, kInsetQ8, kInsetQ8};
}

}  // namespace lumi::detail
