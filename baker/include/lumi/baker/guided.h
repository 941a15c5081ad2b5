// SPDX-License-Identifier: MIT
// Bakes a scene into a guided field (lumi/guided_format.h): every origin looks at a surface that all of them share.
//
// A texel is the light along rays from its origin that meet the surface around its grid point: the far end is spread
// over a part of the grid cell, the near end is the origin itself. Samples whose true depth is another one than the
// surface's do not count.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "lumi/baker/bake.h"
#include "lumi/baker/proxy.h"
#include "lumi/guided/guided_format.h"

namespace lumi::baker
{

struct GuidedSettings {
    uint32_t origins = 128;     // M
    uint32_t used_origins = 0;  // a cap around the north pole; 0 = all M
    uint32_t chart_size = 100;  // G
    format::GuidedTexel texel = format::GuidedTexel::index4;
    format::GuidedSurface surface = format::GuidedSurface::proxy;
    uint32_t proxy_triangles = 4000;
    uint32_t mean_resolution = 96;  // 0: no mean; the texels then hold colours themselves
    format::MeanFormat mean_format = format::MeanFormat::palette8;
    bool occlusion = true;
    // Of GuidedSurface::focus, in scene units and axes; nothing: the sphere's centre.
    std::optional<std::array<float, 3>> focus;
    float focus_radius = 0;  // scene units; 0: the point of each ray that is nearest to the focus
    uint32_t samples = 16;   // light paths a texel
    float jitter = 0.6f;     // radius of a texel's samples, in radii of the disc that has its share of the area
    uint64_t seed = 1;
    unsigned threads = 0;  // 0 = as many as the machine has
};

struct GuidedBake {
    std::vector<uint8_t> file;
    uint32_t triangles = 0, vertices = 0;
    bool two_sided = false;
    ProxyLoss loss;
    uint64_t texels = 0;
    uint32_t mean_bricks = 0;
};

// The bytes depend on scene, settings and seed, never on `threads` or the cache. Memory: some dozen bytes a texel.
// Throws BakeError for settings that no field can hold, Cancelled.
GuidedBake guided_field(const Scene& scene, const GuidedSettings& settings, const ProgressCallback& progress = {},
                        ProxyCache* cache = nullptr);

// Length of the file that guided_field makes, without a light path traced. sampled_origins > 0: an estimate, from so
// many charts that lie evenly spread; it is right to about a hundredth for 16. Throws as guided_field does.
uint64_t guided_file_bytes(const Scene& scene, const GuidedSettings& settings, ProxyCache& cache,
                           uint32_t sampled_origins = 0, const ProgressCallback& progress = {});

// Writes `output` when all is done, as bake_field does: until then an earlier file of that name stays as it was, and
// the checkpoint keeps what is traced, origin by origin. What is not kept is derived again when a bake goes on: the
// proxy, the mean's fit and the palettes. Disk: 13 bytes a texel and 24 bytes for each point that the mean is fitted
// to. Throws BakeError, Cancelled; either way the checkpoint stays.
GuidedBake bake_guided(const Scene& scene, const GuidedSettings& settings, const std::filesystem::path& output,
                       const ProgressCallback& progress = {}, Earlier earlier = Earlier::resume);

// The same for one shard of the origins, as bake_shard does. Each shard fits the mean for itself: that share of the
// work is not divided.
void bake_guided_shard(const Scene& scene, const GuidedSettings& settings, const Shard& shard,
                       const std::filesystem::path& output, const ProgressCallback& progress = {},
                       Earlier earlier = Earlier::resume);

}  // namespace lumi::baker
