// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "commands.h"
#include "ray_log.h"
#include "texels.h"

namespace lumi::baker::bench
{
namespace
{

constexpr int kRepetitions = 5;  // the least disturbed one counts

template <class Measure>
double least(const Measure& measure)
{
    double seconds = measure();
    for (int k = 1; k < kRepetitions; ++k) {
        seconds = std::min(seconds, measure());
    }
    return seconds;
}

double seconds_to_trace(const Scene& scene, const Rows& rows)
{
    const double start = thread_seconds();
    trace_rows(scene, rows, [](uint32_t, uint32_t, const Estimate&) {});
    return thread_seconds() - start;
}

}  // namespace

void print_share(const char* scene_file, unsigned count)
{
    const Scene scene = load(scene_file);
    Rows rows = {{}, count};
    rows.settings.origins = rows.settings.directions = 1448;
    start_ray_log();
    seconds_to_trace(scene, rows);
    stop_ray_log();
    const RayCounts rays = logged_rays();
    const double bake = least([&] { return seconds_to_trace(scene, rows); });
    const double embree = least([] { return replay_ray_log().seconds; });
    const auto paths = static_cast<double>(rows.paths()), all = static_cast<double>(rays.all());
    std::printf("| `%s` | %zu | %.1f | %.2f | %.2f | %.2f | %.0f %% |\n",
                std::filesystem::path(scene_file).filename().c_str(), scene.triangle_count(), all / paths,
                1e-6 * paths / bake, 1e-6 * all / bake, 1e-6 * all / embree, 100 * embree / bake);
}

}  // namespace lumi::baker::bench
