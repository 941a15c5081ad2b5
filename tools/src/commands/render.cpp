// SPDX-License-Identifier: MIT
// lumi render: pictures from a field file, by the renderer that firmware links.
#include <cstdio>
#include <memory>

#include "../quality/twin.h"
#include "commands/camera_options.h"
#include "commands/choice.h"
#include "commands/commands.h"
#include "draw/draw_guided.h"
#include "files/field_file.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

// What either kind of field can be drawn by.
enum class RenderMode { best, nearest, voronoi, dither, linear, paper, one_origin, mean };

struct RenderOptions {
    std::string field, output;
    ViewOptions views;
    RenderMode mode = RenderMode::best;
    DrawSettings drawing;
    bool antialiased = true, twin = false;
};

Mode chord_mode(const RenderOptions& options)
{
    switch (options.mode) {
        case RenderMode::nearest:
            return Mode::nearest;
        case RenderMode::voronoi:
            return Mode::voronoi;
        case RenderMode::dither:
            return Mode::dither;
        case RenderMode::best:
        case RenderMode::linear:
            return Mode::linear;
        case RenderMode::paper:
            return Mode::paper;
        case RenderMode::one_origin:
        case RenderMode::mean:
            break;
    }
    throw UsageError("--mode one-origin and mean belong to guided fields; " + options.field + " is a chord field");
}

GuidedMode guided_mode(const RenderOptions& options)
{
    switch (options.mode) {
        case RenderMode::best:
        case RenderMode::linear:
            return GuidedMode::linear;
        case RenderMode::nearest:
            return GuidedMode::nearest;
        case RenderMode::one_origin:
            return GuidedMode::one_origin;
        case RenderMode::mean:
            return GuidedMode::mean;
        case RenderMode::voronoi:
        case RenderMode::dither:
        case RenderMode::paper:
            break;
    }
    throw UsageError("--mode voronoi, dither and paper belong to chord fields; " + options.field +
                     " is a guided field");
}

// The same steps in the double-precision twin.
reference::GuidedDrawing twin_drawing(const RenderOptions& options)
{
    const GuidedMode mode = guided_mode(options);
    if (mode == GuidedMode::mean) throw UsageError("--twin has no --mode mean");
    return {options.antialiased,
            {mode == GuidedMode::one_origin ? reference::Origins::heaviest : reference::Origins::three,
             mode == GuidedMode::linear ? reference::Taps::linear : reference::Taps::nearest}};
}

Drawer guided_drawer(const RenderOptions& options, const FieldFile& file)
{
    if (options.drawing.span_px > 1)
        throw UsageError("--span belongs to chord fields; " + options.field + " is a guided field");
    if (options.twin)
        return [&file, &options, drawing = twin_drawing(options)](const Eye& eye) {
            return quality::draw_twin(file.guided(), eye, drawing, options.views.background);
        };
    const GuidedDrawSettings settings = {guided_mode(options), options.antialiased, options.drawing.display,
                                         options.views.background};
    return [&file, settings](const Eye& eye) { return draw_guided(file.guided(), eye, settings); };
}

Drawer chord_drawer(const RenderOptions& options, const FieldFile& file)
{
    if (options.twin) throw UsageError("--twin belongs to guided fields; " + options.field + " is a chord field");
    DrawSettings drawing = options.drawing;
    drawing.mode = chord_mode(options);
    drawing.background = options.views.background;
    return [&file, drawing](const Eye& eye) { return draw(file.field(), eye.camera, drawing); };
}

void run(const RenderOptions& options)
{
    const FieldFile file(options.field);
    file.require_intact();
    const Drawer drawer = file.is_guided() ? guided_drawer(options, file) : chord_drawer(options, file);
    for (const std::string& path : write_views(options.views, options.output, drawer))
        std::printf("%s\n", path.c_str());
}

void add_drawing_options(CLI::App& command, RenderOptions& options)
{
    add_choice<RenderMode>(
        command, "--mode", options.mode,
        {{"best", RenderMode::best},
         {"nearest", RenderMode::nearest},
         {"voronoi", RenderMode::voronoi},
         {"dither", RenderMode::dither},
         {"linear", RenderMode::linear},
         {"paper", RenderMode::paper},
         {"one-origin", RenderMode::one_origin},
         {"mean", RenderMode::mean}},
        "MODE",
        "Reconstruction: linear (3x3 texels a pixel); nearest (1 texel, of a guided field 3); voronoi "
        "(chord fields: nearest with the true cells, also on spans); dither (chord fields: 1 texel, "
        "on spans); paper (chord fields: KxK, the kernel of the LumiPath paper); one-origin (guided: 1 texel); mean "
        "(guided: mean colours alone); best: linear [best]");
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
    command.add_flag_callback(
        "--no-antialiasing", [&options] { options.antialiased = false; },
        "Guided fields: one sample of the surface a pixel in place of four");
    command.add_flag("--twin", options.twin,
                     "Guided fields, for checking: the same reconstruction in double precision, by other means");
}

}  // namespace

void add_render(CLI::App& lumi)
{
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        lumi.add_subcommand("render", "Draw views of a field, pixel for pixel as a microcontroller does");
    command->add_option("FIELD", options->field, "A field file")->required();
    command->add_option("-o,--output", options->output, "Picture to write")->type_name("OUT.png")->required();
    add_camera_options(*command, options->views);
    add_drawing_options(*command, *options);
    command->footer(
        "Example:\n  lumi render product.lumi -o product.png --turntable 24 --mode paper --background 202428");
    command->callback([options, command] {
        if (command->count("--neighbours") > 0 && options->mode != RenderMode::paper)
            throw UsageError("--neighbours belongs to --mode paper");
        if (options->mode == RenderMode::dither && options->drawing.span_px < 2)
            throw UsageError("--mode dither needs --span 2 or more: exact drawing does not dither");
        run(*options);
    });
}

}  // namespace lumi::tools
