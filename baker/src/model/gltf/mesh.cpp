// SPDX-License-Identifier: MIT
#include "model/gltf/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon.h"
#include "model/gltf/pose.h"
#include "model/vertices.h"

namespace lumi::baker
{
namespace
{

constexpr size_t kMaxTriangles = 100'000'000;
// Each brings at most three normals, three texture coordinates, and three more for its colours.
static_assert(6 * kMaxTriangles <= std::numeric_limits<int32_t>::max(), "an index of a mesh may be too large");
constexpr Mesh::OptionalCorners kNone = {kNoIndex, kNoIndex, kNoIndex};

Vec3 placed(const GltfModel& model, const Affine& place, const Vec3& p)
{
    const std::array<double, 3> q =
        point_of(place, static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
    for (const double c : q)
        if (!(std::abs(c) <= kMaxCoordinate))
            fail_gltf(model, "a node places its mesh beyond what can be drawn; check its scale and translation");
    return {static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2])};
}

Vec2 with_v_upwards(const Vec2& uv)
{
    return {uv.x, 1 - uv.y};
}

bool is_white(const Rgb& c)
{
    constexpr float kNearly = 1 - 1.0f / 512;
    return std::min({c.r, c.g, c.b}) >= kNearly;
}

Rgb mean_of(const std::vector<Rgb>& colours)
{
    Rgb sum;
    for (const Rgb& c : colours) sum = sum + c;
    return sum * (1 / static_cast<float>(colours.size()));
}

}  // namespace

GltfMeshBuilder::GltfMeshBuilder(const GltfModel& model, const std::vector<GltfSurface>& surfaces,
                                 const std::vector<Affine>& node_places, SceneParts& parts, Losses& losses)
    : model_(model),
      surfaces_(surfaces),
      node_places_(node_places),
      parts_(parts),
      losses_(losses),
      places_(surfaces.size(), -1)
{
}

void GltfMeshBuilder::add(const GltfNode& node, const Affine& place)
{
    const auto [found, fresh] = known_.try_emplace({node.mesh, node.skin, node.weights});
    if (fresh) found->second = known_of(node);
    for (Known& known : found->second) add_primitive(known, known.shape.is_bent ? kIdentity : place);
}

const std::vector<Affine>& GltfMeshBuilder::joints_of(int32_t skin)
{
    const auto [found, fresh] = joints_.try_emplace(skin);
    if (fresh) found->second = joint_matrices(model_, skin, node_places_);
    return found->second;
}

std::vector<GltfMeshBuilder::Known> GltfMeshBuilder::known_of(const GltfNode& node)
{
    std::vector<Known> list;
    size_t triangles = 0;
    for (const GltfPrimitive& primitive : element_of(model_, model_.meshes, node.mesh, "mesh")) {
        const size_t surface = surface_of(primitive);
        GltfShape shape = read(primitive, surface, node);
        triangles += shape.triangles.size();
        check_triangles(triangles);
        if (!shape.triangles.empty()) list.push_back({surface, std::move(shape), {}});
    }
    return list;
}

GltfShape GltfMeshBuilder::read(const GltfPrimitive& primitive, size_t surface, const GltfNode& node)
{
    std::vector<uint32_t> used;
    GltfShape shape = shape_of(model_, primitive, surfaces_[surface].uv_sets, losses_, used);
    morphed_ += morphed_vertices(primitive, node.weights, used.size());
    constexpr size_t kMostMorphed = 100'000'000;
    if (morphed_ > kMostMorphed)
        fail_gltf(model_, "its morph targets move more than " + std::to_string(kMostMorphed) +
                              " vertices; apply them before the export");
    morph(model_, primitive, node.weights, used, shape);
    if (node.skin != kNoIndex) shape.is_bent = bend(model_, primitive, joints_of(node.skin), used, shape);
    replacements_ += replacements_of(model_, primitive);
    if (replacements_ > kMostReplacements)
        fail_gltf(model_, "its primitives share long sparse accessors; export it without sparse accessors");
    return shape;
}

void GltfMeshBuilder::check_triangles(size_t more) const
{
    if (more > kMaxTriangles - triangles_)
        fail_gltf(model_, "it has more than " + std::to_string(kMaxTriangles) + " triangles; simplify it");
}

size_t GltfMeshBuilder::surface_of(const GltfPrimitive& primitive) const
{
    if (primitive.material == kNoIndex) return surfaces_.size() - 1;
    element_of(model_, model_.materials, primitive.material, "material");
    return static_cast<size_t>(primitive.material);
}

uint32_t GltfMeshBuilder::material_of(size_t surface)
{
    if (places_[surface] < 0) places_[surface] = add_material(surfaces_[surface].material, surface);
    return static_cast<uint32_t>(places_[surface]);
}

uint32_t GltfMeshBuilder::add_material(Material material, size_t surface)
{
    parts_.materials.push_back(std::move(material));
    made_of_.push_back(surface);
    return static_cast<uint32_t>(parts_.materials.size() - 1);
}

