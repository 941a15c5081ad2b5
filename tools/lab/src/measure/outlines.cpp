// SPDX-License-Identifier: MIT
// lumi-lab outlines: how far the outlines of a surface field lie from its scene's, in pixels of 240 × 240 views.
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "commands/scene_options.h"
#include "draw/draw_surface.h"
#include "files/field_file.h"
#include "image/picture.h"
#include "lumi/baker/reference.h"
#include "measure/commands.h"
#include "quality/references.h"

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;
using tools::Mask;

constexpr int kFine = 4;           // samples a pixel, along either axis
constexpr int kReach = 8 * kFine;  // farther than this from an outline is as far as this; in samples
constexpr double kWithin = 0.5;    // pixels

Mask scene_mask(const baker::Scene& scene, const quality::HeldOutView& view)
{
    const baker::RgbaImage image = render_reference(scene, view.eye.camera, {1});
    Mask mask(image.width, image.height);
    for (size_t k = 0; k < mask.values.size(); ++k) mask.values[k] = image.rgba[4 * k + 3] != 0 ? 1 : 0;
    return mask;
}

Mask field_mask(const SurfaceField& field, const quality::HeldOutView& view)
{
    const tools::Plane<uint16_t> depths = tools::surface_depths(field, view.eye);
    Mask mask(depths.width_px, depths.height_px);
    for (size_t k = 0; k < mask.values.size(); ++k) mask.values[k] = depths.values[k] != 0 ? 1 : 0;
    return mask;
}

// From a sample to the outline of `truth`: to the nearest sample that `truth` has the other way. In pixels.
double outline_distance(const Mask& truth, int x, int y)
{
    int nearest = kReach * kReach;
    for (int v = std::max(0, y - kReach); v <= std::min(truth.height_px - 1, y + kReach); ++v) {
        for (int u = std::max(0, x - kReach); u <= std::min(truth.width_px - 1, x + kReach); ++u)
            if (truth.at(u, v) != truth.at(x, y)) nearest = std::min(nearest, (u - x) * (u - x) + (v - y) * (v - y));
    }
    return std::sqrt(static_cast<double>(nearest)) / kFine;
}

// Borders between samples, in pixels.
double outline_length(const Mask& mask)
{
    int borders = 0;
    for (int y = 1; y < mask.height_px; ++y) {
        for (int x = 1; x < mask.width_px; ++x) {
            borders += mask.at(x, y) != mask.at(x - 1, y) ? 1 : 0;
            borders += mask.at(x, y) != mask.at(x, y - 1) ? 1 : 0;
        }
    }
    return static_cast<double>(borders) / kFine;
}

Json compared(const Mask& truth, const Mask& drawn)
{
    double worst = 0;
    int wrong = 0, beyond = 0;
    for (int y = 0; y < truth.height_px; ++y) {
        for (int x = 0; x < truth.width_px; ++x) {
            if (truth.at(x, y) == drawn.at(x, y)) continue;
            const double distance = outline_distance(truth, x, y);
            worst = std::max(worst, distance);
            ++wrong;
            beyond += distance > kWithin ? 1 : 0;
        }
    }
    const auto pixels = [](int samples) { return hundredths(static_cast<double>(samples) / (kFine * kFine)); };
    const double length = std::max(1.0, outline_length(truth));
    return {{"mean_px", hundredths(wrong / (length * kFine * kFine))},
            {"worst_px", hundredths(worst)},
            {"wrong_area_px", pixels(wrong)},
            {"beyond_half_area_px", pixels(beyond)}};
}

void print_outlines(const tools::SceneOptions& options, const std::string& path)
{
    const tools::FieldFile file(path);
    file.require_intact();
    if (!file.is_surface()) throw std::runtime_error(path + ": is no surface field; only meshes have outlines");
    size_t warnings = 0;
    const baker::Scene scene = tools::load_scene(options, warnings);
    Json results;
    for (const quality::HeldOutView& view :
         quality::held_out_views(quality::ViewSet::all, quality::kHeldOutViews, kFine * quality::kViewSidePx)) {
        Json row = {{"view", text_of(view)}};
        row.update(compared(scene_mask(scene, view), field_mask(file.surface(), view)));
        results.push_back(row);
    }
    print(results);
}

}  // namespace

void add_outlines(CLI::App& lab)
{
    struct Options {
        tools::SceneOptions scene;
        std::string field;
    };
    auto options = std::make_shared<Options>();
    CLI::App* command =
        lab.add_subcommand("outlines", "Measure how far a surface field's outlines lie from its scene's, in pixels");
    add_scene_options(*command, options->scene);
    command->add_option("FIELD", options->field, "A surface field of the scene")->required();
    command->callback([options] { print_outlines(options->scene, options->field); });
}

}  // namespace lumi::lab
