// SPDX-License-Identifier: MIT
// lumi-lab baselines: what else so many bytes show.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "commands/scene_options.h"
#include "image/picture_file.h"
#include "lumi/baker/chord.h"
#include "lumi/baker/reference.h"
#include "lumi/baker/scene.h"
#include "lumi/bench/views.h"
#include "lumi/detail/lattice.h"
#include "lumi/twin/geometry.h"
#include "measure/commands.h"
#include "quality/measured.h"
#include "quality/report_data.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"

namespace lumi::bench
{

namespace
{

using twin::decoded;
using twin::dot;
using twin::kPi;

// Firmware without a field would have a sheet of path-traced sprites in RGB565, and turn and scale the one nearest to
// the view onto the screen.
struct SpriteSheet {
    uint32_t count = 1;         // a Spherical Fibonacci set all around
    uint32_t samples = 16;      // light paths a pixel; what remains of noise is far below the error of a wrong view
    int32_t side_px = kSidePx;  // a sprite's side
};

constexpr double kTurn = 4294967296.0;

int32_t signed_turns32(double radians)
{
    return static_cast<int32_t>(std::lround(radians / (2 * kPi) * kTurn));
}

Pose sprite_pose(const SpriteSheet& sheet, uint32_t index)
{
    const double z = twin::from_q30(detail::Lattice(sheet.count).height_q30(index));
    return detail::orbit(detail::longitude_turns32(index), signed_turns32(std::asin(z)), kFarQ20);
}

// As the device holds it.
tools::Picture stored(const tools::Picture& traced)
{
    tools::Picture shown = traced;
    for (size_t i = 0; i < shown.rgb.size(); i += 3) {
        const Rgb8 colour =
            detail::unpack_rgb565(detail::pack_rgb565({traced.rgb[i], traced.rgb[i + 1], traced.rgb[i + 2]}));
        shown.rgb[i] = colour.r;
        shown.rgb[i + 1] = colour.g;
        shown.rgb[i + 2] = colour.b;
    }
    return shown;
}

// Pixels from the middle of the picture to the sphere's outline.
double disc_radius_px(uint32_t fov_turns32, int32_t distance_q20)
{
    const double distance = static_cast<double>(distance_q20) / kOneQ20;
    return kSidePx / 2.0 * std::tan(std::asin(1 / distance)) / std::tan(kPi * fov_turns32 / kTurn);
}

// The turn, about the optical axis, of the screen against the sprite.
struct Turn {
    double cosine, sine;

