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

// The encoded colours of a field's rows, or none where most rays miss.
std::vector<std::optional<Rgb8>> colours(const Scene& scene, Rows rows, uint32_t samples, uint64_t seed)
{
    rows.settings.samples = samples;
    rows.settings.seed = seed;
    rows.settings.max_error_levels = 0;
    std::vector<std::optional<Rgb8>> result;
    trace_rows(scene, rows, [&](uint32_t, uint32_t, const Estimate& estimate) {
        result.push_back(estimate.mostly_covered() ? std::optional(estimate.colour()) : std::nullopt);
    });
    return result;
}

double rms_levels(const std::vector<std::optional<Rgb8>>& found, const std::vector<std::optional<Rgb8>>& truth)
{
    double squares = 0;
    size_t count = 0;
    for (size_t k = 0; k < found.size(); ++k) {
        if (found[k] && truth[k]) {
            const int r = found[k]->r - truth[k]->r, g = found[k]->g - truth[k]->g, b = found[k]->b - truth[k]->b;
            squares += r * r + g * g + b * b;
            count += 3;
        }
    }
    return std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

Json convergence(const char* scene_file, unsigned count)
{
    const Scene scene = load(scene_file);
    Rows rows = {{}, count};
    rows.settings.origins = 4096;
    rows.settings.directions = 64;
    const auto truth = colours(scene, rows, kTruth, kTruthSeed);
    std::vector<double> errors;
    for (const uint32_t paths : kSteps) errors.push_back(rms_levels(colours(scene, rows, paths, 1), truth));
    const double slope = std::log(errors.back() / errors.front()) / std::log(1.0 * *std::rbegin(kSteps) / kSteps[0]);
    const Json row = {{"scene", std::filesystem::path(scene_file).filename()},
                      {"paths", kSteps},
                      {"errors", errors},
                      {"exponent", slope}};
    return Json::array({row});
}

}  // namespace lumi::baker::bench
