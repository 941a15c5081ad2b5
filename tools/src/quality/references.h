// SPDX-License-Identifier: MIT
// Quality is measured from held-out views, against path-traced references, which a folder keeps for the next report.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "draw/views.h"
#include "image/picture.h"
#include "lumi/baker/reference.h"

namespace lumi::quality
{

// No bake has aimed at any of these views.
enum class ViewSet : uint8_t { all, upper };
const char* name_of(ViewSet set);

inline constexpr int kHeldOutViews = 12;
inline constexpr int kViewSidePx = 240;

struct HeldOutView {
    double azimuth_deg, elevation_deg, distance;
    tools::Eye eye;
};

// `count` views of side_px × side_px pixels from 2.5 to 4 radii, the sphere filling the frame:
// all: a Spherical Fibonacci set over the whole sphere, turned by kTurnDeg so that it is no field's set of origins;
// upper: the same over the upper half. `cap`: of all, that uppermost share of the sphere.
std::vector<HeldOutView> held_out_views(ViewSet set, int count = kHeldOutViews, int side_px = kViewSidePx,
                                        double cap = 1);

// The view of one orbit, the sphere filling the frame. Throws UsageError where it cannot be drawn.
HeldOutView view_at(double azimuth_deg, double elevation_deg, double distance, int side_px);

// Returns "azimuth 123, elevation -45, distance 3.1".
std::string text_of(const HeldOutView& view);

// The path-traced reference of a view, and where the scene covers it at all.
struct Reference {
    tools::Picture picture;
    tools::Mask mask;
};

// A picture that equals its reference counts as this many dB: means stay finite.
inline constexpr double kIdenticalDb = 99;

struct Figures {
    double psnr_db = 0, ssim = 0, cw_ssim = 0, flip = 0;
    double mask_psnr_db = 0, mask_ssim = 0;  // inside the mask; as the whole where it is empty
};

// Precondition: same_size(picture, reference.picture).
Figures figures_of(const tools::Picture& picture, const Reference& reference);

// The mean of each. Precondition: at least one.
Figures mean_of(const std::vector<Figures>& all);

// The name of a scene in caches: of its fingerprint.
std::string cache_key(const baker::Scene& scene);

// Light paths that references of these views take.
uint64_t rays_of(const std::vector<HeldOutView>& views, const baker::ReferenceSettings& settings);

// Traces, or reads from `cache`: CACHE/SCENE/… .png and -mask.png. Nothing is kept if `cache` is empty. The background
// is black. Throws Failure where the folder cannot be written, Cancelled.
std::vector<Reference> references_of(const baker::Scene& scene, const std::vector<HeldOutView>& views,
                                     const baker::ReferenceSettings& settings, const std::filesystem::path& cache,
                                     const baker::ProgressCallback& progress = {});

}  // namespace lumi::quality
