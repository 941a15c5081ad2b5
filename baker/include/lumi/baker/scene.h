// SPDX-License-Identifier: MIT
// A scene to bake: triangles, materials and lights inside a bounding sphere.
//
// The scene keeps its own copy of everything; files may vanish after loading. A Scene is immutable and may be traced
// from any number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace lumi::baker
{

// A file asks for something that cannot be baked. what() reads "file:line: what is wrong; how to mend it"; the line is
// left out where the fault has none.
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The axis of the scene that becomes the sphere's z, its north pole. y: sphere(x,y,z) = scene(z,x,y); z: identity.
enum class UpAxis : uint8_t { y, z };

struct RadiancePicture;  // see baker/src

// Linear radiance (Rec. 709 primaries) that arrives from far away: linear in the height of the direction from nadir
// over horizon to zenith, or a picture. It lights the scene; rays of the field and of the reference never see it
// directly.
struct Environment {
    std::array<float, 3> zenith, horizon, nadir;
    std::shared_ptr<const RadiancePicture> picture = nullptr;  // in place of the three colours
    float rotation_degrees = 0;  // how far the picture is turned, counterclockwise as seen from above
    float scale = 1;             // factor on all radiance
    bool needs_exposure = true;  // a picture that may have any unit
};

Environment constant_environment(float radiance);
Environment constant_environment(const std::array<float, 3>& radiance);
// This is a bright, slightly cool sky over a dimmer, warm floor.
Environment gradient_environment();
// Soft boxes of a product photographer, neutral, with a dark side. They light what has no light of its own.
Environment studio_environment();

// Skies that have names. All but black send the same light to a white ball.
inline const std::vector<std::string> kSkyNames = {"studio", "gradient", "overcast", "evening", "black"};
std::optional<Environment> named_environment(const std::string& name);

// A latitude-longitude map in a Radiance .hdr or an OpenEXR file, as docs/scenes.md says. Throws SceneError; appends to
// `warnings`.
Environment picture_environment(const std::filesystem::path& file, std::vector<std::string>& warnings);

// The scale of colours in MTL files: linear light, or encoded (sRGB) as a display shows them. Unstated: linear, and a
// warning where they look encoded.
enum class ColourScale : uint8_t { unstated, linear, display };

inline constexpr double kMostStops = 20;  // exposure goes so far to either side

// The surface in a volume where its values cross a number.
struct IsoSurface {
    float value = 0;  // larger values are inside
    // Pieces with less than this share of the largest one's area are left out, 0 to 1. In CT smaller ones are marrow
    // and noise; what the patient lay on may be larger.
    double pieces = 0.05;
};

// The scene's file has this camera.
struct NamedView {
    std::string name;
    // Row by row, rigid: from the camera's axes (it looks along -z, y up) to those of the sphere, whose radius is 1.
    std::array<double, 16> pose;
    double fov_y_degrees;
};

// A time of an animation of a glTF file, which is then posed so.
struct AnimationTime {
    std::string name;
    double seconds = 0;
};
// Reads "NAME@SECONDS", or "NAME" for its begin. Nothing where the seconds are no number.
std::optional<AnimationTime> animation_time(const std::string& text);

// A piece of the scene that turns about an axis, or slides along it, as the hand of a clock does.
struct PartOptions {
    std::string name;                                           // all objects, groups or nodes, or else a material
    std::optional<std::array<double, 3>> axis = std::nullopt;   // of the node's own frame; without one, of the scene's
    std::optional<std::array<double, 3>> pivot = std::nullopt;  // scene units and axes; of a node, its origin
    std::optional<std::array<double, 2>> range = std::nullopt;  // of poses, least first: degrees, or scene units
    bool slides = false;
    double at = 0;                                // the pose of the files: degrees, right-handed, or scene units
    double value = 0;                             // the pose that is traced
    std::optional<double> lit_at = std::nullopt;  // the pose whose light it has in a field; open: the mean of several
};

// A lamp's node, a material that shines, a label of a scene file, or "sky": lights whose weight can be chosen.
struct StateOption {
    std::string name;
    std::array<float, 3> weight = {1, 1, 1};  // of linear light, 0 to 1
};

// Reads "x", "y", "z", or "-x" and the like. Nothing for other words.
std::optional<std::array<double, 3>> axis_named(const std::string& word);

// Options that are left open here are as the scene file says, or else the default.
struct LoadOptions {
    std::optional<UpAxis> up = std::nullopt;  // y
    // The sphere's radius is the smallest one around all triangles times (1 + margin), so that nothing touches it. >=
    // 0.
    double margin = 0.01;
    // The studio, unless the scene has lamps, or materials that shine and by themselves light most of it.
    std::optional<Environment> environment = std::nullopt;
    // In stops: all light is multiplied by 2 to this power. At most kMostStops to either side. 0; for light of lamps or
    // a picture what gives the scene a middle tone.
    std::optional<double> exposure_stops = std::nullopt;
    ColourScale colours = ColourScale::unstated;
    // An object, group, node or material: the sphere is fitted to it, and what lies outside of the sphere is cut off.
    // Empty: the sphere holds all of the scene.
    std::string frame;
    std::optional<AnimationTime> animation = std::nullopt;  // only for glTF; at rest
    // One that a scene file has, too, needs no axis: it gives the pose.
    std::vector<PartOptions> parts = {};
    // They become light states, besides those of a scene file, and the scene is lit with these weights.
    std::vector<StateOption> states = {};
    // In place of light states: materials whose base colour is chosen when a field is drawn. Weights are colours.
    std::vector<std::string> tints = {};
    std::vector<StateOption> base_colours = {};    // of these materials
    std::optional<IsoSurface> iso = std::nullopt;  // only for a volume
    // Also makes the mesh that surface fields of a volume without objects start from.
    bool solid_volume = false;
};

struct SceneData;  // baker's own view, see baker/src

class Scene
{
public:
    explicit Scene(std::unique_ptr<const SceneData> data);
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;
    ~Scene();

    // Returns the bounding sphere in scene units and scene axes, margin included.
    std::array<float, 3> centre() const;
    float radius() const;
    UpAxis up() const;

    size_t triangle_count() const;
    size_t light_count() const;  // emissive triangles and the extra lights of a scene file
    // Choices about pose and light that files and options leave open: a sentence each.
    const std::vector<std::string>& notes() const;
    // In the order of the file. Names may come twice or be empty.
    const std::vector<NamedView>& views() const;
    std::vector<std::string> moving_parts() const;  // names
    std::vector<std::string> light_states() const;  // names, base first; empty where there are none
    bool mesh_is_shell() const;  // a volume without objects got its mesh by LoadOptions::solid_volume

    // A hash of all that decides light paths: the same files and options give the same value on every machine and in
    // every version of this program. Cost: one pass over the scene.
    std::array<uint64_t, 2> fingerprint() const;

    const SceneData& data() const { return *data_; }

private:
    std::unique_ptr<const SceneData> data_;
};

// Reads a scene file (docs/scenes.md), by its name's end .json, an iso-surface of a volume, by .nii, .nii.gz or .vdb,
// or else an OBJ file with its MTL files and textures. Throws SceneError. Appends one line per doubtful thing that
// could still be drawn, each in the form of SceneError's text, to `warnings`.
Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, std::vector<std::string>& warnings);

}  // namespace lumi::baker
