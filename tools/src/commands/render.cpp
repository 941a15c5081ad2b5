// SPDX-License-Identifier: MIT
// lumi render: pictures from a field file, by the renderer that firmware links.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "commands/camera_options.h"
#include "commands/commands.h"
#include "commands/part_options.h"
#include "commands/state_options.h"
#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "image/animation.h"
#include "lumi/chord/render_spans.h"
#include "program/option_checks.h"
#include "program/plugin.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

const Choices<Mode> kChordModes = {{name_of(Mode::nearest), Mode::nearest},
                                   {name_of(Mode::linear), Mode::linear},
                                   {name_of(Mode::paper), Mode::paper}};
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
    const DisplayFormat display = options.drawing.display;
    values_of(options.parts, file);  // refuses wrong names before the first view
    const std::vector<StateValue> states = values_of(options.states, options.base_colours, file);
    return [&file, mode, display, states, poses = options.parts](const Eye& eye, const Rgb8& background) {
        return draw_surface(file.surface(), eye, {mode, display, background, values_of(poses, file, eye.done), states});
    };
}

void warn_of_spans(const RenderOptions& options, const Field& field)
{
    if (options.drawing.span_px > 1 && !fits_spans(field))
        print(stderr,
              "lumi: warning: %s: --span draws lattices of %u to %u points; every pixel of this field is drawn "
              "exactly\n",
              options.field.c_str(), detail::kMinSpanLattice, detail::kMaxSpanLattice);
}

Drawer chord_drawer(const RenderOptions& options, const FieldFile& file)
{
    if (!options.parts.empty()) refuse(options, "--part", "surface");
    if (!options.states.empty()) refuse(options, "--state", "surface");
    if (!options.base_colours.empty()) refuse(options, "--tint", "surface");
    DrawSettings drawing = options.drawing;
    drawing.mode = mode_of(options, kChordModes, Mode::linear, "chord");
    if (drawing.mode == Mode::paper && drawing.span_px > 1)
        throw UsageError("--span belongs to --mode linear and nearest; paper draws every pixel exactly");
    warn_of_spans(options, file.field());
    return [&file, drawing](const Eye& eye, const Rgb8& background) mutable {
        drawing.background = background;
        return draw(file.field(), eye.camera, drawing);
    };
}

using Stages = std::vector<std::shared_ptr<PictureStage>>;

void run(const RenderOptions& options, const Stages& stages)
{
    std::optional<Waiting> waiting(std::in_place, "reading");
    const FieldFile file(options.field);
    file.require_intact();
    Drawer drawer = file.is_surface() ? surface_drawer(options, file) : chord_drawer(options, file);
    for (const auto& stage : stages) drawer = stage->changed(options, file, drawer);
    const int views = std::max(1, options.views.turntable);
    const Eye* drawn = nullptr;
    int view = 0;
    const Drawer told = [&](const Eye& eye, const Rgb8& background) {
        if (drawn != &eye) waiting->now("drawing view " + std::to_string(++view) + " of " + std::to_string(views));
        drawn = &eye;
        return drawer(eye, background);
    };
    const std::vector<std::string> written = write_views(options.views, options.output, told, options.drawing.display);
    waiting.reset();
    for (const std::string& path : written) print(stdout, "%s\n", path.c_str());
}

// Says what is wrong with the word; nothing if it is a mode.
std::string known_mode(const std::string& word)
{
    const auto has = [&](const auto& choices) {
        return std::any_of(choices.begin(), choices.end(), [&](const auto& choice) { return choice.first == word; });
    };
    if (word == "best" || has(kChordModes) || has(kSurfaceModes)) return "";
    return "takes best, for surface fields also " + words_of(kSurfaceModes) + ", for chord fields also " +
           words_of(kChordModes) + ", not \"" + word + "\"";
}

void add_drawing_options(CLI::App& command, RenderOptions& options)
{
    command
        .add_option("--mode", options.mode,
                    "Surface fields: 2x2 (four samples a pixel), antialiased (one, outlines smooth) or one-sample (the "
                    "fastest). Chord fields: linear (3x3 "
                    "texels a pixel), nearest (1), paper (KxK, the kernel of the LumiPath paper). best: 2x2, or linear")
        ->type_name("MODE")
        ->check(known_mode)
        ->capture_default_str();
    command.add_option("--neighbours", options.drawing.neighbours, "Neighbours a side for --mode paper")
        ->type_name("K")
        ->check(whole_number(1, detail::kMaxNeighbours))
        ->capture_default_str();
    command
        .add_option("--span", options.drawing.span_px,
                    "Chord fields: pixels between exact hits, 2, 4, 8 or 16; 0 or 1: every pixel is exact")
        ->type_name("0|1|2|4|8|16")
        ->check(one_of({0, 1, 2, 4, 8, 16}))
        ->capture_default_str();
    add_choice<DisplayFormat>(command, "--pixel", options.drawing.display,
                              {{"rgb888", DisplayFormat::rgb888},
                               {"rgb565", DisplayFormat::rgb565},
                               {"rgb565-dithered", DisplayFormat::rgb565_dithered},
                               {"grey8", DisplayFormat::grey8}},
                              "Display to preview [rgb888]");
}

}  // namespace

void add_render(CLI::App& lumi)
{
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        lumi.add_subcommand("render", "Draw views of a field, pixel for pixel as a microcontroller does");
    command->add_option("FIELD", options->field, "A field file")->required();
    add_picture_output(*command, options->output, "OUT.png|OUT.webp", wrong_views_name);
    add_camera_options(*command, options->views, "gradient");
    add_drawing_options(*command, *options);
    add_pose_option(*command, options->parts);
    add_state_option(*command, options->states, StateWords::weights);
    add_colour_option(*command, options->base_colours);
    Stages stages;
    for (const Plugin& plugin : plugins()) {
        stages.push_back(plugin.make_stage());
        stages.back()->add_options(*command);
    }
    command->footer("Example:\n  lumi render product.lumi -o product.png --turntable 24 --background none");
    command->callback([options, stages, command] {
        if (command->count("--neighbours") > 0 && options->mode != "paper")
            throw UsageError("--neighbours belongs to --mode paper");
        if (command->count("--over") > 0 && options->drawing.display != DisplayFormat::rgb888)
            throw UsageError("--over draws with --pixel rgb888 only: a photograph has more colours than the display");
        if (options->views.background.kind == Background::Kind::none &&
            options->drawing.display != DisplayFormat::rgb888)
            throw UsageError("--background none draws with --pixel rgb888 only: a display shows no alpha");
        for (const PartPose& part : options->parts)
            if (part.from != part.to && options->views.turntable == 0)
                throw UsageError("--part " + part.name + "=FROM..TO moves over the views of --turntable; give it, too");
        run(*options, stages);
    });
}

}  // namespace lumi::tools
