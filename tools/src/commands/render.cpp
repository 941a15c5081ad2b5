// SPDX-License-Identifier: MIT
// lumi render: pictures from a field file, by the renderer that firmware links.
#include <cstdio>
#include <memory>

#include "camera_options.h"
#include "choice.h"
#include "commands.h"
#include "lumi/tools/draw.h"
#include "lumi/tools/failure.h"
#include "lumi/tools/field_file.h"

namespace lumi::tools
{

namespace
{

struct RenderOptions {
    std::string field, output;
    ViewOptions views;
    DrawSettings drawing;
};

void run(const RenderOptions& options)
{
    const FieldFile file(options.field);
    file.require_intact();
    DrawSettings drawing = options.drawing;
    drawing.background = options.views.background;
    const auto draw_view = [&](const Camera& camera) { return draw(file.field(), camera, drawing); };
    for (const std::string& path : write_views(options.views, options.output, draw_view))
        std::printf("%s\n", path.c_str());
}

void add_drawing_options(CLI::App& command, DrawSettings& drawing)
{
    add_choice<Mode>(
        command, "--mode", drawing.mode, {{"nearest", Mode::nearest}, {"linear", Mode::linear}, {"paper", Mode::paper}},
        "MODE",
        "Reconstruction: nearest (1 texel a pixel), linear (3x3), or paper (KxK, the kernel of the LumiPath "
        "paper) [linear]");
    command.add_option("--neighbours", drawing.neighbours, "Neighbours a side for --mode paper")
        ->type_name("K")
        ->check(CLI::Range(1u, uint32_t{kMaxNeighbours}))
        ->capture_default_str();
    add_choice<DisplayFormat>(
        command, "--pixel", drawing.display,
        {{"rgb888", DisplayFormat::rgb888}, {"rgb565", DisplayFormat::rgb565}, {"grey8", DisplayFormat::grey8}},
        "FORMAT", "Display to preview: rgb888, rgb565 or grey8 [rgb888]");
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
    add_drawing_options(*command, options->drawing);
    command->footer(
        "Example:\n  lumi render product.lumi -o product.png --turntable 24 --mode paper --background 202428");
    command->callback([options, command] {
        if (command->count("--neighbours") > 0 && options->drawing.mode != Mode::paper)
            throw UsageError("--neighbours belongs to --mode paper");
        run(*options);
    });
}

}  // namespace lumi::tools