void GltfMeshBuilder::add_vertices(const GltfShape& shape, const Affine& place)
{
    Mesh& mesh = parts_.mesh;
    const Affine turn = cofactors(place);
    for (const Vec3& p : shape.positions) mesh.positions.push_back(placed(model_, place, p));
    const float side = determinant(place) < 0 ? -1.0f : 1.0f;
    for (const Vec3& n : shape.normals) mesh.normals.push_back(turned(turn, n) * side);
    if (!shape.second_uvs.empty()) mesh.second_uvs.resize(mesh.uvs.size());
    for (const Vec2& uv : shape.second_uvs) mesh.second_uvs.push_back(with_v_upwards(uv));
    for (const Vec2& uv : shape.uvs) mesh.uvs.push_back(with_v_upwards(uv));
}

void GltfMeshBuilder::add_primitive(Known& known, const Affine& place)
{
    const GltfShape& shape = known.shape;
    check_triangles(shape.triangles.size());
    triangles_ += shape.triangles.size();
    Mesh& mesh = parts_.mesh;
    const uint32_t position = static_cast<uint32_t>(mesh.positions.size());
    const int32_t normal = static_cast<int32_t>(mesh.normals.size()), uv = static_cast<int32_t>(mesh.uvs.size());
    Drawing drawing = {determinant(place) < 0, {}};
    add_vertices(shape, place);
    const size_t first = mesh.triangle_count();
    std::vector<GltfTriangle> kept;
    for (size_t k = 0; k < shape.triangles.size(); ++k) {
        GltfTriangle t = shape.triangles[k];
        if (drawing.first) std::swap(t[1], t[2]);
        const Mesh::Corners corners = {position + t[0], position + t[1], position + t[2]};
        if (has_no_area(mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]])) {
            drawing.second.push_back(k);
            continue;
        }
        const auto shifted = [&](int32_t by) {
            return Mesh::OptionalCorners{by + static_cast<int32_t>(t[0]), by + static_cast<int32_t>(t[1]),
                                         by + static_cast<int32_t>(t[2])};
        };
        mesh.corners.push_back(corners);
        mesh.shading.push_back(shape.normals.empty() ? kNone : shifted(normal));
        mesh.mapping.push_back(shape.uvs.empty() ? kNone : shifted(uv));
        kept.push_back(t);
    }
    losses_.add("triangle(s) have no area and are left out; merge doubled vertices", drawing.second.size());
    if (kept.empty()) return;
    const uint32_t material =
        shape.colours.empty() ? material_of(known.surface) : painted(known, std::move(drawing), first, kept);
    mesh.materials.resize(mesh.triangle_count(), material);
}

uint32_t GltfMeshBuilder::painted(Known& known, Drawing drawing, size_t first, const std::vector<GltfTriangle>& kept)
{
    const auto [found, fresh] = known.looks.try_emplace(std::move(drawing));
    Look& look = found->second;
    if (fresh) {
        look = paint(known, first, kept);
    } else if (look.has_picture) {
        std::vector<Mesh::OptionalCorners>& mapping = parts_.mesh.mapping;
        for (size_t k = 0; k < kept.size(); ++k) mapping[first + k] = mapping[look.first + k];
    }
    return look.material;
}

// Colours at vertices become a material of their own: with another base colour where they are all alike, with a
// picture where it has none yet.
GltfMeshBuilder::Look GltfMeshBuilder::paint(const Known& known, size_t first, const std::vector<GltfTriangle>& kept)
{
    const std::vector<Rgb>& colours = known.shape.colours;
    const GltfSurface& surface = surfaces_[known.surface];
    if (std::all_of(colours.begin(), colours.end(), is_white)) return {material_of(known.surface)};
    Material material = surface.material;
    const bool even = std::all_of(colours.begin(), colours.end(), [&](const Rgb& c) {
        return c.r == colours[0].r && c.g == colours[0].g && c.b == colours[0].b;
    });
    const bool has_picture = !even && surface.uv_sets.empty();
    if (has_picture) {
        std::vector<CornerColours> corners;
        for (const GltfTriangle& t : kept) corners.push_back({colours[t[0]], colours[t[1]], colours[t[2]]});
        TextureSlot& slot = is_black(material.base) ? material.maps.emission : material.maps.base;
        slot.texture = static_cast<int32_t>(parts_.textures.size());
        parts_.textures.push_back(picture_of_corners(parts_.mesh, first, corners));
    } else {
        Rgb& tinted = is_black(material.base) ? material.emission : material.base;
        tinted = tinted * mean_of(colours);
        if (!even)
            losses_.add("mesh(es) have pictures and colours at vertices, whose mean is taken; bake them together");
    }
    material.finish();
    return {add_material(std::move(material), known.surface), has_picture, first};
}

}  // namespace lumi::baker
