// SPDX-License-Identifier: MIT
#include "model/gltf/model.h"

#include <tiny_gltf.h>
#include <algorithm>

#include "lumi/baker/scene.h"
#include "model/gltf/container.h"
#include "model/gltf/decompress.h"
#include "model/gltf/extensions.h"
#include "model/materials.h"
#include "util/text_lines.h"

namespace lumi::baker
{

// The one file that sees tinygltf.

namespace
{

constexpr const char* kLights = "KHR_lights_punctual";

struct FilesBeside {
    std::filesystem::path model;
    std::string missing;  // the last name that was not found

    static FilesBeside& at(void* data) { return *static_cast<FilesBeside*>(data); }
};

// Answers what tinygltf asks of the disk: it sees only names that find_beside finds.
tinygltf::FsCallbacks callbacks_of(FilesBeside& beside)
{
    tinygltf::FsCallbacks files{};
    files.FileExists = [](const std::string& name, void* data) {
        const bool is_there = !find_beside(FilesBeside::at(data).model, name).empty();
        if (!is_there) FilesBeside::at(data).missing = name;
        return is_there;
    };
    files.ExpandFilePath = [](const std::string& name, void*) { return name; };
    files.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& name, void* data) {
        const std::string bytes = read_file(find_beside(FilesBeside::at(data).model, name));
        out->assign(bytes.begin(), bytes.end());
        return true;
    };
    files.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
        return false;
    };
    files.user_data = &beside;
    return files;
}

// Keeps the bytes as they are. Those in views are taken later, when the view is known to lie in its buffer.
bool keep_image(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes,
                int size, void*)
{
    if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
    return true;
}

JsonValue json_of(const tinygltf::Value& value)
{
    JsonValue result;
    if (value.IsNumber() || value.IsBool()) {
        result.kind = value.IsBool() ? JsonValue::Kind::boolean : JsonValue::Kind::number;
        result.number = value.IsBool() ? (value.Get<bool>() ? 1 : 0) : value.GetNumberAsDouble();
    } else if (value.IsString()) {
        result.kind = JsonValue::Kind::text;
        result.text = value.Get<std::string>();
    } else if (value.IsArray()) {
        result.kind = JsonValue::Kind::list;
        for (const tinygltf::Value& item : value.Get<tinygltf::Value::Array>()) result.items.push_back(json_of(item));
    } else if (value.IsObject()) {
        result.kind = JsonValue::Kind::object;
        for (const auto& [name, member] : value.Get<tinygltf::Value::Object>())
            result.members.emplace_back(name, json_of(member));
    }
    return result;
}

std::map<std::string, JsonValue> json_of(const tinygltf::ExtensionMap& extensions)
{
    std::map<std::string, JsonValue> result;
    for (const auto& [name, value] : extensions) result[name] = json_of(value);
    return result;
}

Rgb colour_of(const std::vector<double>& c, const Rgb& fallback)
{
    return c.size() < 3 ? fallback : Rgb{float_of(c[0]), float_of(c[1]), float_of(c[2])};
}

GltfAccessor accessor_of(const tinygltf::Accessor& a)
{
    GltfAccessor result;
    const int width = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type));
    result.run = {a.bufferView, a.byteOffset, a.count, a.componentType};
    result.width = width > 0 ? static_cast<uint32_t>(width) : 1;
    result.normalized = a.normalized;
    if (a.sparse.isSparse) {
        // int or size_t, by the version of tinygltf
        const auto at_least_0 = [](auto value) {
            return static_cast<int64_t>(value) < 0 ? SIZE_MAX : static_cast<size_t>(value);
        };
        const size_t count = at_least_0(a.sparse.count);
        result.sparse_indices = GltfRun{a.sparse.indices.bufferView, at_least_0(a.sparse.indices.byteOffset), count,
                                        a.sparse.indices.componentType};
        result.sparse_values = {a.sparse.values.bufferView, at_least_0(a.sparse.values.byteOffset), count,
                                a.componentType};
    }
    return result;
}

