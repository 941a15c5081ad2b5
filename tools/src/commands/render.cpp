// SPDX-License-Identifier: MIT
// lumi render: pictures from a field file, by the renderer that firmware links.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "../filter/drawing.h"
#include "../filter/module.h"
#include "../filter/weights_file.h"
#include "../quality/twin.h"
#include "commands/camera_options.h"
#include "commands/choice.h"
#include "commands/commands.h"
#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

struct RenderOptions {
    std::string field, output;
    ViewOptions views;
    std::string mode = "best";
    DrawSettings drawing;  // its mode is that of a chord field
    bool twin = false;
    std::string filter;  // its weights
    bool force_filter = false;
};

const Choices<Mode> kChordModes = {{"nearest", Mode::nearest},
                                   {"voronoi", Mode::voronoi},
                                   {"dither", Mode::dither},
                                   {"linear", Mode::linear},
                                   {"paper", Mode::paper}};
const Choices<SurfaceMode> kSurfaceModes = {{name_of(SurfaceMode::one_sample), SurfaceMode::one_sample},
                                            {name_of(SurfaceMode::antialiased), SurfaceMode::antialiased},
                                            {name_of(SurfaceMode::two_by_two), SurfaceMode::two_by_two}};

// The mode of that name, `best` for the word "best". `kind` is what the field is.
template <class Value>
Value mode_of(const RenderOptions& options, const Choices<Value>& choices, Value best, const std::string& kind)
{
    if (options.mode == "best") return best;
    for (const auto& [word, value] : choices)
        if (word == options.mode) return value;
    throw UsageError("--mode " + options.mode + " does not draw " + options.field + ", a " + kind + " field; choose " +
                     words_of(choices));
}

[[noreturn]] void refuse(const RenderOptions& options, const std::string& option, const std::string& kind)
{
    throw UsageError(option + " belongs to " + kind + " fields, and " + options.field + " is none");
}

Drawer surface_drawer(const RenderOptions& options, const FieldFile& file)
{
    if (options.drawing.span_px > 1) refuse(options, "--span", "chord");
    const SurfaceMode mode = mode_of(options, kSurfaceModes, SurfaceMode::two_by_two, "surface");
    if (options.twin)
        return [&file, mode](const Eye& eye, const Rgb8& background) {
            return quality::draw_twin(file.bytes(), eye, mode, background);
        };
    const DisplayFormat display = options.drawing.display;
    return [&file, mode, display](const Eye& eye, const Rgb8& background) {
        return draw_surface(file.surface(), eye, {mode, display, background});
    };
}

Drawer chord_drawer(const RenderOptions& options, const FieldFile& file)
{
    if (options.twin) refuse(options, "--twin", "surface");
    DrawSettings drawing = options.drawing;
    drawing.mode = mode_of(options, kChordModes, Mode::linear, "chord");
    return [&file, drawing](const Eye& eye, const Rgb8& background) mutable {
        drawing.background = background;
        return draw(file.field(), eye.camera, drawing);
    };
}

// A filter has learned from pictures of the best mode, as they are before a display takes them.
void require_filterable(const RenderOptions& options, const FieldFile& file)
{
    constexpr int kMostSide = 2048;  // the network needs some hundred bytes a pixel
    const std::string best = file.is_surface() ? name_of(SurfaceMode::two_by_two) : "linear";
    if (options.mode != "best" && options.mode != best)
        throw UsageError("--filter takes --mode best, not " + options.mode);
    const bool twin_or_photo = options.twin || !options.views.photo.empty();
    if (twin_or_photo || options.drawing.span_px > 1 || options.drawing.display != DisplayFormat::rgb888)
        throw UsageError("--filter goes with none of --span, --pixel, --over and --twin");
    if (options.views.width_px > kMostSide || options.views.height_px > kMostSide)
        throw UsageError("--filter takes a --size of at most " + std::to_string(kMostSide) + "x" +
                         std::to_string(kMostSide));
}

