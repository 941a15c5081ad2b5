// SPDX-License-Identifier: MIT
#include "commands/scene_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <sstream>

#include "program/option_checks.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{
namespace
{

bool is_picture_name(const std::string& word)
{
    const std::string ending = small_ending(word);
    return ending == ".hdr" || ending == ".exr";
}

}  // namespace

std::optional<std::array<float, 3>> colour_of(const std::string& word)
{
    constexpr float kMaxRadiance = 1e9f;
    std::array<float, 3> colour{};
    size_t count = 0;
    std::istringstream stream(word);
    for (std::string part; std::getline(stream, part, ','); ++count) {
        const auto [end, error] =
            std::from_chars(part.data(), part.data() + part.size(), colour[std::min<size_t>(count, 2)]);
        if (error != std::errc() || end != part.data() + part.size()) return std::nullopt;
    }
    if (count == 1) colour[1] = colour[2] = colour[0];
    const bool sound = std::all_of(colour.begin(), colour.end(), [](float c) { return c >= 0 && c <= kMaxRadiance; });
    return sound && (count == 1 || count == 3) && word.back() != ',' ? std::optional(colour) : std::nullopt;
}

namespace
{

// NAME, or NAME@DEGREES.
std::optional<baker::Environment> named_sky(const std::string& word)
{
    const size_t at = std::min(word.find('@'), word.size());
    std::optional<baker::Environment> sky = baker::named_environment(word.substr(0, at));
    if (!sky || at == word.size()) return sky;
    if (!number(-360, 360)(word.substr(at + 1)).empty()) return std::nullopt;
    sky->rotation_degrees = std::stof(word.substr(at + 1));
    return sky;
}

baker::Environment sky_of(const std::string& word)
{
    if (const auto named = named_sky(word)) return *named;
    const auto colour = colour_of(word);
    if (!colour)
        throw CLI::ValidationError("--sky",
                                   "takes studio, gradient, overcast, evening or black, also with @DEGREES, a colour "
                                   "such as 0.8 or 1,0.9,0.7, or a picture (.hdr or .exr), not \"" +
                                       word + "\"");
    return baker::constant_environment(*colour);
}

void set_sky(const std::string& word, SceneOptions& options)
{
    if (is_picture_name(word))
        options.sky_picture = word;
    else
        options.sky = sky_of(word);
}

}  // namespace

void add_scene_options(CLI::App& command, SceneOptions& options)
{
    const OptionGroup group(command, "Scene and light");
    command
        .add_option("SCENE", options.path,
                    "A scene file (.json); a model (.glb, .gltf, .stl, .ply, or .obj with its files beside it); or a "
                    "volume (.nii, .nii.gz, .vdb) with --iso")
        ->required();
    add_choice<std::optional<baker::UpAxis>>(command, "--up", options.up,
                                             {{"y", baker::UpAxis::y}, {"z", baker::UpAxis::z}},
                                             "The scene's vertical axis [as the scene file says, or y; z of volumes]");
    command
        .add_option(
            "--iso", options.iso,
            "For a volume: the value whose surface is the scene; in CT, 300 (HU) is bone. In millimetres, z up: "
            "azimuth 0 shows the patient's right side, 90 the face")
        ->check(any_number())
        ->type_name("VALUE");
    command
        .add_option("--pieces", options.pieces,
                    "With --iso: leave out pieces with less than this share of the largest one's area")
        ->check(number(0, 1))
        ->capture_default_str()
        ->type_name("SHARE");
    command
        .add_option_function<std::string>(
            "--sky", [&options](const std::string& word) { set_sky(word, options); },
            "Light from far away: studio (soft boxes), gradient, overcast, evening or black, turned with @DEGREES; a "
            "colour of "
            "linear radiance such as 0.8 or 1,0.9,0.7; or a latitude-longitude picture (.hdr, .exr) [as the scene file "
            "says, or studio for what has no light of its own]")
        ->type_name("NAME|COLOUR|FILE");
    command
        .add_option("--exposure", options.exposure_stops,
                    "All light is multiplied by 2 to this power, from -20 to 20; equal for bake, reference and report "
                    "[as the scene file says, or what lamps need, or 0]")
        ->check(number(-baker::kMostStops, baker::kMostStops))
        ->type_name("STOPS");
    add_choice<baker::ColourScale>(
        command, "--colours", options.colours,
        {{"linear", baker::ColourScale::linear}, {"display", baker::ColourScale::display}},
        "What Kd, Ks, Ke and Tf of MTL files are: linear light, or as a display shows them, "
        "which 3ds Max, SketchUp and Sweet Home 3D write [linear, with a warning where they look "
        "otherwise]");
    command
        .add_option("--frame", options.frame,
                    "Fit the sphere to the object, group, node or material of this name, and cut off what lies outside")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--animation",
            [&options](const std::string& word) {
                options.animation = baker::animation_time(word);
                if (!options.animation)
                    throw CLI::ValidationError("--animation", "takes NAME@SECONDS, not \"" + word + "\"");
            },
            "Pose a glTF model as its animation of this name does at its start, or at NAME@SECONDS [at rest]")
        ->type_name("NAME");
}

void add_thread_option(CLI::App& command, SceneOptions& options)
{
    command.add_option("--threads", options.threads, "Threads to use [all]; the result is the same for any number")
        ->check(whole_number(0, kMostThreads))
        ->type_name("T");
}

baker::Scene load_scene(const SceneOptions& options, std::vector<std::string>& warnings)
{
    baker::LoadOptions load;
    load.up = options.up;
    load.exposure_stops = options.exposure_stops;
    load.environment = options.sky;
    load.colours = options.colours;
    load.frame = options.frame;
    load.animation = options.animation;
    load.parts = options.parts;
    load.states = options.states;
    load.tints = options.tints;
    load.base_colours = options.base_colours;
    if (options.iso) load.iso = baker::IsoSurface{*options.iso, options.pieces};
    load.solid_volume = options.solid_volume;
    const LeaveAtOnce loading;
    const Waiting waiting("loading the scene");
    if (!options.sky_picture.empty()) load.environment = baker::picture_environment(options.sky_picture, warnings);
    return baker::load_scene(options.path, load, warnings);
}

baker::Scene load_scene(const SceneOptions& options, size_t& warnings)
{
    std::vector<std::string> lines;
    baker::Scene scene = load_scene(options, lines);
    for (const std::string& line : lines) print(stderr, "lumi: warning: %s\n", line.c_str());
    for (const std::string& note : scene.notes()) print(stderr, "lumi: %s\n", note.c_str());
    warnings = lines.size();
    return scene;
}

bool has_sphere_of(const FieldFile& field, const baker::Scene& scene)
{
    const FieldSphere sphere = field.sphere();
    return sphere.centre == scene.centre() && sphere.radius == scene.radius();
}

}  // namespace lumi::tools
