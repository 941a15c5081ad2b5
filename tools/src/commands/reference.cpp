// SPDX-License-Identifier: MIT
// lumi reference: path-traced pictures for the views of lumi render.
#include <cstdio>
#include <memory>

#include "commands/camera_options.h"
#include "commands/commands.h"
#include "commands/scene_options.h"
#include "lumi/baker/reference.h"
#include "program/parse_problem.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"

namespace lumi::tools
{

namespace
{

struct ReferenceOptions {
    SceneOptions scene;
    ViewOptions views;
    baker::ReferenceSettings settings;
    std::string output;
};

Picture over_background(const baker::RgbaImage& image, const Rgb8& background)
{
    Picture picture(image.width, image.height);
    for (size_t i = 0; i < image.rgba.size() / 4; ++i) {
        const uint8_t* rgba = &image.rgba[4 * i];
        picture.rgb[3 * i] = over(rgba[0], rgba[3], background.r);
        picture.rgb[3 * i + 1] = over(rgba[1], rgba[3], background.g);
        picture.rgb[3 * i + 2] = over(rgba[2], rgba[3], background.b);
    }
    return picture;
}

// Draws and writes all views under one progress bar.
std::vector<std::string> write_references(const ReferenceOptions& options, const baker::Scene& scene)
{
    baker::ReferenceSettings settings = options.settings;
    settings.threads = options.scene.threads;
    ProgressPrinter printer(stderr, stderr_is_terminal());
    baker::RgbaImage image;
    const Eye* traced = nullptr;  // what `image` shows: over another colour it need not be traced again
    const auto draw = [&](const Eye& eye, const Rgb8& background) {
        if (traced != &eye) image = baker::render_reference(scene, eye.camera, settings, watch(printer));
        traced = &eye;
        return over_background(image, background);
    };
    try {
        return write_views(options.views, options.output, draw);
    } catch (const baker::Cancelled&) {
        throw Interrupted();
    }
}

void run(const ReferenceOptions& options)
{
    size_t warnings = 0;
    const baker::Scene scene = load_scene(options.scene, warnings);
    for (const std::string& path : write_references(options, scene)) std::printf("%s\n", path.c_str());
}

}  // namespace

void add_reference(CLI::App& lumi)
{
    auto options = std::make_shared<ReferenceOptions>();
    CLI::App* command =
        lumi.add_subcommand("reference", "Path-trace views of a scene: the truth that fields approximate");
    add_scene_options(*command, options->scene);
    add_picture_output(*command, options->output);
    add_camera_options(*command, options->views);
    command->add_option("--spp", options->settings.samples, "Light paths per pixel")
        ->type_name("S")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--seed", options->settings.seed, "Seed of the random numbers")
        ->type_name("K")
        ->check(whole_number)
        ->capture_default_str();
    command->footer(
        "The bounding sphere is fitted as in lumi bake, so equal camera options show the same view.\n"
        "Example:\n  lumi reference product.obj -o truth.png --orbit 30,20,3 --spp 256");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