    Turn(const Pose& view, const Pose& sprite)
    {
        const double c = dot(decoded(view.right), decoded(sprite.right)) + dot(decoded(view.up), decoded(sprite.up));
        const double s = dot(decoded(view.right), decoded(sprite.up)) - dot(decoded(view.up), decoded(sprite.right));
        const double length = std::hypot(c, s);
        cosine = length > 0 ? c / length : 1;
        sine = length > 0 ? s / length : 0;
    }
};

// The path-traced reference of a view over kBackgroundColour.
tools::Picture traced_view(const baker::Scene& scene, const Pose& pose, const Image& image, uint32_t samples)
{
    Camera camera;
    if (const CameraError error = make_camera(pose, image, camera); error != CameraError::none)
        throw tools::Failure("bench view", describe(error), "report this");
    const baker::RgbaImage traced = baker::render_reference(scene, camera, {samples, 1, 0});
    tools::Picture picture(traced.width, traced.height);  // premultiplied, over black: the colours as they are
    for (size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = traced.rgba[i / 3 * 4 + i % 3];
    return picture;
}

// Which sprite, seen from kFarQ20, lies nearest to the view.
uint32_t nearest_sprite(const SpriteSheet& sheet, const View& view)
{
    const Vec3q20 eye = view_pose(view).eye;
    uint32_t best = 0;
    double best_cosine = -1e9;
    for (uint32_t i = 0; i < sheet.count; ++i) {
        const double cosine = dot(decoded(sprite_pose(sheet, i).eye), decoded(eye));
        if (cosine <= best_cosine) continue;
        best_cosine = cosine;
        best = i;
    }
    return best;
}

tools::Picture sprite_picture(const baker::Scene& scene, const SpriteSheet& sheet, const View& view)
{
    const Pose pose = sprite_pose(sheet, nearest_sprite(sheet, view));
    const int32_t side_px = sheet.side_px;
    const tools::Picture sprite = stored(traced_view(scene, pose, {side_px, side_px, kFillingFov}, sheet.samples));
    const Turn turn(view_pose(view), pose);
    const double scale =
        disc_radius_px(kFillingFov, kFarQ20) / disc_radius_px(view.fov_turns32, view.distance_q20) * side_px / kSidePx;
    constexpr double kMiddle = (kSidePx - 1) / 2.0;
    const double sprite_middle = (side_px - 1) / 2.0;
    tools::Picture picture(kSidePx, kSidePx, kBackgroundColour);
    for (int y = 0; y < kSidePx; ++y) {
        for (int x = 0; x < kSidePx; ++x) {
            const double right = (x - kMiddle) * scale, up = (kMiddle - y) * scale;
            const long u = std::lround(sprite_middle + right * turn.cosine - up * turn.sine);
            const long v = std::lround(sprite_middle - right * turn.sine - up * turn.cosine);
            if (u < 0 || v < 0 || u >= side_px || v >= side_px) continue;
            std::copy_n(sprite.pixel(static_cast<int>(u), static_cast<int>(v)), 3, picture.pixel(x, y));
        }
    }
    return picture;
}

}  // namespace

}  // namespace lumi::bench

namespace lumi::quality
{

namespace
{

struct BaselineSettings {
    uint32_t chord_samples = 16;   // light paths a texel
    uint32_t sprite_samples = 16;  // light paths a pixel: their noise is far below the error of a wrong view
    unsigned threads = 0;
};

baker::BakeSettings chord_settings(uint32_t side, const BaselineSettings& settings)
{
    baker::BakeSettings bake;
    bake.origins = bake.directions = side;
    bake.texel = TexelFormat::palette8;
    bake.samples = settings.chord_samples;
    bake.threads = settings.threads;
    return bake;
}

// M and N of the largest palette8 chord field with as many origins as directions (what shows most per byte) whose file
// takes at most `bytes`; 0 where none fits.
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

// The field is baked into `cache`, or found there.
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

// As the bench names views.
bench::View bench_view(const HeldOutView& view)
{
    return {"held-out", host::turns32_from_degrees(view.azimuth_deg),
            host::signed_turns32_from_degrees(view.elevation_deg), host::q20_from_radii(view.distance),
            view.eye.image.fov_turns32};
}

// Nothing where not one fits.
std::optional<Measured> measured_sheet(const baker::Scene& scene, bench::SpriteSheet sheet, uint64_t bytes,
                                       const std::vector<HeldOutView>& views, const std::vector<Reference>& references)
{
    const uint64_t bytes_of_one = uint64_t{2} * static_cast<uint64_t>(sheet.side_px * sheet.side_px);
    sheet.count = static_cast<uint32_t>(bytes / bytes_of_one);
    if (sheet.count == 0) return std::nullopt;
    const auto draw = [&](const HeldOutView& view) { return bench::sprite_picture(scene, sheet, bench_view(view)); };
    return measured(std::to_string(sheet.count) + " sprites, " + std::to_string(sheet.side_px) + " px", "sprites",
                    sheet.count * bytes_of_one, draw, views, references);
}

// As many path-traced sprites as fit, few sharp ones or many coarse ones, whichever looks better.
std::optional<Measured> measured_sprites(const baker::Scene& scene, uint64_t bytes, const BaselineSettings& settings,
                                         const std::vector<HeldOutView>& views,
                                         const std::vector<Reference>& references)
{
    bench::SpriteSheet sheet;
    sheet.samples = settings.sprite_samples;
    std::optional<Measured> best;
    for (const int side : {bench::kSidePx, bench::kSidePx / 2, bench::kSidePx / 3}) {
        sheet.side_px = side;
        auto tried = measured_sheet(scene, sheet, bytes, views, references);
        if (tried && (!best || tried->mean.psnr_db > best->mean.psnr_db)) best = std::move(tried);
    }
    return best;
}

}  // namespace

}  // namespace lumi::quality

namespace lumi::lab
{

namespace
{

struct Options {
    tools::SceneOptions scene;
    std::string cache = "lumi-report";
    uint64_t bytes = 0;
    int views = quality::kHeldOutViews;
    uint32_t samples = 256;
};

void measure(const Options& options, const baker::Scene& scene, const baker::ProgressCallback& progress)
{
    quality::ReportData report = {options.scene.path, quality::ViewSet::all, options.samples, {}, {}, {}, {}};
    report.views = quality::held_out_views(quality::ViewSet::all, options.views);
    const baker::ReferenceSettings tracing = {options.samples, 1, options.scene.threads, false};
    report.references = quality::references_of(scene, report.views, tracing, options.cache, progress);
    quality::BaselineSettings settings;
    settings.threads = options.scene.threads;
    if (quality::chord_side(options.bytes) > 0)
        report.fields.push_back(quality::measured_chord(scene, options.bytes, settings, options.cache, report.views,
                                                        report.references, progress));
    if (auto sheet = quality::measured_sprites(scene, options.bytes, settings, report.views, report.references))
        report.fields.push_back(std::move(*sheet));
    const auto one_ray = quality::one_ray_pictures(scene, report.views, tracing, options.cache, progress);
    size_t next = 0;
    report.fields.push_back(quality::measured(
        "one exact ray a pixel", "one ray", 0, [&](const auto&) { return one_ray[next++].picture; }, report.views,
        report.references));
    std::printf("%s", json_of(report).c_str());
}

void run(const Options& options)
{
    size_t warnings = 0;
    const baker::Scene scene = tools::load_scene(options.scene, warnings);
    tools::ProgressPrinter printer(stderr, tools::stderr_is_terminal());
    try {
        measure(options, scene, tools::watch(printer));
    } catch (const baker::Cancelled&) {
        throw tools::Interrupted("what was traced so far is kept for the next call");
    }
}

}  // namespace

void add_baselines(CLI::App& lab)
{
    auto options = std::make_shared<Options>();
    CLI::App* command = lab.add_subcommand(
        "baselines", "Measure what else so many bytes show: a chord field, sprites; and one exact ray a pixel");
    add_scene_options(*command, options->scene);
    command->add_option("--bytes", options->bytes, "Flash for each of them")->required();
    command->add_option("--count", options->views, "Number of views")->capture_default_str();
    command->add_option("--spp", options->samples, "Light paths per pixel of the references")->capture_default_str();
    command->add_option("--cache", options->cache, "Folder of references, that of lumi report")->capture_default_str();
    command->callback([options] { run(*options); });
}

}  // namespace lumi::lab
