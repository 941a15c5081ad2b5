// SPDX-License-Identifier: MIT
#include "planner/speed.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string_view>

#include "lumi/chord/render_spans.h"
#include "lumi/orbit.h"
#include "quality/references.h"

namespace lumi::planner
{

namespace
{

using tools::Mode;

const std::vector<ChordMode> kModes = {{"paper", Mode::paper}, {"linear", Mode::linear}, {"nearest", Mode::nearest}};

}  // namespace

const std::vector<ChordMode>& chord_modes()
{
    return kModes;
}

namespace
{

// "30fps"; nothing for other texts and rates that are not above 0.
std::optional<double> parse_rate(std::string_view text)
{
    constexpr std::string_view kUnit = "fps";
    constexpr double kMost = 1e6;
    if (text.size() <= kUnit.size() || text.substr(text.size() - kUnit.size()) != kUnit) return std::nullopt;
    const char* const end = text.data() + text.size() - kUnit.size();
    double rate = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, rate);
    if (error != std::errc() || stop != end || !(rate > 0) || rate > kMost) return std::nullopt;
    return rate;
}

// Returns the work that one core does alone: preparing gloss.
FrameWork gloss_of(const FrameWork& work)
{
    FrameWork gloss;
    for (const Work one : {Work::gloss_vertex, Work::gloss_texel}) gloss.done[static_cast<size_t>(one)] = work[one];
    return gloss;
}

}  // namespace

std::optional<Pace> parse_pace(const std::string& text)
{
    const size_t at = text.find('@');
    const std::optional<double> rate =
        at == std::string::npos ? kUsualPace : parse_rate(std::string_view(text).substr(at + 1));
    if (!rate) return std::nullopt;
    for (const Chip& chip : kChipList)
        for (int cores = 1; cores <= chip.cores; ++cores)
            if (text.substr(0, at) == chip.key + (cores == 1 ? std::string() : "x" + std::to_string(cores)))
                return Pace{&chip, *rate, at != std::string::npos, cores};
    return std::nullopt;
}

std::string chip_names()
{
    std::string text;
    for (size_t k = 0; k < kChips; ++k)
        text += (k == 0 ? "" : k + 1 == kChips ? " or " : ", ") + std::string(kChipList[k].key);
    return text;
}

Ram ram_of(const host::SurfaceCounts& field, const host::ScreenSize& screen)
{
    return {host::surface_view_bytes<PixelRgb565>(field, screen), host::stripe_pixel_bytes<PixelRgb565>(screen)};
}

Ram ram_of(const tools::FieldFile& field, SurfaceMode finest, const host::ScreenSize& screen)
{
    if (!field.is_surface())
        return {host::chord_view_bytes(fits_spans(field.field())), host::stripe_pixel_bytes<PixelRgb565>(screen)};
    return ram_of(host::counts_of(field.surface(), finest), screen);
}

uint32_t stack_of(const tools::FieldFile& field)
{
    if (field.is_surface()) return kSurfaceStackBytes;
    return fits_spans(field.field()) ? kSpanStackBytes : kExactStackBytes;
}

// Vertices and tables are read once, a patch once to be listed and once or twice to be filled; of texels, neighbours in
// a scanline share half of the lines.
double surface_misses(const SurfaceField& field, const FrameWork& work, const host::ScreenSize& screen,
                      double line_bytes)
{
    constexpr double kPatchReads = 2.5, kSeeThroughReads = 3.5, kTexelLines = 0.5;
    const auto count = [&](Work of) { return static_cast<double>(work[of]); };
    const double mesh = detail::format::kVertexBytes * count(Work::vertex) +
                        detail::format::view_bytes(field.code_bits) * count(Work::lit) +
                        kPatchReads * detail::format::kPatchBytes * count(Work::patch);
    const double see_through = kSeeThroughReads * detail::format::kPatchBytes * count(Work::see_triangle) / 2;
    const auto texels = [&](std::initializer_list<Work> loops) {
        double samples = 0;
        for (const Work loop : loops) samples += count(loop);
        return kTexelLines * std::min(samples, 1.0 * screen.width_px * screen.height_px);
    };
    return (mesh + see_through) / line_bytes +
           texels({Work::sample, Work::two_taps_sample, Work::packed_sample, Work::bilinear_sample}) +
           texels({Work::see_sample, Work::see_two_taps_sample, Work::see_bilinear_sample});
}

