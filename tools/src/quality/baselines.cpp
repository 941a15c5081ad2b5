// SPDX-License-Identifier: MIT
#include "quality/baselines.h"

#include "bench/sprites.h"
#include "lumi/baker/bake.h"

namespace lumi::quality
{

namespace
{

baker::BakeSettings chord_settings(uint32_t side, const BaselineSettings& settings)
{
    baker::BakeSettings bake;
    bake.origins = bake.directions = side;
    bake.samples = settings.chord_samples;
    bake.threads = settings.threads;
    return bake;
}

}  // namespace

uint32_t chord_side(uint64_t bytes)
{
    const auto fits = [&](uint32_t side) { return baker::field_file_bytes(chord_settings(side, {})) <= bytes; };
    uint32_t low = 0, high = 1;
    while (fits(high)) high *= 2;
    while (high - low > 1) {
        const uint32_t middle = (low + high) / 2;
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

Measured measured_chord(const baker::Scene& scene, uint64_t bytes, const BaselineSettings& settings,
                        const std::filesystem::path& cache, const std::vector<HeldOutView>& views,
                        const std::vector<Truth>& truths, const baker::ProgressCallback& progress)
{
    const uint32_t side = chord_side(bytes);
    const std::string name = "chord-" + std::to_string(side) + "-spp" + std::to_string(settings.chord_samples);
    const std::filesystem::path file = cache / cache_key(scene) / (name + ".lumi");
    if (!std::filesystem::exists(file)) baker::bake_field(scene, chord_settings(side, settings), file, progress);
    Measured result = measured_field(tools::FieldFile(file.string()), views, truths);
    result.name = "chord field " + std::to_string(side) + " x " + std::to_string(side);
    return result;
}

std::optional<Measured> measured_sprites(const baker::Scene& scene, uint64_t bytes, const BaselineSettings& settings,
                                         const std::vector<HeldOutView>& views, const std::vector<Truth>& truths)
{
    std::optional<Measured> best;
    for (const int side : {bench::kSidePx, bench::kSidePx / 2, bench::kSidePx / 3}) {
        const uint64_t sprite_bytes = uint64_t{2} * static_cast<uint64_t>(side * side);
        const auto count = static_cast<uint32_t>(bytes / sprite_bytes);
        if (count == 0) continue;
        const auto draw = [&](const HeldOutView& view) {
            return bench::sprite_picture(scene, count, view.view, settings.sprite_samples, side);
        };
        const std::string name = std::to_string(count) + " sprites, " + std::to_string(side) + " px";
        Measured sheet = measured(name, "sprites", count * sprite_bytes, draw, views, truths);
        if (!best || sheet.mean.psnr_db > best->mean.psnr_db) best = std::move(sheet);
    }
    return best;
}

}  // namespace lumi::quality
