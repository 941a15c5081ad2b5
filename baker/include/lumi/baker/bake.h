// SPDX-License-Identifier: MIT
// Bakes a scene into a field file: L(i,j) for every used origin i and every direction j.
//
// Ray (i,j) starts on the tangent disc of area 4πR²/M at origin point i, at a position that every sample draws anew,
// and aims at direction point j (Fink et al., "LumiPath", MICCAI 2019, section 2.1).
#pragma once

#include <cstdint>
#include <filesystem>

#include "lumi/baker/progress.h"
#include "lumi/baker/scene.h"
#include "lumi/field_format.h"

namespace lumi::baker
{

struct BakeSettings {
    uint32_t origins = 1024;     // M
    uint32_t directions = 2048;  // N
    uint32_t used_origins = 0;   // rows to bake, a cap around the north pole; 0 = all M
    format::TexelFormat texel = format::TexelFormat::rgb565;
    uint32_t samples = 16;  // light paths per texel
    uint64_t seed = 1;
    unsigned threads = 0;  // 0 = as many as the machine has
};

// What could not be baked or written; what() names the setting or the file and the mend.
struct BakeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Length of the file that bake_field writes. Throws BakeError for settings that no version 1 field can hold.
uint64_t field_file_bytes(const BakeSettings& settings);

// Writes `output` + ".part" and renames it when complete: on failure or cancellation an earlier output is untouched and
// the .part file is removed. The bytes depend on scene, settings and seed, never on `threads`.
// Memory: the field, plus the scene. Throws BakeError, Cancelled.
void bake_field(const Scene& scene, const BakeSettings& settings, const std::filesystem::path& output,
                const ProgressCallback& progress = {});

}  // namespace lumi::baker
