// SPDX-License-Identifier: MIT
// What a surface bake keeps of the light that it traced.
#pragma once

#include "surface/surface_sums.h"
#include "util/job.h"

namespace lumi::baker
{

struct SurfaceState {
    // Borrows both.
    SurfaceState(const SurfaceShape& s, const EncodedTone& t)
        : shape(s), tone(t), expected(empty_model(s)), sums(s, t, expected, White::clips)
    {
    }
    SurfaceState(const SurfaceState&) = delete;
    SurfaceState& operator=(const SurfaceState&) = delete;

    const SurfaceShape& shape;
    const EncodedTone& tone;
    SurfaceModel expected;  // of the pilot
    SurfaceSums sums;       // linear around it
    uint32_t batches = 0;   // that are in the sums
    uint32_t wanted = 0;    // batches in all, once they are known
    uint64_t paths = 0;
    bool has_pilot = false;
};

// Calls f(patch) for all patches, some at a time.
template <class Function>
void for_patches(const SurfaceShape& shape, Job& job, Function f)
{
    constexpr uint32_t kPatchesATask = 16;
    const auto patches = static_cast<uint32_t>(shape.mesh.patches.size());
    job.run((patches + kPatchesATask - 1) / kPatchesATask, [&](uint32_t task) {
        const uint32_t end = std::min(patches, (task + 1) * kPatchesATask);
        for (uint32_t p = task * kPatchesATask; p < end; ++p) f(p);
    });
}

}  // namespace lumi::baker
