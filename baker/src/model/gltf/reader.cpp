// SPDX-License-Identifier: MIT
#include "model/readers.h"

#include <algorithm>

#include "geometry/open_edges.h"
#include "model/gltf/mesh.h"
#include "model/gltf/model.h"
#include "model/gltf/pose.h"
#include "model/panes.h"

namespace lumi::baker
{
namespace
{

// A lamp of 683 lumens sends out a watt, by the convention that exporters follow: candela and lux over this number are
// intensity and irradiance, of which 1 W/(m² sr) is white.
constexpr float kLumensPerWatt = 683;

class GltfSceneReader
{
public:
    GltfSceneReader(const GltfModel& model, Losses& losses, std::vector<std::string>& warnings)
        : model_(model),
          surfaces_(surfaces_of(model, parts_.textures, losses, warnings)),
          places_(places_of_nodes(model)),
          meshes_(model, surfaces_, places_, parts_, losses),
          losses_(losses)
    {
    }

    SceneParts read()
    {
        walk();
        if (parts_.mesh.corners.empty())
            fail_gltf(model_, "the scene in it shows no triangle; export at least one mesh");
        end_parts_below();
        colour_glass();
        return std::move(parts_);
    }

private:
    struct Placed {
        int32_t node;
        int32_t part;  // the named part that the parent is, or kNoIndex
    };

    // Nodes are a forest: who comes twice would come for ever, or too often.
    void walk()
    {
        std::vector<bool> seen(model_.nodes.size(), false);
        std::vector<Placed> open;
        for (auto root = model_.roots.rbegin(); root != model_.roots.rend(); ++root) open.push_back({*root, kNoIndex});
        while (!open.empty()) {
            const Placed next = open.back();
            open.pop_back();
            const GltfNode& node = element_of(model_, model_.nodes, next.node, "node");
            if (seen[static_cast<size_t>(next.node)]) {
                fail_gltf(model_, "node " + std::to_string(next.node) +
                                      " lies below two nodes or below itself; export the file again");
            }
            seen[static_cast<size_t>(next.node)] = true;
            const Affine& place = places_[static_cast<size_t>(next.node)];
            const int32_t part = begin_part(node, place, next.part);
            if (node.mesh != kNoIndex) meshes_.add(node, place);
            parts_.named.back().end = parts_.mesh.triangle_count();
            if (node.skin != kNoIndex) parts_.named.back().bent_end = parts_.mesh.triangle_count();
            if (node.light != kNoIndex) {
                add_light(element_of(model_, model_.lights, node.light, "light"), place);
                parts_.fixture_names.resize(parts_.fixtures.size(), node.name);
            }
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
                open.push_back({*child, part});
            if (node.camera != kNoIndex)
                add_view(node, element_of(model_, model_.cameras, node.camera, "camera"), place);
        }
    }

    int32_t begin_part(const GltfNode& node, const Affine& place, int32_t parent)
    {
        const size_t triangles = parts_.mesh.triangle_count();
        parts_.named.push_back(
            {node.name, triangles, triangles, place, node.mesh != kNoIndex && node.skin != kNoIndex});
        parents_.push_back(parent);
        return static_cast<int32_t>(parts_.named.size() - 1);
    }

    // A part ends where the last one below it does: nodes come depth first, so that what lies below one stands together
    // and behind it.
    void end_parts_below()
    {
        for (size_t part = parents_.size(); part-- > 0;) {
            if (parents_[part] == kNoIndex) continue;
            size_t& end = parts_.named[static_cast<size_t>(parents_[part])].end;
            end = std::max(end, parts_.named[part].end);
        }
    }

    void add_view(const GltfNode& node, const GltfCamera& camera, const Affine& place)
    {
        constexpr double kWidest = 3.1;  // below half a turn
        if (!(camera.fov_y > 0) || camera.fov_y > kWidest) {
            losses_.add("camera(s) have no perspective and are no views; give them one");
            return;
        }
        parts_.views.push_back({node.name.empty() ? camera.name : node.name, place, camera.fov_y});
    }

