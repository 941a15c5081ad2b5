// SPDX-License-Identifier: MIT
// The light that a surface bake has traced, in sums.
#pragma once

#include "fit/fit_sums.h"
#include "util/job.h"

namespace lumi::baker
{

struct FitState {
    // Borrows both.
    FitState(const FitShape& s, const EncodedTone& t)
        : shape(s), tone(t), expected(empty_model(s)), sums(s, t, expected, White::clips)
    {
    }
    FitState(const FitState&) = delete;
    FitState& operator=(const FitState&) = delete;

    const FitShape& shape;
    const EncodedTone& tone;
    FitModel expected;            // what the pilot found
    std::vector<uint32_t> lines;  // by patch, to each of its texels, the pilot's among them (fit/path_plan.h)
    FitSums sums;                 // equations that are linear around `expected`
    uint32_t batches = 0;         // batches that are in the sums
    uint32_t wanted = 0;          // batches in all, once they are known
    uint64_t paths = 0;
    bool has_pilot = false;
};

// The pilot's result and the sums, as bytes for checkpoints and shards.
std::vector<uint8_t> encode(const FitState& state);
// Whether all batches are in the sums.
bool is_complete(const std::vector<uint8_t>& state);
// Adds the sums to `state`, which takes the pilot's result if it has none. False, with the state spoiled, if the bytes
// are of another pilot or of no state of this shape.
bool add_encoded(const std::vector<uint8_t>& bytes, FitState& state);

// Calls f(patch) for all patches, some at a time.
template <class Function>
void for_patches(const FitShape& shape, Job& job, Function f)
{
    constexpr uint32_t kPatchesATask = 16;
    const auto patches = static_cast<uint32_t>(shape.mesh.patches.size());
    job.run((patches + kPatchesATask - 1) / kPatchesATask, [&](uint32_t task) {
        const uint32_t end = std::min(patches, (task + 1) * kPatchesATask);
        for (uint32_t p = task * kPatchesATask; p < end; ++p) f(p);
    });
}

}  // namespace lumi::baker
