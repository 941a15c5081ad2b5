// SPDX-License-Identifier: MIT
#include "bench/guided.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/boards.h"
#include "draw/draw_guided.h"
#include "lumi/baker/file_guard.h"
#include "lumi/baker/guided.h"
#include "lumi/bench/views.h"
#include "lumi/crc32.h"
#include "lumi/guided/guided_field.h"
#include "lumi/host/mapped_file.h"
#include "lumi/pixel.h"
#include "lumi/reference/guided_picture.h"
#include "terminal/failure.h"
#include "terminal/interrupt.h"
#include "terminal/progress_printer.h"

namespace lumi::bench
{
namespace
{

using tools::GuidedMode;

constexpr char kPrefix[] = "guided-";
constexpr char kAntialiased[] = "-aa";

constexpr uint32_t kMeanResolution = 96;

const std::vector<std::string> kGuidedTexels = {"residual4", "residual_vq8", "colour4"};

bool ends_with(const std::string& text, const std::string& end)
{
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool is_antialiased(const std::string& mode)
{
    return ends_with(mode, kAntialiased);
}

// A mode's name without prefix and suffix: linear, nearest, one-origin, mean.
std::string step_of(const std::string& mode)
{
    const std::string step = mode.substr(sizeof(kPrefix) - 1);
    return is_antialiased(mode) ? step.substr(0, step.size() - (sizeof(kAntialiased) - 1)) : step;
}

GuidedMode drawing_mode(const std::string& mode)
{
    const std::string step = step_of(mode);
    if (step == "linear") return GuidedMode::linear;
    if (step == "nearest") return GuidedMode::nearest;
    if (step == "one-origin") return GuidedMode::one_origin;
    return GuidedMode::mean;
}

// The name of a program of the bench firmware.
std::string renderer_of(const std::string& mode, const std::string& texel)
{
    return kPrefix + step_of(mode) + "_" + texel + (is_antialiased(mode) ? kAntialiased : "");
}

// The mean alone has no texels; blocks are measured with the most taps.
bool is_measured(const std::string& step, const std::string& texel)
{
    return texel == "residual4" || (texel == "residual_vq8" ? step == "linear" : step != "mean");
}

void bake(const FieldSettings& settings, const std::string& texel, const std::filesystem::path& path)
{
    std::vector<std::string> warnings;
    const baker::Scene scene = baker::load_scene(settings.scene, {}, warnings);
    baker::GuidedSettings guided;
    guided.origins = kGuidedOrigins;
    const bool blocks = texel == "residual_vq8";
    guided.chart_size = blocks ? kGuidedBlockChartSize : kGuidedChartSize;
    guided.texel = blocks ? format::GuidedTexel::vq8 : format::GuidedTexel::index4;
    guided.proxy_triangles = kGuidedTriangles;
    guided.mean_resolution = texel == "colour4" ? 0 : kMeanResolution;
    guided.samples = settings.samples;
    tools::ProgressPrinter printer(stderr, tools::stderr_is_terminal());
    try {
        baker::bake_guided(scene, guided, path, tools::watch(printer));
    } catch (const baker::Cancelled&) {
        throw tools::Interrupted();
    }
}

std::filesystem::path require_guided_field(const Settings& settings, const std::string& texel)
{
    const std::filesystem::path path = settings.work / (settings.field.scene.stem().string() + "-guided-" +
                                                        std::to_string(settings.field.samples) + "." + texel + ".lumi");
    if (!std::filesystem::exists(path)) bake(settings.field, texel, path);
    return path;
}

tools::Eye eye_of(const View& view)
{
    tools::Eye eye = {view_pose(view), view_image(view), {}};
    if (make_camera(eye.pose, eye.image, eye.camera) != CameraError::none)
        throw std::logic_error("the bench's views have cameras");
    return eye;
}

// As the boards hold it.
uint32_t rgb565_crc(const tools::Picture& picture)
{
    std::vector<uint8_t> shown(picture.rgb.size() / 3 * PixelRgb565::kBytes);
    for (size_t k = 0; k < picture.rgb.size() / 3; ++k) {
        const uint8_t* rgb = &picture.rgb[3 * k];
        PixelRgb565::store(&shown[k * PixelRgb565::kBytes], {rgb[0], rgb[1], rgb[2]});
    }
    return crc32(0, shown.data(), shown.size());
}

reference::GuidedPicture exact_picture(const GuidedField& field, const tools::Eye& eye, const std::string& mode)
{
    const std::string step = step_of(mode);
    reference::GuidedDrawing drawing;
    drawing.antialiased = is_antialiased(mode);
    drawing.shading.origins = step == "one-origin" ? reference::Origins::heaviest : reference::Origins::three;
    drawing.shading.taps = step == "linear" ? reference::Taps::linear : reference::Taps::nearest;
    GuidedField seen = field;
    if (step == "mean") seen.texel = format::GuidedTexel::none;
    return reference::draw_guided(seen, eye.pose, eye.image, drawing, kBackgroundColour);
}

// Over the pixels that the surface covers.
Accuracy judge(const reference::GuidedPicture& exact, const tools::Picture& drawn)
{
    double squares = 0, worst = 0;
    size_t channels = 0;
    for (size_t k = 0; k < exact.colours.size(); ++k) {
        if (exact.coverage[k] <= 0) continue;
        const double truth[3] = {exact.colours[k].r, exact.colours[k].g, exact.colours[k].b};
        for (size_t c = 0; c < 3; ++c) {
            const double error = std::fabs(truth[c] - drawn.rgb[3 * k + c]);
            squares += error * error;
            worst = std::max(worst, error);
            ++channels;
        }
    }
    const double db = 10 * std::log10(255 * 255 * static_cast<double>(channels) / squares);
    return {db, db, static_cast<uint32_t>(std::lround(worst))};
}

// Opened here alone: commands refuse guided fields.
struct GuidedFile {
    std::string path;
    host::MappedFile file;
    GuidedField field;

    explicit GuidedFile(const std::string& name) : path(name)
    {
        baker::note_input(path);
        if (file.open(path) != 0 || open_guided(file.bytes(), file.size(), field) != FieldError::none)
            throw tools::Failure(path, "cannot be opened", "delete it");
    }
};

class GuidedMeasurement
{
public:
    GuidedMeasurement(const Settings& settings, const Announce& announce) : settings_(settings), announce_(announce) {}

    Rows run()
    {
        for (const std::string& mode : settings_.matrix.modes) {
            if (!is_guided(mode)) continue;
            for (const std::string& texel : kGuidedTexels)
                if (is_measured(step_of(mode), texel)) programs_.push_back({mode, texel});
        }
        if (programs_.empty()) return {};
        std::filesystem::create_directories(settings_.work);
        for (const Program& program : programs_) {
            if (fields_.count(program.texel) != 0) continue;
            announce_("guided field, " + program.texel);
            fields_.try_emplace(program.texel, require_guided_field(settings_, program.texel).string());
        }
        for (const std::string& core : settings_.matrix.cores) run_core(core);
        return std::move(rows_);
    }

private:
    struct Program {
        std::string mode, texel;
    };
    struct HostFacts {
        Accuracy accuracy;
        uint32_t crc = 0;
        uint64_t surface = 0;
    };

    void run_core(const std::string& core)
    {
        announce_(core + ": building " + std::to_string(programs_.size()) + " guided renderers");
        const Board board(core, settings_.source, settings_.work);
        std::vector<std::string> renderers;
        for (const Program& program : programs_) renderers.push_back(renderer_of(program.mode, program.texel));
        board.build(renderers);
        for (const Program& program : programs_) run_program_on(board, core, program);
    }

    void run_program_on(const Board& board, const std::string& core, const Program& program)
    {
        const std::string renderer = renderer_of(program.mode, program.texel);
        announce_(core + ": " + renderer);
        const uint32_t code_bytes = board.code_bytes(renderer);
        const GuidedFile& file = fields_.at(program.texel);
        for (Count& count : board.count(renderer, file.path, settings_.matrix.views, {})) {
            tools::leave_if_interrupted();
            const HostFacts& host = facts(program, count);
            count.surface = host.surface;
            if (host.crc != count.crc)
                throw tools::Failure(renderer, core + " draws other bits than this machine, view " + count.view,
                                     "build both from the same source");
            rows_.push_back({core, program.mode, program.texel, count, code_bytes, host.accuracy, {}});
        }
    }

    const HostFacts& facts(const Program& program, const Count& count)
    {
        const auto [at, is_new] = facts_.try_emplace(program.mode + program.texel + count.view);
        if (!is_new) return at->second;
        const GuidedField& field = fields_.at(program.texel).field;
        const tools::Eye eye = eye_of(*std::find_if(std::begin(kViews), std::end(kViews),
                                                    [&](const View& view) { return view.name == count.view; }));
        tools::GuidedDrawSettings drawing;
        drawing.mode = drawing_mode(program.mode);
        drawing.antialiased = is_antialiased(program.mode);
        const tools::Picture drawn = tools::draw_guided(field, eye, drawing);
        const reference::GuidedPicture exact = exact_picture(field, eye, program.mode);
        const auto seen = std::count_if(exact.coverage.begin(), exact.coverage.end(), [](double c) { return c > 0; });
        at->second = {judge(exact, drawn), rgb565_crc(drawn), static_cast<uint64_t>(seen)};
        return at->second;
    }

    const Settings& settings_;
    const Announce& announce_;
    std::vector<Program> programs_;
    std::map<std::string, GuidedFile> fields_;
    std::map<std::string, HostFacts> facts_;
    Rows rows_;
};

}  // namespace

bool is_guided(const std::string& mode)
{
    return mode.compare(0, sizeof(kPrefix) - 1, kPrefix) == 0;
}

Rows measure_guided(const Settings& settings, const Announce& announce)
{
    return GuidedMeasurement(settings, announce).run();
}

}  // namespace lumi::bench
