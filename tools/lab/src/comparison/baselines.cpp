// SPDX-License-Identifier: MIT
#include "comparison/baselines.h"

#include "comparison/sprites.h"
#include "lumi/baker/chord.h"

namespace lumi::quality
{

namespace
{

baker::BakeSettings chord_settings(uint32_t side, const BaselineSettings& settings)
{
    baker::BakeSettings bake;
    bake.origins = bake.directions = side;
    bake.texel = TexelFormat::palette8;
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
                        const std::vector<Reference>& references, const baker::ProgressCallback& progress)
{
    const uint32_t side = chord_side(bytes);
    const std::string name = "chord8-" + std::to_string(side) + "-spp" + std::to_string(settings.chord_samples);
    const std::filesystem::path file = cache / cache_key(scene) / (name + ".lumi");
    if (!std::filesystem::exists(file)) baker::bake_field(scene, chord_settings(side, settings), file, progress);
    Measured result = measured_field(tools::FieldFile(file.string()), {views, references});
    result.name = "chord field " + std::to_string(side) + " x " + std::to_string(side);
    return result;
}

namespace
{

// As the bench names views.
bench::View bench_view(const HeldOutView& view)
{
    return {"held-out", host::turns32_from_degrees(view.azimuth_deg),
            host::signed_turns32_from_degrees(view.elevation_deg), host::q20_from_radii(view.distance),
            view.eye.image.fov_turns32};
}

std::string title_of(const bench::SpriteSheet& sheet)
{
    return std::to_string(sheet.count) + (sheet.jpeg_bytes != 0 ? " JPEG sprites, " : " sprites, ") +
           std::to_string(sheet.side_px) + " px";
}

uint64_t bytes_of(const bench::SpriteSheet& sheet)
{
    const uint64_t rgb565 = uint64_t{2} * static_cast<uint64_t>(sheet.side_px * sheet.side_px);
    return sheet.jpeg_bytes != 0 ? sheet.jpeg_bytes : rgb565;
}

// Nothing where not one fits.
std::optional<Measured> measured_sheet(const baker::Scene& scene, bench::SpriteSheet sheet, uint64_t bytes,
                                       const std::vector<HeldOutView>& views, const std::vector<Reference>& references)
{
    sheet.count = static_cast<uint32_t>(bytes / bytes_of(sheet));
    if (sheet.count == 0) return std::nullopt;
    const auto draw = [&](const HeldOutView& view) { return bench::sprite_picture(scene, sheet, bench_view(view)); };
    return measured(title_of(sheet), sheet.jpeg_bytes != 0 ? "JPEG sprites" : "sprites", sheet.count * bytes_of(sheet),
                    draw, views, references);
}

}  // namespace

std::vector<Measured> measured_sprites(const baker::Scene& scene, uint64_t bytes, const BaselineSettings& settings,
                                       const std::vector<HeldOutView>& views, const std::vector<Reference>& references)
{
    constexpr uint32_t kJpegBytes = 5700;
    bench::SpriteSheet sheet;
    sheet.samples = settings.sprite_samples;
    std::optional<Measured> best;
    for (const int side : {bench::kSidePx, bench::kSidePx / 2, bench::kSidePx / 3}) {
        sheet.side_px = side;
        auto tried = measured_sheet(scene, sheet, bytes, views, references);
        if (tried && (!best || tried->mean.psnr_db > best->mean.psnr_db)) best = std::move(tried);
    }
    sheet.side_px = bench::kSidePx;
    sheet.jpeg_bytes = kJpegBytes;
    std::vector<Measured> all;
    if (best) all.push_back(std::move(*best));
    if (auto jpegs = measured_sheet(scene, sheet, bytes, views, references)) all.push_back(std::move(*jpegs));
    return all;
}

}  // namespace lumi::quality
