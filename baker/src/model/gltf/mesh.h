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
    // Keeps the references. Adds to the mesh, materials and textures of `parts`.
    GltfMeshBuilder(const GltfModel& model, const std::vector<GltfSurface>& surfaces, SceneParts& parts,
                    Losses& losses);

    // Throws SceneError.
    void add(int32_t mesh, const Affine& place);

    // What a material of `parts` is made of.
    const GltfSurface& surface(uint32_t material) const { return surfaces_[made_of_[material]]; }

private:
    const GltfShape& shape(int32_t mesh, size_t primitive);
    void add_primitive(const GltfPrimitive& primitive, const GltfShape& shape, const Affine& place);
    size_t surface_of(const GltfPrimitive& primitive) const;
    uint32_t material_of(size_t surface);
    uint32_t add_material(Material material, size_t surface);
    void add_vertices(const GltfShape& shape, const Affine& place);
    void paint(const GltfShape& shape, size_t surface, size_t first, const std::vector<GltfTriangle>& kept);

    const GltfModel& model_;
    const std::vector<GltfSurface>& surfaces_;
    SceneParts& parts_;
    Losses& losses_;
    std::vector<int64_t> places_;                            // of surfaces among the scene's materials, or -1
    std::vector<size_t> made_of_;                            // surfaces, of the scene's materials
    std::map<std::pair<int32_t, size_t>, GltfShape> known_;  // by mesh and primitive
    size_t triangles_ = 0, replacements_ = 0;                // as many as were placed, and read
};

}  // namespace lumi::baker
