// SPDX-License-Identifier: MIT
// Gathers the triangles of a glTF scene, each mesh wherever a node places it.
#pragma once

#include "model/gltf/materials.h"
#include "model/gltf/shape.h"

namespace lumi::baker
{

class GltfMeshBuilder
{
public:
    // Keeps the references. Adds to the mesh, materials and textures of `parts`. `node_places`: places_of_nodes.
    GltfMeshBuilder(const GltfModel& model, const std::vector<GltfSurface>& surfaces,
                    const std::vector<Affine>& node_places, SceneParts& parts, Losses& losses);

    // Adds the mesh of a node at its place, morphed by its weights and bent by its skin. Throws SceneError.
    void add(const GltfNode& node, const Affine& place);

    // The surface that a material of `parts` is made of.
    const GltfSurface& surface(uint32_t material) const { return surfaces_[made_of_[material]]; }

private:
    // A way to draw a primitive: mirrored or not, and without which of its triangles, as those have no area there.
    using Drawing = std::pair<bool, std::vector<size_t>>;
    // Which material that has. Drawings that are alike share a picture of colours at vertices, and so the places in it
    // of the triangles from `first` on.
    struct Look {
        uint32_t material = 0;
        bool has_picture = false;
        size_t first = 0;
    };
    struct Known {
        size_t surface;
        GltfShape shape;                // it has at least one triangle
        std::map<Drawing, Look> looks;  // where it has colours at vertices
    };

    std::vector<Known> known_of(const GltfNode& node);
    const std::vector<Affine>& joints_of(int32_t skin);
    GltfShape read(const GltfPrimitive& primitive, size_t surface, const GltfNode& node);
    void check_triangles(size_t more) const;
    void add_primitive(Known& known, const Affine& place);
    size_t surface_of(const GltfPrimitive& primitive) const;
    uint32_t material_of(size_t surface);
    uint32_t add_material(Material material, size_t surface);
    void add_vertices(const GltfShape& shape, const Affine& place);
    uint32_t painted(Known& known, Drawing drawing, size_t first, const std::vector<GltfTriangle>& kept);
    Look paint(const Known& known, size_t first, const std::vector<GltfTriangle>& kept);

    const GltfModel& model_;
    const std::vector<GltfSurface>& surfaces_;
    const std::vector<Affine>& node_places_;
    SceneParts& parts_;
    Losses& losses_;
    std::vector<int64_t> places_;  // where surfaces stand among the scene's materials, or -1
    std::vector<size_t> made_of_;  // surfaces, of the scene's materials
    // By mesh, skin and weights.
    std::map<std::tuple<int32_t, int32_t, std::vector<float>>, std::vector<Known>> known_;
    std::map<int32_t, std::vector<Affine>> joints_;          // by skin
    size_t triangles_ = 0, replacements_ = 0, morphed_ = 0;  // as many as were placed, read, and moved
};

}  // namespace lumi::baker