int rated_poses(const host::ScreenSize& screen)
{
    constexpr double kMostPixels = 480.0 * 480 * kRatedPoses, kFewest = 4;
    return static_cast<int>(std::clamp<double>(kMostPixels / screen.width_px / screen.height_px, kFewest, kRatedPoses));
}

std::vector<PartRate> surface_rates(const SurfaceField& field, SurfaceMode mode, const host::ScreenSize& screen,
                                    int poses)
{
    // Halves of what is prepared take so much each: some steps are done twice, and cores wait for each other.
    constexpr double kPrepareByTwo = 0.54;
    const double pixels = 1.0 * screen.width_px * screen.height_px;
    std::vector<SurfaceWork> works;
    for (quality::HeldOutView& view :
         quality::held_out_views(quality::ViewSet::all, std::min(poses, rated_poses(screen)))) {
        const double fov_deg = host::framing_fov_deg(screen.width_px, screen.height_px, view.distance);
        view.eye.image = host::make_image(screen.width_px, screen.height_px, fov_deg);
        works.push_back(work_of(field, view.eye, mode, screen.stripe_rows()));
    }
    std::vector<PartRate> rates;
    for (const Chip& chip : kChipList) {
        PartRate rate = {&chip, 0, 1e9, 0};
        for (const SurfaceWork& work : works) {
            const double share = 1 / static_cast<double>(works.size());
            const double instructions = instructions_of(chip.core, work.frame);
            const auto misses = static_cast<uint64_t>(surface_misses(field, work.frame, screen, chip.cache.line_bytes));
            const double fps = frames_per_second(chip, static_cast<uint64_t>(instructions), misses, pixels);
            rate.mean += share * fps;
            rate.worst = std::min(rate.worst, fps);
            rate.instructions += share * instructions;
            if (chip.cores < 2) continue;
            const double by_one = instructions_of(chip.core, gloss_of(work.preparing)),
                         preparing = instructions_of(chip.core, work.preparing) - by_one;
            const double of_two = by_one + kPrepareByTwo * preparing + (instructions - by_one - preparing) / 2;
            rate.mean_of_two += share * frames_per_second(chip, static_cast<uint64_t>(of_two), misses, pixels);
        }
        rates.push_back(rate);
    }
    return rates;
}

namespace
{

Camera camera_of_generic_view(const host::ScreenSize& screen)
{
    const Orbit orbit = {degrees(37), degrees(23), radii(3)};
    Camera camera;
    if (make_camera(pose_of(orbit), image_of(orbit, screen.width_px, screen.height_px), camera) != CameraError::none)
        throw std::logic_error("the rated view has no camera");
    return camera;
}

}  // namespace

std::vector<PartRate> chord_rates(const Field& field, Mode mode, int32_t span_px, const host::ScreenSize& screen)
{
    const ChordFrame frame = frame_of(field, mode, is_drawn_by_spans(field, mode, span_px) ? span_px : 0,
                                      camera_of_generic_view(screen), screen.stripe_rows());
    const Misses misses = misses_by_chip(frame.reads);
    std::vector<PartRate> rates;
    for (size_t k = 0; k < kChips; ++k) {
        const Chip& chip = kChipList[k];
        const double instructions = instructions_of(chip.core, frame.work);
        const double rate = frames_per_second(chip, static_cast<uint64_t>(instructions), misses[k],
                                              1.0 * screen.width_px * screen.height_px);
        rates.push_back({&chip, rate, rate, instructions});
    }
    return rates;
}

}  // namespace lumi::planner
