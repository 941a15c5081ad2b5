// SPDX-License-Identifier: MIT
#include <filesystem>

#include "baking/measurements.h"
#include "baking/texels.h"

namespace lumi::baker::bench
{
namespace
{

constexpr uint32_t kTruth = 4096;
constexpr uint64_t kTruthSeed = 2, kChoiceSeed = 3;

struct Setup {
    uint32_t paths;
    float levels;
};
constexpr Setup kSetups[] = {{64, 1}, {256, 1}, {256, 2}};

struct Texels {
    Colours colours;
    uint64_t paths = 0;
};

// Draws texels of a field by lot; all settings get the same ones.
Texels traced(const Scene& scene, unsigned count, uint32_t paths, float levels, uint64_t seed)
{
    BakeSettings settings;
    settings.origins = settings.directions = 1448;
    settings.samples = paths;
    settings.max_error_levels = levels;
    settings.seed = seed;
    const TexelTracer tracer(scene.data(), settings);
    Texels result;
    for (uint32_t k = 0; k < count; ++k) {
        const Vec2 u = Sampler(kChoiceSeed, k, 0).next_2d();
        const uint32_t i = static_cast<uint32_t>(u.x * static_cast<float>(settings.origins));
        const uint32_t j = static_cast<uint32_t>(u.y * static_cast<float>(settings.directions));
        const Estimate estimate = tracer.estimate(tracer.disc(i), i, j);
        result.colours.push_back(colour_of(estimate));
        result.paths += estimate.samples();
    }
    return result;
}

}  // namespace

Json adaptive(const char* scene_file, unsigned count)
{
    const Scene scene = load(scene_file);
    const std::string name = std::filesystem::path(scene_file).filename();
    const Texels truth = traced(scene, count, kTruth, 0, kTruthSeed);
    Json rows = Json::array();
    for (const Setup& setup : kSetups) {
        const Texels all = traced(scene, count, setup.paths, 0, 1);
        const Texels some = traced(scene, count, setup.paths, setup.levels, 1);
        rows.push_back({{"scene", name},
                        {"paths", setup.paths},
                        {"levels", setup.levels},
                        {"error_all", difference(all.colours, truth.colours).rms},
                        {"error_adaptive", difference(some.colours, truth.colours).rms},
                        {"paths_taken", static_cast<double>(some.paths) / count},
                        {"shift", difference(some.colours, all.colours).mean}});
    }
    return rows;
}

}  // namespace lumi::baker::bench
