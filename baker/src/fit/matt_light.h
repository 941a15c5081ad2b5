// SPDX-License-Identifier: MIT
// The light that a matt surface would send is the same for all views, but where the mesh lies beside the scene: there a
// texel shows other places, lit otherwise, from other sides.
#pragma once

#include "fit/fit_model.h"

namespace lumi::baker
{

// Sets `matt` and `alike` of a patch from a pilot's paths, of which the fit will have so many times as many. What views
// differ by is compared with what the noise of paths makes of it.
void learn_matt_light(const FitShape& shape, uint32_t patch, const FitSample* begin, const FitSample* end,
                      double more_paths, FitModel& model);

}  // namespace lumi::baker
