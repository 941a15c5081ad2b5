// SPDX-License-Identifier: MIT
#include "quality/quick_check.h"

#include <algorithm>
#include <cmath>

#include "quality/measured.h"
#include "quality/references.h"

namespace lumi::quality
{

namespace
{

constexpr int kSidePx = 240;
constexpr uint32_t kSamples = 2;  // light paths a pixel of either reference

double squared_error(const tools::Picture& x, const tools::Picture& a, const tools::Picture& b)
{
    double sum = 0;
    for (size_t i = 0; i < x.rgb.size(); ++i) sum += (1.0 * x.rgb[i] - a.rgb[i]) * (1.0 * x.rgb[i] - b.rgb[i]);
    return sum / static_cast<double>(x.rgb.size());
}

double decibels(double squared_error)
{
    constexpr double kWhite = 255;
    if (squared_error <= 0) return kIdenticalDb;
    return std::min(kIdenticalDb, 10 * std::log10(kWhite * kWhite / squared_error));
}

}  // namespace

double quick_psnr_db(const baker::Scene& scene, const tools::FieldFile& field, double cap, unsigned threads,
                     const baker::ProgressCallback& progress)
{
    const auto views = held_out_views(ViewSet::all, kQuickViews, kSidePx, cap);
    const auto half = [&](uint64_t seed) { return baker::ReferenceSettings{kSamples, seed, threads, false}; };
    const uint64_t rays = rays_of(views, half(1));
    baker::JobSeries series(progress, 2 * rays);
    const auto a = references_of(scene, views, half(1), {}, series.next(rays));
    const auto b = references_of(scene, views, half(2), {}, series.next(rays));
    double sum = 0;
    for (size_t v = 0; v < views.size(); ++v)
        sum += decibels(squared_error(drawn(field, views[v]), a[v].picture, b[v].picture));
    return sum / static_cast<double>(views.size());
}

}  // namespace lumi::quality
