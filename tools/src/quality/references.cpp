// SPDX-License-Identifier: MIT
#include "quality/references.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>

#include "image/picture_file.h"
#include "lumi/baker/picture_file.h"
#include "lumi/host/png.h"
#include "math/pi.h"
#include "metrics/metrics.h"
#include "terminal/failure.h"

namespace lumi::quality
{

namespace
{

constexpr double kNearest = 2.5, kFarthest = 4;
constexpr double kTurnDeg = 77, kDegrees = 360;
constexpr double kGolden = 1.61803398874989484820;

double fraction(double v)
{
    return v - std::floor(v);
}

double degrees(double radians)
{
    return radians * kDegrees / (2 * tools::kPi);
}

double elevation_deg(ViewSet set, int k, int count, double cap)
{
    const double share = (k + 0.5) / count;
    return degrees(std::asin(set == ViewSet::upper ? 1 - share : 1 - 2 * cap * share));
}

}  // namespace

const char* name_of(ViewSet set)
{
    return set == ViewSet::all ? "all" : "upper";
}

HeldOutView view_at(double azimuth_deg, double elevation_deg, double distance, int side_px)
{
    HeldOutView v = {azimuth_deg, elevation_deg, distance, {}};
    v.eye.pose = host::make_pose({azimuth_deg, elevation_deg, distance});
    v.eye.image = host::make_image(side_px, side_px, host::framing_fov_deg(side_px, side_px, distance));
    if (const CameraError error = make_camera(v.eye.pose, v.eye.image, v.eye.camera); error != CameraError::none)
        throw tools::UsageError(std::string("a view cannot be drawn: ") + describe(error) + "; change --size");
    return v;
}

std::vector<HeldOutView> held_out_views(ViewSet set, int count, int side_px, double cap)
{
    std::vector<HeldOutView> views;
    for (int k = 0; k < count; ++k) {
        const double azimuth = kDegrees * fraction(k / kGolden);
        const double distance = kNearest + (kFarthest - kNearest) * fraction((k + 0.5) * 5 / 12);
        views.push_back(view_at(azimuth + kTurnDeg, elevation_deg(set, k, count, cap), distance, side_px));
    }
    return views;
}

std::string text_of(const HeldOutView& view)
{
    char text[80];
    std::snprintf(text, sizeof text, "azimuth %.0f, elevation %.0f, distance %.2f",
                  fraction(view.azimuth_deg / kDegrees) * kDegrees, view.elevation_deg, view.distance);
    return text;
}

namespace
{

bool is_empty(const tools::Mask& mask)
{
    return std::all_of(
        mask.values.begin(), mask.values.end(), [](uint8_t value) { return value == 0; });
}

}  // namespace

Figures figures_of(const tools::Picture& picture, const Reference& reference)
{
    Figures figures;
    figures.psnr_db = std::min(kIdenticalDb, tools::psnr_db(picture, reference.picture));
    figures.ssim = tools::ssim(picture, reference.picture);
    figures.cw_ssim = tools::cw_ssim(picture, reference.picture);
    figures.flip = tools::flip(reference.picture, picture);
    const bool whole = is_empty(reference.mask);
    figures.mask_psnr_db =
        whole ? figures.psnr_db : std::min(kIdenticalDb, tools::psnr_db(picture, reference.picture, reference.mask));
    figures.mask_ssim = whole ? figures.ssim : tools::ssim(picture, reference.picture, reference.mask);
    return figures;
}

Figures mean_of(const std::vector<Figures>& all)
{
    Figures mean;
    constexpr double Figures::*kMembers[] = {&Figures::psnr_db, &Figures::ssim,         &Figures::cw_ssim,
                                             &Figures::flip,    &Figures::mask_psnr_db, &Figures::mask_ssim};
    for (const auto member : kMembers) {
        for (const Figures& figures : all) mean.*member += figures.*member;
        mean.*member /= static_cast<double>(all.size());
    }
    return mean;
}

namespace
{

Reference traced(const baker::Scene& scene, const HeldOutView& view, const baker::ReferenceSettings& settings,
                 const baker::ProgressCallback& progress)
{
    const baker::RgbaImage image = baker::render_reference(scene, view.eye.camera, settings, progress);
    Reference reference = {{image.width, image.height}, {image.width, image.height}};
    for (size_t i = 0; i < reference.mask.values.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) reference.picture.rgb[3 * i + k] = image.rgba[4 * i + k];  // over black
        reference.mask.values[i] = image.rgba[4 * i + 3];
    }
    return reference;
}

// Everything that decides the pixels.
std::string file_stem(const HeldOutView& view, const baker::ReferenceSettings& settings)
{
    char text[160];
    std::snprintf(text, sizeof text,
                  "%08" PRIx32 "-%08" PRIx32 "-%08" PRIx32 "-%08" PRIx32 "-%d-spp%" PRIu32 "-%" PRIu64,
                  host::turns32_from_degrees(view.azimuth_deg), host::turns32_from_degrees(view.elevation_deg),
                  static_cast<uint32_t>(host::q20_from_radii(view.distance)), view.eye.image.fov_turns32,
                  view.eye.image.width_px, settings.samples, settings.seed);
    return text;
}

tools::Picture grey_picture(const tools::Mask& mask)
{
    tools::Picture picture(mask.width_px, mask.height_px);
    for (size_t i = 0; i < mask.values.size(); ++i)
        picture.rgb[3 * i] = picture.rgb[3 * i + 1] = picture.rgb[3 * i + 2] = mask.values[i];
    return picture;
}

// The bytes of a file; nothing where there is none, or where it is larger than any that a report keeps. What a report
// leaves for itself is no input of it (file_guard.h).
std::optional<std::string> kept_bytes(const std::string& path)
{
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) return std::nullopt;
    const uintmax_t size = std::filesystem::file_size(path, unknown);
    if (unknown || size > baker::kMaxPictureFileBytes) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), {});
}