int32_t index_member(const JsonValue& value, const char* name)
{
    return static_cast<int32_t>(std::clamp(number_member(value, name, kNoIndex), -1.0, 1e9));
}

GltfView view_of(const tinygltf::BufferView& v)
{
    GltfView result{v.buffer, v.byteOffset, v.byteLength, v.byteStride};
    const auto found = v.extensions.find("EXT_meshopt_compression");
    if (found == v.extensions.end()) return result;
    const JsonValue value = json_of(found->second);
    const auto size = [&](const char* name) {
        return static_cast<size_t>(std::clamp(number_member(value, name, 0), 0.0, 4e9));
    };
    const auto text = [&](const char* name) {
        const JsonValue* member = find_member(value, name);
        return member ? member->text : std::string();
    };
    result.packed = GltfMeshopt{index_member(value, "buffer"),
                                size("byteOffset"),
                                size("byteLength"),
                                size("byteStride"),
                                size("count"),
                                text("mode"),
                                text("filter")};
    return result;
}

GltfPrimitive primitive_of(const tinygltf::Primitive& p)
{
    GltfPrimitive result{p.attributes, p.targets, p.indices, p.material, p.mode, std::nullopt};
    const auto draco = p.extensions.find("KHR_draco_mesh_compression");
    if (draco == p.extensions.end()) return result;
    const JsonValue value = json_of(draco->second);
    result.packed = GltfDraco{index_member(value, "bufferView"), {}};
    if (const JsonValue* attributes = find_member(value, "attributes"))
        for (const auto& [name, number] : attributes->members)
            result.packed->attributes[name] = index_member(*attributes, name.c_str());
    return result;
}

// Columns of 4 rows each.
Affine affine_of_columns(const std::vector<double>& m)
{
    Affine result{};
    for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 4; ++c) result[r][c] = m[4 * c + r];
    return result;
}

}  // namespace

