// SPDX-License-Identifier: MIT
#include "bench/surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/boards.h"
#include "bench/surface_field.h"
#include "bench/surface_reads.h"
#include "draw/draw_surface.h"
#include "lumi/detail/crc32.h"
#include "lumi/pixel.h"
#include "lumi/twin/surface_picture.h"
#include "terminal/failure.h"
#include "terminal/interrupt.h"

namespace lumi::bench
{
namespace
{

const View& view_called(const std::string& name)
{
    return *std::find_if(
        std::begin(kViews), std::end(kViews), [&](const View& view) { return view.name == name; });
}

// As the boards hold it.
template <class Pixel>
uint32_t crc_as(const tools::Picture& picture)
{
    std::vector<uint8_t> shown(picture.rgb.size() / 3 * Pixel::kBytes);
    for (size_t k = 0; k < picture.rgb.size() / 3; ++k) {
        const uint8_t* rgb = &picture.rgb[3 * k];
        Pixel::store(&shown[k * Pixel::kBytes], {rgb[0], rgb[1], rgb[2]});
    }
    return crc32(0, shown.data(), shown.size());
}

// Against what the mode stands for: a pixel's centre, or the mean of 2×2 samples.
twin::SurfacePicture exact_picture(const tools::FieldFile& file, const View& view, SurfaceMode mode)
{
    twin::SurfaceDrawing drawing;
    drawing.grid = mode == SurfaceMode::one_sample ? 1 : 2;
    return twin::draw_surface(file.bytes(), view_pose(view), view_image(view), drawing, kBackgroundColour);
}

// Over the pixels that the surface covers.
Accuracy judge(const twin::SurfacePicture& exact, const tools::Picture& drawn)
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

HostFacts host_facts(const tools::FieldFile& file, const View& view, SurfaceMode mode, const std::string& pixel)
{
    const tools::Eye eye = {view_pose(view), view_image(view), {}};
    const bool is_565 = pixel == "rgb565";
    const tools::DisplayFormat display = is_565 ? tools::DisplayFormat::rgb565 : tools::DisplayFormat::rgb888;
    const tools::Picture drawn = tools::draw_surface(file.surface(), eye, {mode, display, kBackgroundColour});
    return {judge(exact_picture(file, view, mode), drawn), traffic_of(reads_of(file, view, mode)),
            is_565 ? crc_as<PixelRgb565>(drawn) : crc_as<PixelRgb888>(drawn)};
}

class SurfaceMeasurement
{
public:
    SurfaceMeasurement(const Settings& settings, std::vector<std::string> modes, const Announce& announce)
        : settings_(settings), modes_(std::move(modes)), announce_(announce), file_(require_surface_field(settings))
    {
    }

    SurfaceResults run()
    {
        for (const std::string& core : settings_.matrix.cores) run_core(core);
        return {facts_of(file_), std::move(results_)};
    }

private:
    void run_core(const std::string& core)
    {
        announce_(core + ": surface field");
        const Board board(core, settings_.source, settings_.work);
        std::vector<std::string> renderers;
        for (const std::string& pixel : settings_.matrix.pixels) renderers.push_back("surface_" + pixel);
        board.build(renderers);
        for (const std::string& pixel : settings_.matrix.pixels) run_pixel(board, core, pixel);
    }

    void run_pixel(const Board& board, const std::string& core, const std::string& pixel)
    {
        const std::string renderer = "surface_" + pixel;
        const uint32_t code_bytes = board.code_bytes(renderer);
        for (const SurfaceCount& count : board.count_surface(renderer, file_.path(), settings_.matrix.views, modes_)) {
            tools::leave_if_interrupted();
            const HostFacts& host = facts(count, pixel);
            if (host.crc != count.crc)
                throw tools::Failure(
                    renderer, core + " draws other bits than this machine, view " + count.view + ", " + count.mode,
                    "build both from the same source");
            results_.push_back({core, pixel, count, code_bytes, host.accuracy, host.traffic});
        }
    }

    const HostFacts& facts(const SurfaceCount& count, const std::string& pixel)
    {
        const auto [at, is_new] = facts_.try_emplace(count.view + " " + count.mode + " " + pixel);
        if (is_new) at->second = host_facts(file_, view_called(count.view), surface_mode(count.mode), pixel);
        return at->second;
    }

    const Settings& settings_;
    const std::vector<std::string> modes_;
    const Announce& announce_;
    const tools::FieldFile file_;
    std::map<std::string, HostFacts> facts_;
    std::vector<SurfaceResult> results_;
};

const NamedSurfaceMode* find_mode(const std::string& name)
{
    for (const NamedSurfaceMode& mode : kSurfaceModes)
        if (name == mode.name) return &mode;
    return nullptr;
}

}  // namespace

std::vector<std::string> surface_mode_names()
{
    std::vector<std::string> names;
    for (const NamedSurfaceMode& mode : kSurfaceModes) names.push_back(mode.name);
    return names;
}

bool is_surface(const std::string& mode)
{
    return find_mode(mode) != nullptr;
}

SurfaceMode surface_mode(const std::string& mode)
{
    return find_mode(mode)->mode;
}

SurfaceResults measure_surface(const Settings& settings, const Announce& announce)
{
    std::vector<std::string> modes = settings.matrix.modes;
    modes.erase(std::remove_if(modes.begin(), modes.end(), [](const std::string& m) { return !is_surface(m); }),
                modes.end());
    if (modes.empty()) return {};
    std::filesystem::create_directories(settings.work);
    return SurfaceMeasurement(settings, modes, announce).run();
}

}  // namespace lumi::bench
