// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <iterator>

#include "baking/measurements.h"
#include "baking/texels.h"

namespace lumi::baker::bench
{
namespace
{

constexpr uint32_t kSteps[] = {4, 16, 64, 256};
constexpr uint32_t kTruth = 4096;
constexpr uint32_t kTruthSeed = 2;

Colours colours(const Scene& scene, Rows rows, uint32_t samples, uint64_t seed)
{
    rows.settings.samples = samples;
    rows.settings.seed = seed;
    rows.settings.max_error_levels = 0;
    Colours result;
    trace_rows(scene, rows, [&](const Estimate& estimate) { result.push_back(colour_of(estimate)); });
    return result;
}

}  // namespace

Json convergence(const char* scene_file, unsigned count)
{
    const Scene scene = load(scene_file);
    Rows rows = {{}, count};
    rows.settings.origins = 4096;
    rows.settings.directions = 64;
    const Colours truth = colours(scene, rows, kTruth, kTruthSeed);
    std::vector<double> errors;
    for (const uint32_t paths : kSteps) errors.push_back(difference(colours(scene, rows, paths, 1), truth).rms);
    const double slope = std::log(errors.back() / errors.front()) / std::log(1.0 * *std::rbegin(kSteps) / kSteps[0]);
    const Json row = {{"scene", std::filesystem::path(scene_file).filename()},
                      {"paths", kSteps},
                      {"errors", errors},
                      {"exponent", slope}};
    return Json::array({row});
}

}  // namespace lumi::baker::bench
