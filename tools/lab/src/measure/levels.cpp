// SPDX-License-Identifier: MIT
// lumi-lab levels: how bright a scene and its surface field are from all around, edge-on views of a flat scene among
// them.
#include <cmath>
#include <memory>
#include <stdexcept>

#include "commands/scene_options.h"
#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "lumi/baker/reference.h"
#include "measure/commands.h"
#include "quality/held_out.h"

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;

constexpr double kElevations[] = {-60, -20, -8, -3, 3, 8, 20, 60};
constexpr int kAzimuths = 8;
constexpr double kDistance = 3;
constexpr double kFull = 255;

struct Options {
    tools::SceneOptions scene;
    std::string field;
    uint32_t samples = 64;
    int side_px = 120;
};

// The mean of all colour channels over what is covered, 0 to 255; `light` is premultiplied by the coverage.
double mean_level(double light, double coverage)
{
    return coverage > 0 ? light / coverage : 0;
}

double scene_level(const baker::Scene& scene, const quality::HeldOutView& view, uint32_t samples)
{
    const baker::RgbaImage image = render_reference(scene, view.eye.camera, {samples});
    double light = 0, coverage = 0;
    for (size_t k = 0; k < image.rgba.size(); k += 4) {
        for (size_t channel = 0; channel < 3; ++channel) light += image.rgba[k + channel];
        coverage += 3 * image.rgba[k + 3] / kFull;
    }
    return mean_level(light, coverage);
}

double field_level(const SeeThroughField& field, const quality::HeldOutView& view)
{
    tools::SurfaceDrawSettings settings;
    const tools::Picture over_black = draw_surface(field, view.eye, settings);
    settings.background = {255, 255, 255};
    const tools::Picture over_white = draw_surface(field, view.eye, settings);
    double light = 0, coverage = 0;
    for (size_t k = 0; k < over_black.rgb.size(); ++k) {
        light += over_black.rgb[k];
        coverage += 1 - (over_white.rgb[k] - over_black.rgb[k]) / kFull;
    }
    return mean_level(light, coverage);
}

void print_levels(const Options& options)
{
    const tools::FieldFile file(options.field);
    file.require_intact();
    if (!file.is_surface()) throw std::runtime_error(options.field + ": is no surface field");
    size_t warnings = 0;
    const baker::Scene scene = tools::load_scene(options.scene, warnings);
    Json results;
    for (const double elevation : kElevations) {
        for (int k = 0; k < kAzimuths; ++k) {
            const double azimuth = 360.0 * k / kAzimuths;
            const quality::HeldOutView view = quality::view_at(azimuth, elevation, kDistance, options.side_px);
            results.push_back({{"elevation", elevation},
                               {"azimuth", azimuth},
                               {"scene", hundredths(scene_level(scene, view, options.samples))},
                               {"field", hundredths(field_level(file.surface(), view))}});
        }
    }
    print(results);
}

}  // namespace

void add_levels(CLI::App& lab)
{
    auto options = std::make_shared<Options>();
    CLI::App* command =
        lab.add_subcommand("levels", "Compare how bright a scene and its surface field are from all around");
    add_scene_options(*command, options->scene);
    command->add_option("FIELD", options->field, "A surface field of the scene")->required();
    command->add_option("--spp", options->samples, "Light paths a pixel of the references")->capture_default_str();
    command->add_option("--size", options->side_px, "Pixels of a side of the views")->capture_default_str();
    command->callback([options] { print_levels(*options); });
}

}  // namespace lumi::lab
