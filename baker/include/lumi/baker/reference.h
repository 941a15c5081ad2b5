// SPDX-License-Identifier: MIT
// Path-traced pictures for a camera: what a field's picture is compared with.
#pragma once

#include <cstdint>
#include <vector>

#include "lumi/baker/progress.h"
#include "lumi/baker/scene.h"
#include "lumi/chord/camera.h"

namespace lumi::baker
{

// Top row first, 4 bytes a pixel: r, g, b sRGB-encoded and premultiplied by the coverage a. Over a background of
// encoded value b a channel shows c + (255 - a)·b/255.
struct RgbaImage {
    int width = 0, height = 0;
    std::vector<uint8_t> rgba;
};

// That picture in linear light: r, g, b as the scene's lights send it, without its exposure and its tone curve,
// premultiplied by the coverage a, 0 to 1.
struct RadianceImage {
    int width = 0, height = 0;
    std::vector<float> rgba;
};

struct ReferenceSettings {
    uint32_t samples = 64;  // 1: through the pixel's centre; more: spread uniformly over the pixel
    uint64_t seed = 1;
    unsigned threads = 0;  // 0 = as many as the machine has
};

// A ray that misses the scene is not covered; the environment lights the scene but is not seen. The pixels depend on
// scene, camera, samples and seed, never on `threads`. Throws Cancelled; BakeError for samples = 0.
RgbaImage render_reference(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                           const ProgressCallback& progress = {});
RadianceImage trace_radiance(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                             const ProgressCallback& progress = {});

}  // namespace lumi::baker
