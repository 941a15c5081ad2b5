// SPDX-License-Identifier: MIT
#include "fit/sorted_samples.h"

namespace lumi::baker
{

SortedSamples sorted(const std::vector<std::vector<FitSample>>& batches, uint32_t patches)
{
    SortedSamples result;
    result.begins.assign(patches + 1, 0);
    for (const std::vector<FitSample>& batch : batches)
        for (const FitSample& s : batch) ++result.begins[s.triangle / 2 + 1];
    for (uint32_t p = 0; p < patches; ++p) result.begins[p + 1] += result.begins[p];
    std::vector<size_t> next(result.begins.begin(), result.begins.end() - 1);
    result.samples.resize(result.begins.back());
    for (const std::vector<FitSample>& batch : batches)
        for (const FitSample& s : batch) result.samples[next[s.triangle / 2]++] = s;
    return result;
}

}  // namespace lumi::baker