    void add_light(const GltfLight& light, const Affine& place)
    {
        const Rgb power = clamped(light.intensity * (1 / kLumensPerWatt));
        const Vec3 position = {static_cast<float>(place[0][3]), static_cast<float>(place[1][3]),
                               static_cast<float>(place[2][3])};
        // It shines along the node's -z.
        const Vec3 way = {-static_cast<float>(place[0][2]), -static_cast<float>(place[1][2]),
                          -static_cast<float>(place[2][2])};
        const float size = length(way);
        const bool sound = std::isfinite(length(position)) && std::isfinite(size) && size > 0;
        if (is_black(power) || !sound) return;
        if (light.type == GltfLight::Type::point) parts_.fixtures.emplace_back(PointLight{position, power});
        if (light.type == GltfLight::Type::directional)
            parts_.fixtures.emplace_back(DirectionalLight{-way / size, power});
        if (light.type != GltfLight::Type::spot) return;
        constexpr double kWidest = 1.5707963267948966, kLeast = 1e-3;
        const double outer = std::clamp(light.outer_cone, kLeast, kWidest);
        const double inner = std::clamp(light.inner_cone, 0.0, outer - kLeast / 2);
        parts_.fixtures.emplace_back(SpotLight{position, way / size, static_cast<float>(std::cos(inner)),
                                               static_cast<float>(std::cos(outer)), power});
    }

    static Rgb clamped(const Rgb& c)
    {
        const auto sound = [](float v) { return v > 0 ? std::min(v, kMaxRadiance) : 0.0f; };
        return {sound(c.r), sound(c.g), sound(c.b)};
    }

    // Without a volume, sheets of glass are panes. A body of it gets the base colour on its way through.
    void colour_glass()
    {
        std::vector<bool> walls(parts_.materials.size());
        for (uint32_t k = 0; k < walls.size(); ++k) walls[k] = meshes_.surface(k).is_wall;
        make_panes(parts_, walls);
        const auto is_tinted = [&](uint32_t k) { return meshes_.surface(k).tinted && parts_.materials[k].glass; };
        std::vector<float> thick;
        for (uint32_t k = 0; k < parts_.materials.size(); ++k) {
            if (!is_tinted(k)) continue;
            if (thick.empty()) thick = thicknesses(parts_.mesh, parts_.materials.size());
            Material& m = parts_.materials[k];
            if (thick[k] > 0) {
                m.transmittance_length = thick[k];
            } else {
                m.tint = m.tint * m.transmittance;
                m.transmittance = grey(1);
            }
            m.finish();
        }
    }

    const GltfModel& model_;
    SceneParts parts_;
    const std::vector<GltfSurface> surfaces_;
    const std::vector<Affine> places_;  // by node
    GltfMeshBuilder meshes_;
    Losses& losses_;
    std::vector<int32_t> parents_;  // named parts have them
};

// The first animations by name, and how to draw one.
std::string about_animations(const GltfModel& model)
{
    constexpr size_t kNamed = 3;
    std::string names;
    for (size_t k = 0; k < std::min(kNamed, model.animations.size()); ++k)
        names += (k == 0 ? "" : ", ") + ("'" + model.animations[k].name.substr(0, 60) + "'");
    return "it is drawn at rest, and none of its " + std::to_string(model.animations.size()) + " animation(s) (" +
           names + (model.animations.size() > kNamed ? ", ..." : "") + ") is played; --animation NAME@SECONDS poses it";
}

}  // namespace

SceneParts read_gltf(const std::filesystem::path& file, std::vector<std::string>& warnings,
                     const std::optional<AnimationTime>& time)
{
    GltfModel model = read_gltf_file(file);
    if (time) play(model, *time);
    Losses losses;
    SceneParts parts = GltfSceneReader(model, losses, warnings).read();
    if (!time && !model.animations.empty()) parts.notes.push_back(about_animations(model));
    losses.report(file, warnings);
    return parts;
}

}  // namespace lumi::baker
