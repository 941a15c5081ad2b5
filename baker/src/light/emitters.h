// SPDX-License-Identifier: MIT
// All emissive triangles of a mesh as one area light; a triangle is chosen by its power. Both sides shine.
#pragma once

#include <vector>

#include "geometry/mesh.h"
#include "image/texture.h"
#include "light/light.h"
#include "material/material.h"
#include "math/distribution.h"

namespace lumi::baker
{

class Emitters : public Light
{
public:
    // Borrows all; they must outlive the light.
    Emitters(const Mesh& mesh, const std::vector<Material>& materials, const std::vector<Texture>& textures);

    size_t count() const { return triangles_.size(); }
    // Solid-angle density of reaching, from a point, the emissive triangle that lies at `distance` along `direction`.
    float pdf(uint32_t triangle, const Vec3& direction, float distance) const;

    float power() const override;
    LightSample sample(const Vec3& from, float u_select, const Vec2& u) const override;

private:
    float mean_brightness(uint32_t triangle) const;
    float brightness(uint32_t triangle) const;
    const Material& material(uint32_t triangle) const { return materials_[mesh_.materials[triangle]]; }

    const Mesh& mesh_;
    const std::vector<Material>& materials_;
    const std::vector<Texture>& textures_;
    std::vector<uint32_t> triangles_;  // ascending
    std::vector<float> brightness_;    // one a triangle
    Distribution choice_;              // by area × brightness
};

// Radiance that a triangle emits at a place on it.
Rgb emission_at(const Mesh& mesh, const Material& material, const std::vector<Texture>& textures, uint32_t triangle,
                const Vec2& barycentric);

}  // namespace lumi::baker
