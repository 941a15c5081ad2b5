// SPDX-License-Identifier: MIT
#include <ctime>
#include <filesystem>

#include "baking/measurements.h"
#include "baking/texels.h"

namespace lumi::baker::bench
{
namespace
{

constexpr uint32_t kPaths = 16;
constexpr uint32_t kTriesATexel = 64;  // before a scene is taken for empty
constexpr uint64_t kChoiceSeed = 3;
constexpr uint64_t kSeeds[] = {1, 2};

struct Place {
    uint32_t i, j;
};

BakeSettings settings_of(uint32_t paths, uint64_t seed)
{
    BakeSettings settings;
    settings.origins = settings.directions = 1448;
    settings.footprint = Footprint::point;
    settings.samples = paths;
    settings.max_error_levels = 0;
    settings.seed = seed;
    return settings;
}

// Rays of a field that meet the scene, drawn by lot.
std::vector<Place> places(const Scene& scene, unsigned count)
{
    const BakeSettings settings = settings_of(1, kChoiceSeed);
    const TexelTracer tracer(scene.data(), settings);
    std::vector<Place> result;
    for (uint32_t k = 0; k < kTriesATexel * count && result.size() < count; ++k) {
        const Vec2 u = Sampler(kChoiceSeed, k, 0).next_2d();
        const Place place = {static_cast<uint32_t>(u.x * static_cast<float>(settings.origins)),
                             static_cast<uint32_t>(u.y * static_cast<float>(settings.directions))};
        if (tracer.estimate(tracer.disc(place.i), place.i, place.j).mostly_covered()) result.push_back(place);
    }
    return result;
}

std::vector<Estimate> estimates(const Scene& scene, const std::vector<Place>& places, uint64_t seed)
{
    const TexelTracer tracer(scene.data(), settings_of(kPaths, seed));
    std::vector<Estimate> result;
    result.reserve(places.size());
    for (const Place& place : places) result.push_back(tracer.estimate(tracer.disc(place.i), place.i, place.j));
    return result;
}

double squared(double x)
{
    return x * x;
}

// The variance of what a path brings home, of the square of its mean, by two estimates of the same rays.
double variance_of_light(const std::vector<Estimate>& one, const std::vector<Estimate>& other)
{
    double squares = 0, sum = 0;
    for (size_t k = 0; k < one.size(); ++k) {
        const double a = static_cast<double>(luminance(one[k].covered_radiance()));
        const double b = static_cast<double>(luminance(other[k].covered_radiance()));
        squares += squared(a - b) / 2;
        sum += (a + b) / 2;
    }
    const double count = static_cast<double>(one.size());
    return kPaths * (squares / count) / squared(sum / count);
}

Colours colours(const std::vector<Estimate>& estimates)
{
    Colours result;
    for (const Estimate& estimate : estimates) result.push_back(colour_of(estimate));
    return result;
}

}  // namespace

Json noise(const char* scene_file, unsigned count)
{
    const Scene scene = load(scene_file);
    const std::vector<Place> chosen = places(scene, count);
    const std::clock_t start = std::clock();
    const std::vector<Estimate> one = estimates(scene, chosen, kSeeds[0]), other = estimates(scene, chosen, kSeeds[1]);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const double paths = 2.0 * kPaths * static_cast<double>(chosen.size());
    return Json::array({{{"scene", std::filesystem::path(scene_file).filename()},
                         {"variance_shown", squared(difference(colours(one), colours(other)).rms) / 2 * kPaths},
                         {"variance_of_light", variance_of_light(one, other)},
                         {"microseconds_a_path", 1e6 * seconds / paths}}});
}

}  // namespace lumi::baker::bench
