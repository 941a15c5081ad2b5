// SPDX-License-Identifier: MIT
// Holds what a glTF 2.0 file says, as plain data. Its terms are those of the specification. Indices may be out of
// range: who follows one checks it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "material/texture_slot.h"
#include "util/json_text.h"
#include "volume/affine.h"

namespace lumi::baker
{

// Where EXT_meshopt_compression packs a view's elements.
struct GltfMeshopt {
    int32_t buffer = kNoIndex;
    size_t offset = 0, length = 0, stride = 0, count = 0;
    std::string mode, filter;
};

struct GltfView {
    int32_t buffer = kNoIndex;
    size_t offset = 0, length = 0, stride = 0;  // bytes; stride 0: without gaps
    std::optional<GltfMeshopt> packed = std::nullopt;
};

// Where numbers lie, of a component type such as 5126 (binary32).
struct GltfRun {
    int32_t view = kNoIndex;
    size_t offset = 0, count = 0;
    int32_t component = 0;
};

struct GltfAccessor {
    GltfRun run;  // without a view all numbers are 0
    uint32_t width = 1;
    bool normalized = false;
    std::optional<GltfRun> sparse_indices;  // which elements `sparse_values` replace
    GltfRun sparse_values;
};

// Where KHR_draco_mesh_compression packs a primitive.
struct GltfDraco {
    int32_t view = kNoIndex;
    std::map<std::string, int32_t> attributes;  // by Draco's own numbers
};

struct GltfPrimitive {
    std::map<std::string, int32_t> attributes;
    std::vector<std::map<std::string, int32_t>> targets;  // of a morph: what a weight of 1 adds to attributes
    int32_t indices = kNoIndex, material = kNoIndex;
    int32_t mode = 4;
    std::optional<GltfDraco> packed = std::nullopt;
};

struct GltfNode {
    std::string name;
    std::vector<int32_t> children;
    int32_t mesh = kNoIndex, camera = kNoIndex, light = kNoIndex, skin = kNoIndex;
    std::vector<double> translation, rotation, scale;  // may be empty
    Affine matrix{};                                   // by these, or the file's own
    std::vector<float> weights;                        // of its mesh's targets: the node's, or else the mesh's
};

struct GltfSkin {
    std::string name;
    std::vector<int32_t> joints;  // nodes
    int32_t inverse_bind = kNoIndex;
};

// Which property of a node takes which values at which times.
struct GltfChannel {
    int32_t node = kNoIndex, input = kNoIndex, output = kNoIndex;
    std::string path, interpolation;
};

struct GltfAnimation {
    std::string name;
    std::vector<GltfChannel> channels;
};

// This is a light of KHR_lights_punctual.
struct GltfLight {
    enum class Type { directional, point, spot };
    Type type = Type::point;
    Rgb intensity;  // candela, or lux if directional, in each colour
    double inner_cone = 0, outer_cone = 0;
};

struct GltfCamera {
    std::string name;
    double fov_y = 0;  // radians; 0 without perspective
};

struct GltfImage {
    std::string name;   // for messages
    std::string bytes;  // its file holds them; empty where that is missing
};

// A texture where a material uses it.
struct GltfTextureUse {
    int32_t image = kNoIndex;
    int32_t uv_set = 0;
    Vec2 scale = {1, 1}, offset;
    double rotation = 0;
    bool far_off = false;  // the file's scale or offset is beyond any pixel, and not here
    double strength = 1;   // normals have it
    std::array<Wrap, 2> wrap = {Wrap::repeat, Wrap::repeat};

    bool used() const { return image != kNoIndex; }
    bool lies_as(const GltfTextureUse& other) const
    {
        return uv_set == other.uv_set && scale.x == other.scale.x && scale.y == other.scale.y &&
               offset.x == other.offset.x && offset.y == other.offset.y && rotation == other.rotation &&
               wrap == other.wrap;
    }
};

enum class GltfAlpha { opaque, mask, blend };

struct GltfMaterial {
    std::string name;
    Rgb base = grey(1);
    float alpha = 1, cutoff = 0.5f, metalness = 1, roughness = 1;
    GltfAlpha alpha_mode = GltfAlpha::opaque;
    Rgb emission;
    GltfTextureUse base_texture, metal_rough_texture, normal_texture, emission_texture;
    std::map<std::string, JsonValue> extensions;
};

struct GltfTexture {
    int32_t image = kNoIndex;
    std::array<Wrap, 2> wrap = {Wrap::repeat, Wrap::repeat};
};

struct GltfModel {
    std::filesystem::path file;
    std::vector<std::string> buffers;
    std::vector<GltfView> views;
    std::vector<GltfAccessor> accessors;
    std::vector<std::vector<GltfPrimitive>> meshes;
    std::vector<GltfNode> nodes;
    std::vector<int32_t> roots;  // nodes of the scene that is shown
    std::vector<GltfMaterial> materials;
    std::vector<GltfTexture> textures;
    std::vector<GltfImage> images;
    std::vector<GltfLight> lights;
    std::vector<GltfCamera> cameras;
    std::vector<GltfSkin> skins;
    std::vector<GltfAnimation> animations;
};

// Numbers that are not there do nothing: {x, y, z}, a quaternion {x, y, z, w}, and {x, y, z}.
Affine affine_of(const std::vector<double>& translation, const std::vector<double>& rotation,
                 const std::vector<double>& scale);

// Throws SceneError that names the file.
[[noreturn]] void fail_gltf(const GltfModel& model, const std::string& text);

// The element, which `what` names; throws SceneError if there is none.
template <class T>
const T& element_of(const GltfModel& model, const std::vector<T>& list, int32_t index, const char* what)
{
    if (index < 0 || static_cast<size_t>(index) >= list.size()) {
        fail_gltf(model, std::string(what) + " " + std::to_string(index) + " is used, but there are " +
                             std::to_string(list.size()) + "; export the file again");
    }
    return list[static_cast<size_t>(index)];
}

// Reads glTF 2.0 files, .gltf or .glb, with their buffers and pictures: tinygltf behind a wall.

// Files are found as those of an OBJ (find_beside). Throws SceneError, also for what a file requires and we cannot
// read.
GltfModel read_gltf_file(const std::filesystem::path& file);

}  // namespace lumi::baker
