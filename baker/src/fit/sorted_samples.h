// SPDX-License-Identifier: MIT
// Samples in the order of their patches.
#pragma once

#include "fit/sample_tracer.h"

namespace lumi::baker
{

struct SortedSamples {
    std::vector<FitSample> samples;
    std::vector<size_t> begins;  // by patch, and the end

    const FitSample* begin(uint32_t patch) const { return samples.data() + begins[patch]; }
    const FitSample* end(uint32_t patch) const { return samples.data() + begins[patch + 1]; }
};

// Samples of a patch stay in their order.
SortedSamples sorted(const std::vector<std::vector<FitSample>>& batches, uint32_t patches);

}  // namespace lumi::baker