Affine affine_of(const std::vector<double>& translation, const std::vector<double>& rotation,
                 const std::vector<double>& scale)
{
    const bool turns = rotation.size() == 4;
    const double x = turns ? rotation[0] : 0, y = turns ? rotation[1] : 0, z = turns ? rotation[2] : 0;
    const double w = turns ? rotation[3] : 1;
    const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                               {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                               {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    Affine result{};
    for (size_t r = 0; r < 3; ++r) {
        for (size_t c = 0; c < 3; ++c) result[r][c] = rows[r][c] * (scale.size() == 3 ? scale[c] : 1);
        result[r][3] = translation.size() == 3 ? translation[r] : 0;
    }
    return result;
}

namespace
{

GltfNode node_of(const tinygltf::Model& gltf, const tinygltf::Node& n)
{
    GltfNode result;
    result.name = n.name;
    result.children = n.children;
    result.mesh = n.mesh;
    result.camera = n.camera;
    result.skin = n.skin;
    result.translation = n.translation;
    result.rotation = n.rotation;
    result.scale = n.scale;
    const auto light = n.extensions.find(kLights);
    if (light != n.extensions.end() && light->second.Get("light").IsNumber())
        result.light = static_cast<int32_t>(std::clamp(light->second.Get("light").GetNumberAsDouble(), -1.0, 1e9));
    constexpr size_t kMatrixNumbers = 16;
    result.matrix =
        n.matrix.size() == kMatrixNumbers ? affine_of_columns(n.matrix) : affine_of(n.translation, n.rotation, n.scale);
    if (n.mesh < 0 || static_cast<size_t>(n.mesh) >= gltf.meshes.size()) return result;
    const tinygltf::Mesh& mesh = gltf.meshes[static_cast<size_t>(n.mesh)];
    for (const double weight : n.weights.empty() ? mesh.weights : n.weights) result.weights.push_back(float_of(weight));
    size_t targets = 0;
    for (const tinygltf::Primitive& p : mesh.primitives) targets = std::max(targets, p.targets.size());
    result.weights.resize(targets, 0);
    return result;
}

GltfAnimation animation_of(const tinygltf::Animation& a)
{
    GltfAnimation result{a.name, {}};
    for (const tinygltf::AnimationChannel& c : a.channels) {
        if (c.sampler < 0 || static_cast<size_t>(c.sampler) >= a.samplers.size()) continue;
        const tinygltf::AnimationSampler& s = a.samplers[static_cast<size_t>(c.sampler)];
        result.channels.push_back({c.target_node, s.input, s.output, c.target_path, s.interpolation});
    }
    return result;
}

GltfLight light_of(const tinygltf::Light& l)
{
    GltfLight result;
    using Type = GltfLight::Type;
    result.type = l.type == "directional" ? Type::directional : l.type == "spot" ? Type::spot : Type::point;
    result.intensity = colour_of(l.color, grey(1)) * float_of(l.intensity);
    result.inner_cone = l.spot.innerConeAngle;
    result.outer_cone = l.spot.outerConeAngle;
    return result;
}

GltfCamera camera_of(const tinygltf::Camera& c)
{
    return {c.name, c.type == "perspective" ? c.perspective.yfov : 0};
}

template <class Info>
GltfTextureUse use_of(const GltfModel& model, const Info& info)
{
    return texture_use_of(model, info.index, info.texCoord, json_of(info.extensions));
}

GltfMaterial material_of(const GltfModel& model, const tinygltf::Material& m)
{
    const tinygltf::PbrMetallicRoughness& pbr = m.pbrMetallicRoughness;
    GltfMaterial result;
    result.name = m.name;
    result.base = colour_of(pbr.baseColorFactor, grey(1));
    result.alpha = pbr.baseColorFactor.size() == 4 ? float_of(pbr.baseColorFactor[3]) : 1;
    result.cutoff = float_of(m.alphaCutoff);
    result.metalness = float_of(pbr.metallicFactor);
    result.roughness = float_of(pbr.roughnessFactor);
    result.alpha_mode = m.alphaMode == "MASK"    ? GltfAlpha::mask
                        : m.alphaMode == "BLEND" ? GltfAlpha::blend
                                                 : GltfAlpha::opaque;
    result.emission = colour_of(m.emissiveFactor, {});
    result.base_texture = use_of(model, pbr.baseColorTexture);
    result.metal_rough_texture = use_of(model, pbr.metallicRoughnessTexture);
    result.normal_texture = use_of(model, m.normalTexture);
    result.normal_texture.strength = m.normalTexture.scale;
    result.emission_texture = use_of(model, m.emissiveTexture);
    result.extensions = json_of(m.extensions);
    return result;
}

GltfImage image_of(const GltfModel& model, const tinygltf::Image& image)
{
    GltfImage result;
    constexpr size_t kMostOfUri = 60;
    result.name = !image.uri.empty() ? image.uri.substr(0, kMostOfUri) : image.name;
    result.bytes.assign(image.image.begin(), image.image.end());
    if (image.bufferView < 0) return result;
    const GltfView& view = element_of(model, model.views, image.bufferView, "buffer view");
    const std::string& buffer = element_of(model, model.buffers, view.buffer, "buffer");
    if (view.offset > buffer.size() || view.length > buffer.size() - view.offset)
        fail_gltf(model, "a picture reaches beyond the end of its buffer; export the file again");
    result.bytes = buffer.substr(view.offset, view.length);
    return result;
}

Wrap wrap_of(int mode)
{
    return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? Wrap::clamp
           : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror
                                                           : Wrap::repeat;
}

GltfTexture texture_of(const GltfModel& model, const tinygltf::Model& gltf, const tinygltf::Texture& texture)
{
    GltfTexture result;
    result.image = texture.source;
    const auto webp = texture.extensions.find("EXT_texture_webp");
    if (texture.source < 0 && webp != texture.extensions.end())
        result.image = index_member(json_of(webp->second), "source");
    else if (texture.source < 0)
        refuse_foreign_pictures(model, json_of(texture.extensions));
    if (texture.sampler >= 0 && static_cast<size_t>(texture.sampler) < gltf.samplers.size()) {
        const tinygltf::Sampler& sampler = gltf.samplers[static_cast<size_t>(texture.sampler)];
        result.wrap = {wrap_of(sampler.wrapS), wrap_of(sampler.wrapT)};
    }
    return result;
}

// Without a scene: all nodes that are nobody's child.
std::vector<int32_t> roots_of(const GltfModel& model, const tinygltf::Model& gltf)
{
    if (!gltf.scenes.empty()) return element_of(model, gltf.scenes, std::max(gltf.defaultScene, 0), "scene").nodes;
    std::vector<bool> is_child(gltf.nodes.size(), false);
    for (const tinygltf::Node& node : gltf.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<size_t>(child) < is_child.size()) is_child[static_cast<size_t>(child)] = true;
    std::vector<int32_t> roots;
    for (size_t k = 0; k < is_child.size(); ++k)
        if (!is_child[k]) roots.push_back(static_cast<int32_t>(k));
    return roots;
}

void take_geometry(const tinygltf::Model& gltf, GltfModel& model)
{
    for (const tinygltf::Buffer& buffer : gltf.buffers)
        model.buffers.emplace_back(buffer.data.begin(), buffer.data.end());
    for (const tinygltf::BufferView& view : gltf.bufferViews) model.views.push_back(view_of(view));
    for (const tinygltf::Accessor& accessor : gltf.accessors) model.accessors.push_back(accessor_of(accessor));
    for (const tinygltf::Mesh& mesh : gltf.meshes) {
        std::vector<GltfPrimitive>& primitives = model.meshes.emplace_back();
        for (const tinygltf::Primitive& p : mesh.primitives) primitives.push_back(primitive_of(p));
    }
    for (const tinygltf::Node& node : gltf.nodes) model.nodes.push_back(node_of(gltf, node));
    for (const tinygltf::Skin& s : gltf.skins) model.skins.push_back({s.name, s.joints, s.inverseBindMatrices});
    for (const tinygltf::Animation& a : gltf.animations) model.animations.push_back(animation_of(a));
    model.roots = roots_of(model, gltf);
    PackedBytes packed(model);
    unpack_meshopt(model, packed);
    unpack_draco(model, packed);
}

void take_looks(const tinygltf::Model& gltf, GltfModel& model)
{
    for (const tinygltf::Image& image : gltf.images) model.images.push_back(image_of(model, image));
    for (const tinygltf::Texture& texture : gltf.textures) model.textures.push_back(texture_of(model, gltf, texture));
    for (const tinygltf::Material& material : gltf.materials) model.materials.push_back(material_of(model, material));
    for (const tinygltf::Light& light : gltf.lights) model.lights.push_back(light_of(light));
    for (const tinygltf::Camera& camera : gltf.cameras) model.cameras.push_back(camera_of(camera));
}

// The first of tinygltf's messages, as part of a sentence.
std::string reason(const std::string& error)
{
    if (error.find("parse_error") != std::string::npos) return "its JSON is cut short or damaged";
    constexpr size_t kMost = 120;
    std::string line = error.substr(0, std::min(error.find('\n'), kMost));
    while (!line.empty() && (line.back() == '.' || line.back() == ' ')) line.pop_back();
    return line.empty() ? "damaged" : line;
}

}  // namespace

int32_t add_accessor(GltfModel& model, std::string bytes, int32_t component, uint32_t width, size_t count)
{
    model.views.push_back({static_cast<int32_t>(model.buffers.size()), 0, bytes.size(), 0});
    model.buffers.push_back(std::move(bytes));
    GltfAccessor accessor;
    accessor.run = {static_cast<int32_t>(model.views.size() - 1), 0, count, component};
    accessor.width = width;
    model.accessors.push_back(accessor);
    return static_cast<int32_t>(model.accessors.size() - 1);
}

namespace
{

// Bytes that compressed meshes may unpack to in all: so many, and so many for each byte of the file. Meshes of
// photographs take 3 to 15, and a fine grid of triangles takes 30.
constexpr uint64_t kUnpackedOfAnyFile = 256'000'000, kUnpackedOfAByte = 32;

}  // namespace

PackedBytes::PackedBytes(const GltfModel& model) : model_(model), left_(0), unpacked_left_(kUnpackedOfAnyFile)
{
    for (const std::string& buffer : model.buffers) {
        left_ += 2 * buffer.size();
        unpacked_left_ += kUnpackedOfAByte * buffer.size();
    }
}

void PackedBytes::claim(uint64_t unpacked)
{
    if (unpacked > unpacked_left_) {
        fail_gltf(model_, "its compressed meshes claim to unpack to more than " +
                              std::to_string(kUnpackedOfAnyFile / 1'000'000) + " MB and " +
                              std::to_string(kUnpackedOfAByte) +
                              " times their bytes; simplify them, or export them without compression");
    }
    unpacked_left_ -= unpacked;
}

std::string_view PackedBytes::take(int32_t index, size_t offset, size_t length)
{
    const std::string& buffer = element_of(model_, model_.buffers, index, "buffer");
    if (offset > buffer.size() || length > buffer.size() - offset)
        fail_gltf(model_, "a compressed mesh reaches beyond the end of its buffer; export the file again");
    if (length > left_) fail_gltf(model_, "its compressed meshes share their bytes; export the file again");
    left_ -= length;
    return std::string_view(buffer).substr(offset, length);
}

GltfModel read_gltf_file(const std::filesystem::path& file)
{
    GltfModel model;
    model.file = file;
    std::string bytes = read_text(file);
    check_gltf_container(file, bytes);
    bytes = plain_for_parser(bytes);
    tinygltf::TinyGLTF loader;
    FilesBeside beside{file, ""};
    loader.SetFsCallbacks(callbacks_of(beside));
    loader.SetImageLoader(keep_image, nullptr);
    tinygltf::Model gltf;
    std::string error, ignored;
    bool parsed = false;
    const unsigned int size = static_cast<unsigned int>(bytes.size());
    gltf.asset.version.clear();
    try {
        parsed = is_glb(bytes) ? loader.LoadBinaryFromMemory(&gltf, &error, &ignored,
                                                             reinterpret_cast<const unsigned char*>(bytes.data()), size)
                               : loader.LoadASCIIFromString(&gltf, &error, &ignored, bytes.data(), size, "");
    } catch (const SceneError&) {
        throw;
    } catch (const std::exception& e) {  // a value has another type than tinygltf expects
        error = e.what();
    }
    check_gltf_version(model, gltf.asset.version);
    check_required_extensions(model, gltf.extensionsRequired);
    if (!parsed && error.rfind("\"asset\"", 0) == 0)
        fail_gltf(model,
                  "it names no version, as files of glTF 1.0 may; open it in a program such as Blender and export "
                  "glTF 2.0");
    if (!parsed && !beside.missing.empty() && error.find("File not found") != std::string::npos) {
        const bool is_dotted = beside.missing.rfind("./", 0) == 0;
        const std::string name = beside.missing.substr(is_dotted ? 2 : 0, 120);
        fail_gltf(model, "its file '" + name + "' is missing; put " + name +
                             " beside it, or export it as .glb, which "
                             "holds all in one file");
    }
    if (!parsed) fail_gltf(model, "it cannot be read (" + reason(error) + "); export it again");
    take_geometry(gltf, model);
    take_looks(gltf, model);
    return model;
}

}  // namespace lumi::baker
