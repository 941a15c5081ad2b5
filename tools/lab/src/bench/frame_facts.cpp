// SPDX-License-Identifier: MIT
#include "bench/frame_facts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/host_renderer.h"
#include "bench/surface_reads.h"
#include "draw/draw_surface.h"
#include "lumi/detail/crc32.h"
#include "lumi/pixel.h"
#include "lumi/twin/surface_picture.h"

namespace lumi::bench
{
namespace
{

// As the boards hold it.
template <class Pixel>
uint32_t crc_as(const tools::Picture& picture)
{
    std::vector<uint8_t> shown(picture.rgb.size() / 3 * Pixel::kBytes);
    for (size_t k = 0; k < picture.rgb.size() / 3; ++k) {
        const uint8_t* rgb = &picture.rgb[3 * k];
        Pixel::store(&shown[k * Pixel::kBytes], {rgb[0], rgb[1], rgb[2]});
    }
    return detail::crc32(0, shown.data(), shown.size());
}

tools::Picture drawn_as(const tools::FieldFile& file, SurfaceMode mode, const std::string& pixel, const View& view)
{
    using tools::DisplayFormat;
    const DisplayFormat display = pixel == "rgb565" ? DisplayFormat::rgb565 : DisplayFormat::rgb888;
    const tools::Eye eye = {view_pose(view), view_image(view), {}};
    return tools::draw_surface(file.surface(), eye, {mode, display, kBackgroundColour});
}

uint32_t crc_of(const tools::Picture& drawn, const std::string& pixel)
{
    return pixel == "rgb565" ? crc_as<PixelRgb565>(drawn) : crc_as<PixelRgb888>(drawn);
}

// Against what the mode stands for: a pixel's centre, or the mean of 2×2 samples.
twin::SurfacePicture exact_surface(const tools::FieldFile& file, const View& view, SurfaceMode mode)
{
    twin::SurfaceDrawing drawing;
    drawing.grid = mode == SurfaceMode::one_sample ? 1 : 2;
    return twin::draw_surface(file.bytes(), view_pose(view), view_image(view), drawing, kBackgroundColour);
}

// Over the pixels that the surface covers.
Accuracy judge_surface(const twin::SurfacePicture& exact, const tools::Picture& drawn)
{
    double squares = 0, worst = 0;
    size_t channels = 0;
    for (size_t k = 0; k < exact.colours.size(); ++k) {
        if (exact.coverage[k] <= 0) continue;
        const double exact_rgb[3] = {exact.colours[k].r, exact.colours[k].g, exact.colours[k].b};
        for (size_t c = 0; c < 3; ++c) {
            const double error = std::fabs(exact_rgb[c] - drawn.rgb[3 * k + c]);
            squares += error * error;
            worst = std::max(worst, error);
            ++channels;
        }
    }
    const double db = 10 * std::log10(255 * 255 * static_cast<double>(channels) / squares);
    return {db, db, static_cast<uint32_t>(std::lround(worst))};
}

}  // namespace

FrameFacts chord_facts(Judge& judge, const tools::FieldFile& file, const std::string& mode, int span, const View& view)
{
    Camera camera;
    if (make_view_camera(view, camera) != CameraError::none)
        throw std::logic_error("a view of the bench has no camera");
    const HostFrame frame = draw_on_host(mode, span, file.field(), file.bytes(), camera);
    return {judge.judge(mode, file.field(), view, frame.picture), planner::traffic_of(frame.reads), frame.rgb565_crc};
}

uint32_t surface_crc(const tools::FieldFile& file, const NamedSurfaceMode& mode, const std::string& pixel,
                     const View& view)
{
    return crc_of(drawn_as(file, mode.mode, pixel, view), pixel);
}

FrameFacts surface_facts(const tools::FieldFile& file, const NamedSurfaceMode& mode, const std::string& pixel,
                         const View& view)
{
    const tools::Picture drawn = drawn_as(file, mode.mode, pixel, view);
    return {judge_surface(exact_surface(file, view, mode.mode), drawn),
            planner::traffic_of(reads_of(file, view, mode.mode)), crc_of(drawn, pixel)};
}

}  // namespace lumi::bench
