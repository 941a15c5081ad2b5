// SPDX-License-Identifier: MIT
// lumi reference: path-traced pictures for the views of lumi render.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "commands/camera_options.h"
#include "commands/commands.h"
#include "commands/part_options.h"
#include "commands/scene_options.h"
#include "commands/state_options.h"
#include "files/output_file.h"
#include "image/picture_file.h"
#include "lumi/baker/reference.h"
#include "math/pi.h"
#include "program/option_checks.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

struct ReferenceOptions {
    SceneOptions scene;
    ViewOptions views;
    baker::ReferenceSettings settings;
    std::string output;
    std::string view;       // a camera of the scene's file; may be empty
    std::string save_pose;  // a file to write; may be empty
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

// With --over the picture may have another size, and then this is off.
uint64_t rays_of_an_eye(const ReferenceOptions& options)
{
    const ViewOptions& views = options.views;
    return static_cast<uint64_t>(views.width_px) * static_cast<uint64_t>(views.height_px) * options.settings.samples;
}

// An .exr file holds linear light and its coverage.
void check_linear(const CLI::App& command)
{
    for (const char* option : {"--background", "--over"})
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
        [&](const Eye& eye) {
            return exr_bytes(baker::trace_radiance(scene, eye.camera, settings, series.next(rays_of_an_eye(options))));
        });
}

std::vector<std::string> write_encoded(const ReferenceOptions& options, const baker::ReferenceSettings& settings,
                                       const baker::Scene& scene, baker::JobSeries& series)
{
    baker::RgbaImage image;
    const Eye* traced = nullptr;  // `image` shows it: over another colour it need not be traced again
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
    baker::JobSeries series(watch(printer),
                            static_cast<uint64_t>(std::max(1, options.views.turntable)) * rays_of_an_eye(options));
    const auto write = is_exr_name(options.output) ? write_linear : write_encoded;
    try {
        return write(options, settings, scene, series);
    } catch (const baker::Cancelled&) {
        throw Interrupted();
    }
}

std::string names_of(const std::vector<baker::NamedView>& views)
{
    std::string text;
    for (const baker::NamedView& view : views) text += (text.empty() ? "" : ", ") + view.name;
    return text;
}

const baker::NamedView& view_of(const std::string& name, const std::string& file,
                                const std::vector<baker::NamedView>& views)
{
    const auto found =
        std::find_if(views.begin(), views.end(), [&](const baker::NamedView& view) { return view.name == name; });
    if (found != views.end()) return *found;
    if (views.empty()) throw Failure(file, "there is no camera in it", "leave out --view, or export cameras, too");
    throw Failure(file, "no camera in it is named '" + name + "'", "choose among: " + names_of(views));
}

// Cameras say how much they see from top to bottom.
double fov_over_longer_side(double fov_y_degrees, const ViewOptions& views)
{
    if (views.width_px <= views.height_px) return fov_y_degrees;
    constexpr double kDegree = kPi / 180;
    const double half = std::tan(fov_y_degrees * kDegree / 2) * views.width_px / views.height_px;
    return 2 * std::atan(half) / kDegree;
}

std::string text_of(const Matrix4& matrix)
{
    std::string text;
    for (size_t k = 0; k < matrix.size(); ++k) {
        char number[32];
        std::snprintf(number, sizeof number, "%.9g", matrix[k]);
        text += number + std::string(k % 4 == 3 ? "\n" : " ");
    }
    return text;
}

// The eye of a camera in the scene's file takes the place of --orbit.
void look_through(const ReferenceOptions& options, const baker::Scene& scene, ViewOptions& views)
{
    const baker::NamedView& view = view_of(options.view, options.scene.path, scene.views());
    views.matrix = view.pose;
    views.pose = "view '" + view.name + "'";
    if (views.fov_deg == 0) views.fov_deg = fov_over_longer_side(view.fov_y_degrees, views);
    if (options.save_pose.empty()) return;
    write_output(options.save_pose, text_of(view.pose));
    print(stderr, "lumi: the same view of a field: lumi render FIELD --pose %s --fov %.4g\n",
          shell_word(options.save_pose).c_str(), views.fov_deg);
}

void run(ReferenceOptions options, const CLI::App& command)
{
    if (is_exr_name(options.output)) check_linear(command);
    size_t warnings = 0;
    const baker::Scene scene = load_scene(options.scene, warnings);
    if (!options.view.empty()) look_through(options, scene, options.views);
    for (const std::string& path : write_references(options, scene)) print(stdout, "%s\n", path.c_str());
}

}  // namespace

void add_reference(CLI::App& lumi)
{
    auto options = std::make_shared<ReferenceOptions>();
    CLI::App* command =
        lumi.add_subcommand("reference", "Path-trace views of a scene: the truth that fields approximate");
    add_scene_options(*command, options->scene);
    add_part_option(*command, options->scene.parts, PartWords::motion_and_pose);
    add_state_option(*command, options->scene.states, StateWords::weights);
    add_colour_option(*command, options->scene.base_colours);
    add_thread_option(*command, options->scene);
    add_picture_output(*command, options->output, "OUT.png|OUT.webp|OUT.exr", wrong_reference_name);
    add_camera_options(*command, options->views, "black");
    CLI::Option* view = command
                            ->add_option("--view", options->view,
                                         "Look through the camera of this name in a glTF file, in place of --orbit")
                            ->type_name("NAME")
                            ->excludes("--orbit")
                            ->excludes("--pose")
                            ->excludes("--turntable")
                            ->excludes("--over");
    command->add_option("--save-pose", options->save_pose, "With --view: write the eye here, for lumi render --pose")
        ->type_name("POSE.txt")
        ->needs(view);
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
