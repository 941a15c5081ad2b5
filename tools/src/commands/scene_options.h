// SPDX-License-Identifier: MIT
// Options that `lumi bake` and `lumi reference` share: the scene, and how it is read.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "files/field_file.h"
#include "lumi/baker/scene.h"

namespace lumi::tools
{

struct SceneOptions {
    std::string path;
    std::optional<baker::UpAxis> up;
    std::optional<baker::Environment> sky;
    std::string sky_picture;  // in place of `sky`; may be empty
    std::optional<double> exposure_stops;
    baker::ColourScale colours = baker::ColourScale::unstated;
    std::optional<baker::AnimationTime> animation;
    std::string frame;  // may be empty, see baker::LoadOptions
    std::optional<float> iso;
    double pieces = baker::IsoSurface{}.pieces;
    std::vector<baker::PartOptions> parts;
    std::vector<baker::StateOption> states;
    std::vector<std::string> tints;  // as baker::LoadOptions has them
    std::vector<baker::StateOption> base_colours;
    bool solid_volume = false;  // for surface fields, see baker::LoadOptions
    unsigned threads = 0;
};

// Reads a colour: one number for grey, or three with commas. Nothing where that is none.
std::optional<std::array<float, 3>> colour_of(const std::string& word);

// Adds SCENE, --up, --sky, --exposure, --colours, --frame, --animation, --iso and --pieces; parsed values go to
// `options`, which must outlive the parse.
void add_scene_options(CLI::App& command, SceneOptions& options);
void add_thread_option(CLI::App& command, SceneOptions& options);

// Loads the scene with the sphere that every subcommand fits alike; prints warnings to stderr and counts them.
baker::Scene load_scene(const SceneOptions& options, size_t& warnings);
// Does so without a word; appends the warnings.
baker::Scene load_scene(const SceneOptions& options, std::vector<std::string>& warnings);

// Whether the field is one of the scene, as far as its sphere tells.
bool has_sphere_of(const FieldFile& field, const baker::Scene& scene);

}  // namespace lumi::tools