// `drawer`, or what a filter makes of its pictures.
Drawer filtered_drawer(const RenderOptions& options, const FieldFile& file, Drawer drawer)
{
    require_filterable(options, file);
    const filter::Weights weights = filter::read_weights(options.filter);
    filter::require_fitting(weights, options.filter, file, options.force_filter);
    if (!weights.gains) return drawer;
    const std::shared_ptr<filter::Network> network =
        filter::load_module().network(weights.input_planes, weights.numbers);
    return [&file, network](const Eye& eye, const Rgb8& background) {
        return filter::over(network->filtered(filter::drawn_planes(file, eye)), background);
    };
}

void run(const RenderOptions& options)
{
    const FieldFile file(options.field);
    file.require_intact();
    Drawer drawer = file.is_surface() ? surface_drawer(options, file) : chord_drawer(options, file);
    if (!options.filter.empty()) drawer = filtered_drawer(options, file, drawer);
    for (const std::string& path : write_views(options.views, options.output, drawer))
        std::printf("%s\n", path.c_str());
}

// What is wrong with the word; nothing if it is a mode.
std::string known_mode(const std::string& word)
{
    const auto has = [&](const auto& choices) {
        return std::any_of(choices.begin(), choices.end(), [&](const auto& choice) { return choice.first == word; });
    };
    if (word == "best" || has(kChordModes) || has(kSurfaceModes)) return "";
    return "takes best, or of a surface field " + words_of(kSurfaceModes) + ", of a chord field " +
           words_of(kChordModes) + ", not \"" + word + "\"";
}

void add_drawing_options(CLI::App& command, RenderOptions& options)
{
    command
        .add_option("--mode", options.mode,
                    "Surface fields: 2x2 (four samples a pixel), antialiased (one, outlines smooth) or one-sample (the "
                    "fastest). Chord fields: linear (3x3 "
                    "texels a pixel), nearest (1), voronoi (1, in the true cells also on spans), dither (1, on spans), "
                    "paper (KxK, the kernel of the LumiPath paper). best: 2x2, or linear")
        ->type_name("MODE")
        ->check(known_mode)
        ->capture_default_str();
    command.add_option("--neighbours", options.drawing.neighbours, "Neighbours a side for --mode paper")
        ->type_name("K")
        ->check(CLI::Range(1u, uint32_t{kMaxNeighbours}))
        ->capture_default_str();
    command
        .add_option("--span", options.drawing.span_px,
                    "Chord fields: pixels between exact hits, 2, 4, 8 or 16; 0 or 1: every pixel is exact")
        ->type_name("S")
        ->check(CLI::IsMember({0, 1, 2, 4, 8, 16}))
        ->capture_default_str();
    add_choice<DisplayFormat>(
        command, "--pixel", options.drawing.display,
        {{"rgb888", DisplayFormat::rgb888}, {"rgb565", DisplayFormat::rgb565}, {"grey8", DisplayFormat::grey8}},
        "FORMAT", "Display to preview: rgb888, rgb565 or grey8 [rgb888]");
    command.add_flag("--twin", options.twin,
                     "Surface fields, for checking: the same picture in double precision, by other means");
    command
        .add_option("--filter", options.filter,
                    "Weights that lumi filter train wrote for this field: what they make of the picture")
        ->type_name("WEIGHTS");
    command.add_flag("--force-filter", options.force_filter,
                     "Use them for another field too, though they harm other scenes");
}

}  // namespace

void add_render(CLI::App& lumi)
{
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        lumi.add_subcommand("render", "Draw views of a field, pixel for pixel as a microcontroller does");
    command->add_option("FIELD", options->field, "A field file")->required();
    add_picture_output(*command, options->output);
    add_camera_options(*command, options->views);
    add_drawing_options(*command, *options);
    command->footer("Example:\n  lumi render product.lumi -o product.png --turntable 24 --background 202428");
    command->callback([options, command] {
        if (command->count("--neighbours") > 0 && options->mode != "paper")
            throw UsageError("--neighbours belongs to --mode paper");
        if (options->mode == "dither" && options->drawing.span_px < 2)
            throw UsageError("--mode dither needs --span 2 or more: exact drawing does not dither");
        if (command->count("--over") > 0 && options->drawing.display != DisplayFormat::rgb888)
            throw UsageError("--over draws with --pixel rgb888 only: a photograph has more colours than the display");
        run(*options);
    });
}

}  // namespace lumi::tools
