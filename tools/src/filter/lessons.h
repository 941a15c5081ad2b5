// SPDX-License-Identifier: MIT
// The views that a filter learns from, those that tell when to stop, and those that it is judged by.
#pragma once

#include <string>

#include "filter/drawing.h"
#include "lumi/baker/scene.h"
#include "quality/references.h"

namespace lumi::filter
{

struct LessonSettings {
    int views = 300, side_px = 240;
    uint32_t samples = 16;  // light paths a pixel of the references to learn from; noise averages out in learning
    uint64_t seed = 1;
    unsigned threads = 0;
    std::string cache;  // folder of references
};

// Those that judge have so many times the light paths.
inline constexpr uint32_t kJudgesSamples = 4;

struct Views {
    std::vector<quality::HeldOutView> training, validation, test;
};

// In the proportions of the LumiPath paper, 2220 : 204 : 195. Directions are a Spherical Fibonacci set over the
// uppermost `cap` of the sphere, dealt out at random; distances are uniform from 2.5 to 4 radii, the sphere filling the
// frame. Precondition: at least 3 views.
Views lesson_views(const LessonSettings& settings, double cap);

// The share of the sphere that the field shows.
double cap_of(const tools::FieldFile& field);

// Views to be judged by: what is drawn of each, and its reference.
struct Trial {
    std::vector<Planes> drawn;
    std::vector<quality::Reference> references;
};

struct Lessons {
    std::vector<Pair> training, validation;
    Trial test;
};

// Traces the references that the cache does not hold, and draws their views. Throws Cancelled; those traced stay.
Lessons lessons_of(const tools::FieldFile& field, const baker::Scene& scene, const LessonSettings& settings,
                   const baker::ProgressCallback& progress);

// Measures what a filter does to views that it has not learned from.

struct Verdict {
    quality::Figures drawn, filtered;  // means over the views
    int views = 0;
    // Where filtering lowers a measure: PSNR, SSIM or CW-SSIM falls, or FLIP rises.
    int worse_psnr = 0, worse_ssim = 0, worse_cw_ssim = 0, worse_flip = 0;
    double milliseconds = 0;  // processor time of the fastest view; 0 where pictures stay as they are drawn
};

// `network`: null where pictures stay as they are drawn.
Verdict verdict_on(Network* network, const Trial& trial);

std::string text_of(const Verdict& verdict);
std::string json_of(const Verdict& verdict);

}  // namespace lumi::filter
