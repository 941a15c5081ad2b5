// SPDX-License-Identifier: MIT
// lumi reference: path-traced pictures for the views of lumi render.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "commands/camera_options.h"
#include "commands/commands.h"
#include "commands/scene_options.h"
#include "image/exr.h"
#include "lumi/baker/reference.h"
#include "program/option_checks.h"
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

uint64_t eyes_of(const ViewOptions& views)
{
    return static_cast<uint64_t>(std::max(1, views.turntable)) * (views.eye_distance > 0 ? 2 : 1);
}

// With --over the picture may have another size, and then this is off.
uint64_t rays_of_an_eye(const ReferenceOptions& options)
{
    const ViewOptions& views = options.views;
    return static_cast<uint64_t>(views.width_px) * static_cast<uint64_t>(views.height_px) * options.settings.samples;
}

// An .exr file holds one eye's linear light and its coverage.
void check_linear(const CLI::App& command)
{
    for (const char* option : {"--stereo", "--background", "--over"})
        if (command.count(option) > 0)
            throw UsageError(
                std::string(option) +
                " does not go with a picture of linear light, whose channel A holds the coverage; leave it "
                "out, or write a .png");
}

std::vector<std::string> write_linear(const ReferenceOptions& options, const baker::ReferenceSettings& settings,
                                      const baker::Scene& scene, baker::JobSeries& series)
{
    return write_each_view(
        options.views, options.output,
        [&](const Eye& eye, const std::string& path) {
            write_exr(path, baker::trace_radiance(scene, eye.camera, settings, series.next(rays_of_an_eye(options))));
        });
}

std::vector<std::string> write_encoded(const ReferenceOptions& options, const baker::ReferenceSettings& settings,
                                       const baker::Scene& scene, baker::JobSeries& series)
{
    baker::RgbaImage image;
    const Eye* traced = nullptr;  // what `image` shows: over another colour it need not be traced again
    const auto draw = [&](const Eye& eye, const Rgb8& background) {
        if (traced != &eye)
            image = baker::render_reference(scene, eye.camera, settings, series.next(rays_of_an_eye(options)));
        traced = &eye;
        return over_background(image, background);
    };
    return write_views(options.views, options.output, draw);
}

// Draws and writes all views under one progress bar.
std::vector<std::string> write_references(const ReferenceOptions& options, const baker::Scene& scene)
{
    baker::ReferenceSettings settings = options.settings;
    settings.threads = options.scene.threads;
    ProgressPrinter printer(stderr, stderr_is_terminal());
    baker::JobSeries series(watch(printer), eyes_of(options.views) * rays_of_an_eye(options));
    const auto write = is_exr_name(options.output) ? write_linear : write_encoded;
    try {
        return write(options, settings, scene, series);
    } catch (const baker::Cancelled&) {
        throw Interrupted();
    }
}

void run(const ReferenceOptions& options, const CLI::App& command)
{
    if (is_exr_name(options.output)) check_linear(command);
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
    add_picture_output(*command, options->output, "OUT.png|OUT.webp|OUT.exr", wrong_reference_name);
    add_camera_options(*command, options->views);
    command->add_option("--spp", options->settings.samples, "Light paths per pixel")
        ->type_name("S")
        ->check(whole_number(1, kMostPaths))
        ->capture_default_str();
    command->add_option("--seed", options->settings.seed, "Seed of the random numbers")
        ->type_name("K")
        ->check(whole_number(0, UINT64_MAX))
        ->capture_default_str();
    command->footer(
        "The bounding sphere is fitted as in lumi bake, so equal camera options show the same view.\n"
        "An .exr holds linear light, before exposure and tone curve, and the coverage in its channel A.\n"
        "Example:\n  lumi reference product.obj -o truth.png --orbit 30,20,3 --spp 256");
    command->callback([options, command] { run(*options, *command); });
}

}  // namespace lumi::tools
