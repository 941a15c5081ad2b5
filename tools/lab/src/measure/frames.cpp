// SPDX-License-Identifier: MIT
// lumi-lab frames: facts that this machine can tell about the frames that boards draw. They hold for every core.
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "bench/host_renderer.h"
#include "bench/judge.h"
#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "files/field_report.h"
#include "lumi/bench/surface_modes.h"
#include "lumi/chord/texel.h"
#include "lumi/detail/crc32.h"
#include "lumi/pixel.h"
#include "lumi/twin/surface_picture.h"
#include "measure/commands.h"
#include "planner/chips.h"
#include "terminal/failure.h"

namespace lumi::bench
{
namespace
{

struct FrameFacts {
    Accuracy accuracy;
    uint32_t crc = 0;
    planner::Misses misses = {};  // of chord fields
};

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
    tools::SurfaceDrawSettings settings = {mode, display, kBackgroundColour};
    constexpr uint16_t kHalf = kFullWeight / 2;  // as the firmware of the bench weighs it
    if (file.surface().state_count != 0) settings.states = {{1, {kHalf, kHalf, kHalf}}};
    return tools::draw_surface(file.surface(), eye, settings);
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

// Facts about a frame of a chord field, in RGB565. `judge` is made for the field's lattices.
FrameFacts chord_facts(Judge& judge, const tools::FieldFile& file, const std::string& mode, int span, const View& view)
{
    Camera camera;
    if (make_view_camera(view, camera) != CameraError::none)
        throw std::logic_error("a view of the bench has no camera");
    const HostFrame frame = draw_on_host(mode, span, file.field(), file.bytes(), camera);
    return {judge.judge(mode, file.field(), view, frame.picture), frame.rgb565_crc,
            planner::misses_by_chip(frame.reads)};
}

// CRC of a frame of a surface field; `pixel` is rgb565 or rgb888.
uint32_t surface_crc(const tools::FieldFile& file, const NamedSurfaceMode& mode, const std::string& pixel,
                     const View& view)
{
    return crc_of(drawn_as(file, mode.mode, pixel, view), pixel);
}

// Facts about it. The double-precision picture has opaque parts alone.
FrameFacts surface_facts(const tools::FieldFile& file, const NamedSurfaceMode& mode, const std::string& pixel,
                         const View& view)
{
    const tools::Picture drawn = drawn_as(file, mode.mode, pixel, view);
    return {judge_surface(exact_surface(file, view, mode.mode), drawn), crc_of(drawn, pixel)};
}

}  // namespace
}  // namespace lumi::bench

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;

struct Options {
    std::vector<std::string> fields, modes, pixels = {"rgb565", "rgb888"}, views;
    std::vector<int> spans;
};

bool is_asked_for(const std::vector<std::string>& words, const char* word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

void put_facts(Json& row, const bench::FrameFacts& facts)
{
    row["psnr_db"] = hundredths(facts.accuracy.psnr_db);
    row["psnr_all_db"] = hundredths(facts.accuracy.psnr_all_db);
    row["worst_pixel"] = facts.accuracy.worst_pixel;
    row["crc"] = facts.crc;
}

void add_chord_rows(const tools::FieldFile& file, const Options& options, bench::Judge& judge, const bench::View& view,
                    Json& rows)
{
    for (const std::string& mode : options.modes) {
        for (const int span : options.spans) {
            tools::leave_if_interrupted();
            if (mode == "paper" && span != 0) continue;  // it is drawn exactly alone
            Json row = {{"texel", detail::texel_name(file.field().texel_format)},
                        {"mode", mode},
                        {"span", span},
                        {"view", view.name}};
            const bench::FrameFacts facts = bench::chord_facts(judge, file, mode, span, view);
            put_facts(row, facts);
            for (size_t i = 0; i < planner::kChips; ++i)
                row["misses_" + std::string(planner::kChipList[i].key)] = facts.misses[i];
            rows.push_back(row);
        }
    }
}

void add_surface_rows(const tools::FieldFile& file, const Options& options, const bench::View& view, Json& rows)
{
    for (const bench::NamedSurfaceMode& mode : bench::kSurfaceModes) {
        if (!is_asked_for(options.modes, mode.name)) continue;
        for (const std::string& pixel : options.pixels) {
            tools::leave_if_interrupted();
            Json row = {{"mode", mode.name},
                        {"pixel", pixel},
                        {"view", view.name},
                        {"triangles", tools::triangles_of(file.surface())},
                        {"vertices", file.surface().vertex_count},
                        {"see_through_patches", file.surface().see_through_count},
                        {"states", file.surface().state_count},
                        {"gloss", gloss_count(file.surface())}};
            if (file.surface().see_through_count + file.surface().state_count + gloss_count(file.surface()) != 0)
                row["crc"] = bench::surface_crc(file, mode, pixel, view);
            else
                put_facts(row, bench::surface_facts(file, mode, pixel, view));
            rows.push_back(row);
        }
    }
}

void run(const Options& options)
{
    Json rows = Json::array();
    std::unique_ptr<bench::Judge> judge;
    for (const std::string& path : options.fields) {
        const tools::FieldFile file(path);
        file.require_intact();
        if (!file.is_surface() && !judge) judge = std::make_unique<bench::Judge>(file.field());
        for (const bench::View& view : bench::kViews) {
            if (!is_asked_for(options.views, view.name)) continue;
            if (file.is_surface())
                add_surface_rows(file, options, view, rows);
            else
                add_chord_rows(file, options, *judge, view, rows);
        }
    }
    print(rows);
}

}  // namespace

void add_frames(CLI::App& lab)
{
    auto options = std::make_shared<Options>();
    CLI::App* command = lab.add_subcommand("frames", "Tell CRC, accuracy and flash misses of the bench's frames");
    command->add_option("FIELD", options->fields, "Fields; chord fields of one pair of lattices")->required();
    command->add_option("--mode", options->modes, "Modes of either layout")->delimiter(',')->required();
    command->add_option("--span", options->spans, "Spans of chord fields, 0 for exact drawing")->delimiter(',');
    command->add_option("--pixel", options->pixels, "Pixels of surface fields")->delimiter(',');
    command->add_option("--view", options->views, "generic, pole, close")->delimiter(',')->required();
    command->callback([options] { run(*options); });
}

}  // namespace lumi::lab
