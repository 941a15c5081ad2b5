// SPDX-License-Identifier: MIT
// Bakes a scene into a chord field: L(i,j) for every used origin i and every direction j.
//
// Ray (i,j) starts on the tangent disc of area 4πR²/M at origin point i, at a position that every sample draws anew
// (Fink et al., "LumiPath", MICCAI 2019, section 2.1), and aims at direction point j; other footprints and a parallel
// beam can be chosen.
#pragma once

#include "lumi/baker/bake.h"
#include "lumi/baker/progress.h"
#include "lumi/baker/scene.h"
#include "lumi/chord/format.h"

namespace lumi::baker
{

// The rays whose mean a texel is. Its lattice cells are taken as discs of their points' share of the sphere's area.
enum class Footprint : uint8_t {
    point,   // the one ray from origin point to direction point: sharp and aliased
    origin,  // rays from all over the origin's cell: the paper's
    both,    // as origin, and their directions spread over the direction's cell
};

// How the rays of a texel lie to each other. Without a meaning for Footprint::point, which is one ray.
enum class Beam : uint8_t {
    converging,  // all meet in the direction point
    parallel,    // all have the direction from origin point to direction point: the paper's d(i,j), as we read it
};

struct BakeSettings {
    uint32_t origins = 1024;     // M
    uint32_t directions = 2048;  // N
    uint32_t used_origins = 0;   // rows to bake, a cap around the north pole; 0 = all M
    TexelFormat texel = TexelFormat::rgb565;
    uint32_t samples = 16;  // light paths per texel, at most
    // Adaptive sampling: a texel ends early, after 16, 24, 32, ... paths, once its standard error is below this many
    // steps of 255. 0: every texel takes all its paths.
    float max_error_levels = 1;
    uint64_t seed = 1;
    unsigned threads = 0;  // 0 = as many as the machine has
    Footprint footprint = Footprint::origin;
    Beam beam = Beam::converging;
};

// Length of the file that bake_field writes. Throws BakeError for settings that no version 1 field can hold.
uint64_t field_file_bytes(const BakeSettings& settings);

// Number of origins that a shard bakes. Throws BakeError for settings or shards that cannot be.
uint32_t shard_rows(const BakeSettings& settings, const Shard& shard);

// Writes `output` when all rows are done: until then an earlier file of that name stays as it was. The bytes depend on
// scene, settings and seed, never on `threads`, shards or interruptions.
// A killed process loses the rows being traced, a loss of power also those of the last seconds. A checkpoint of another
// scene, other settings or another program is refused. Disk: twice the field while it is put together. Memory: the
// scene. Throws BakeError, Cancelled; either way the checkpoint stays. While a FileGuard lives (file_guard.h), also
// FileClash, before the work begins.
void bake_field(const Scene& scene, const BakeSettings& settings, const std::filesystem::path& output,
                const ProgressCallback& progress = {}, Earlier earlier = Earlier::resume);

// Does the same for one shard of the rows; `output` becomes a shard file, for merge_shards. A complete shard file of
// the same bake is left as it is; of a damaged one only the damaged rows are traced again.
void bake_shard(const Scene& scene, const BakeSettings& settings, const Shard& shard,
                const std::filesystem::path& output, const ProgressCallback& progress = {},
                Earlier earlier = Earlier::resume);

}  // namespace lumi::baker
