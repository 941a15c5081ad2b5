// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "commands.h"
#include "ray_log.h"
#include "scene/obj_reader.h"
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
    for (int k = 1; k < kRepetitions; ++k) seconds = std::min(seconds, measure());
    return seconds;
}

double seconds_to_trace(const Scene& scene, const Rows& rows)
{
    const double start = thread_seconds();
    trace_rows(scene, rows, [](uint32_t, uint32_t, const Estimate&) {});
    return thread_seconds() - start;
}

// An OBJ file's scene with all surfaces Lambert's.
Scene load_matt(const char* obj)
{
    std::vector<std::string> warnings;
    SceneParts parts = read_obj(obj, warnings);
    for (Material& material : parts.materials) {
        Material matt;
        matt.base = material.base;
        matt.emission = material.emission;
        matt.maps.base = material.maps.base;
        matt.maps.emission = material.maps.emission;
        matt.finish();
        material = matt;
    }
    return build_scene(std::move(parts), {});
}

void print_share(const Scene& scene, const std::string& name, unsigned count)
{
    Rows rows = {{}, count};
    rows.settings.origins = rows.settings.directions = 1448;
    start_ray_log();
    seconds_to_trace(scene, rows);
    stop_ray_log();
    const RayCounts rays = logged_rays();
    const double bake = least([&] { return seconds_to_trace(scene, rows); });
    const double embree = least([] { return replay_ray_log().seconds; });
    const auto paths = static_cast<double>(rows.paths()), all = static_cast<double>(rays.all());
    std::printf("| %s | %zu | %.1f | %.2f | %.2f | %.2f | %.0f %% |\n", name.c_str(), scene.triangle_count(),
                all / paths, 1e-6 * paths / bake, 1e-6 * all / bake, 1e-6 * all / embree, 100 * embree / bake);
}

std::string quoted_name(const char* file)
{
    return "`" + std::filesystem::path(file).filename().string() + "`";
}

}  // namespace

void print_share(const char* scene_file, unsigned count)
{
    print_share(load(scene_file), quoted_name(scene_file), count);
}

void print_matt_share(const char* obj_file, unsigned count)
{
    print_share(load_matt(obj_file), quoted_name(obj_file) + ", all matt", count);
}

}  // namespace lumi::baker::bench
