// SPDX-License-Identifier: MIT
// Lines to a texel: through places that are uniform over it, from directions by their cosine, as all lines in space
// meet it. Each texel draws its own, so that the numbers of its light paths are stratified among themselves: few of
// them do what many do that chance sends there.
#pragma once

#include <optional>

#include "fit/fit_shape.h"
#include "geometry/accelerator.h"
#include "math/sampler.h"

namespace lumi::baker
{

// A line from the unit sphere to a place of the patch's texel, which other things may hide; none where the place drawn
// lies beside the patch, whose triangle covers a part of its rectangle only. `texel` counts from the patch's first.
std::optional<Ray> texel_line(const FitShape& shape, uint32_t patch, uint32_t texel, Sampler& sampler);

}  // namespace lumi::baker
