// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>

#include "baking/measurements.h"
#include "baking/ray_log.h"
#include "baking/texels.h"
#include "scene/obj_reader.h"

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

Json share_of(const Scene& scene, const std::string& name, unsigned count)
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
    const Json row = {{"scene", name},
                      {"triangles", scene.triangle_count()},
                      {"rays_a_path", all / paths},
                      {"paths_per_s", paths / bake},
                      {"rays_per_s", all / bake},
                      {"embree_rays_per_s", all / embree},
                      {"embree_share", embree / bake}};
    return Json::array({row});
}

std::string name_of(const char* file)
{
    return std::filesystem::path(file).filename();
}

}  // namespace

Json share(const char* scene_file, unsigned count)
{
    return share_of(load(scene_file), name_of(scene_file), count);
}

Json matt_share(const char* obj_file, unsigned count)
{
    return share_of(load_matt(obj_file), name_of(obj_file) + ", all matt", count);
}

}  // namespace lumi::baker::bench
