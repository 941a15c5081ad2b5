// SPDX-License-Identifier: MIT
// A field is compared with these at its own size: the paper's chord field, and what firmware does without a field.
#pragma once

#include <vector>

#include "lumi/baker/scene.h"
#include "quality/measured.h"

namespace lumi::quality
{

struct BaselineSettings {
    uint32_t chord_samples = 16;   // light paths a texel
    uint32_t sprite_samples = 16;  // light paths a pixel: their noise is far below the error of a wrong view
    unsigned threads = 0;
};

// M and N of the largest palette8 chord field with as many origins as directions (what shows most per byte) whose file
// takes at most `bytes`; 0 where none fits.
uint32_t chord_side(uint64_t bytes);

// The fields are baked into `cache`, or found there.
Measured measured_chord(const baker::Scene& scene, uint64_t bytes, const BaselineSettings& settings,
                        const std::filesystem::path& cache, const std::vector<HeldOutView>& views,
                        const std::vector<Reference>& references, const baker::ProgressCallback& progress = {});

// As many path-traced sprites as fit into `bytes`, the one nearest to the view turned and scaled onto the screen:
// RGB565, few sharp ones or many coarse ones, whichever looks better; and JPEG of 5.7 kB and 240 × 240 pixels. Of
// either none where not one fits.
std::vector<Measured> measured_sprites(const baker::Scene& scene, uint64_t bytes, const BaselineSettings& settings,
                                       const std::vector<HeldOutView>& views, const std::vector<Reference>& references);

}  // namespace lumi::quality
