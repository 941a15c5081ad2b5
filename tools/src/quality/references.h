// SPDX-License-Identifier: MIT
// Path-traced references of held-out views, kept in a folder so that the next report need not trace them again.
#pragma once

#include <filesystem>

#include "lumi/baker/reference.h"
#include "quality/figures.h"
#include "quality/held_out.h"

namespace lumi::quality
{

// The name of a scene in caches: of its fingerprint.
std::string cache_key(const baker::Scene& scene);

// Light paths that references of these views take.
uint64_t rays_of(const std::vector<HeldOutView>& views, const baker::ReferenceSettings& settings);

// Traces, or reads from `cache`: CACHE/SCENE/… .png and -mask.png. Nothing is kept if `cache` is empty. The background
// is black. Throws Failure where the folder cannot be written, Cancelled.
std::vector<Reference> references_of(const baker::Scene& scene, const std::vector<HeldOutView>& views,
                                     const baker::ReferenceSettings& settings, const std::filesystem::path& cache,
                                     const baker::ProgressCallback& progress = {});

// Traces what a field would show at best, without antialiasing: one exact ray a pixel, its light free of noise.
std::vector<Reference> one_ray_pictures(const baker::Scene& scene, const std::vector<HeldOutView>& views,
                                        baker::ReferenceSettings settings, const std::filesystem::path& cache,
                                        const baker::ProgressCallback& progress = {});

}  // namespace lumi::quality