// A PNG of that size; nothing where the file holds something else.
std::optional<tools::Picture> kept_picture(const std::string& path, int width_px, int height_px)
{
    try {
        host::DecodedPicture decoded = host::decode_png(kept_bytes(path).value_or(""), false);
        if (decoded.width != width_px || decoded.height != height_px) return std::nullopt;
        tools::Picture picture(width_px, height_px);
        picture.rgb = std::move(decoded.rgb);
        return picture;
    } catch (const host::PictureError&) {
        return std::nullopt;
    }
}

// Reads what was kept, whole and of the view's size; whatever else lies there is traced anew.
std::optional<Reference> kept_reference(const std::string& picture, const std::string& mask, const Image& image)
{
    std::optional<tools::Picture> colours = kept_picture(picture, image.width_px, image.height_px);
    const std::optional<tools::Picture> grey = kept_picture(mask, image.width_px, image.height_px);
    if (!colours || !grey) return std::nullopt;
    Reference reference = {std::move(*colours), {image.width_px, image.height_px}};
    for (size_t i = 0; i < reference.mask.values.size(); ++i) reference.mask.values[i] = grey->rgb[3 * i];
    return reference;
}

}  // namespace

std::string cache_key(const baker::Scene& scene)
{
    char text[40];
    const auto value = scene.fingerprint();
    std::snprintf(text, sizeof text, "%016" PRIx64, value[0] ^ value[1]);
    return text;
}

uint64_t rays_of(const std::vector<HeldOutView>& views, const baker::ReferenceSettings& settings)
{
    uint64_t pixels = 0;
    for (const HeldOutView& view : views)
        pixels += static_cast<uint64_t>(view.eye.image.width_px) * static_cast<uint64_t>(view.eye.image.height_px);
    return pixels * settings.samples;
}

std::vector<Reference> references_of(const baker::Scene& scene, const std::vector<HeldOutView>& views,
                                     const baker::ReferenceSettings& settings, const std::filesystem::path& cache,
                                     const baker::ProgressCallback& progress)
{
    const std::filesystem::path folder = cache.empty() ? cache : cache / cache_key(scene);
    std::error_code ignored;  // the write tells it where that fails
    if (!cache.empty()) std::filesystem::create_directories(folder, ignored);
    std::vector<Reference> references;
    baker::JobSeries series(progress, rays_of(views, settings));
    for (const HeldOutView& view : views) {
        const std::string stem = (folder / file_stem(view, settings)).string();
        const std::string picture = stem + ".png", mask = stem + "-mask.png";
        std::optional<Reference> kept;
        if (!cache.empty()) kept = kept_reference(picture, mask, view.eye.image);
        if (kept) {
            references.push_back(std::move(*kept));
            series.skip(rays_of({view}, settings));
            continue;
        }
        references.push_back(traced(scene, view, settings, series.next(rays_of({view}, settings))));
        if (cache.empty()) continue;
        tools::write_png(mask, grey_picture(references.back().mask));
        tools::write_png(picture, references.back().picture);  // last: it says that both are there
    }
    return references;
}

}  // namespace lumi::quality
